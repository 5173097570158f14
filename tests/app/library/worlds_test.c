/* SPDX-License-Identifier: GPL-3.0-or-later
 * Worlds: one by one, many at once, placed, pushed and drawn. */
#include "check.h"

enum { kWorlds = 7, kVariables = 3, kTerms = 8, kSteps = 3000 };

/* An action that depends on world and step alone. */
static int64_t action_of(int world, int step) {
  return (world * 31 + step * 17 + step / 7) % 3;
}

/* Many worlds do what each of them does alone. */
static void many_are_as_one(surefoot_again again) {
  surefoot_worlds *worlds;
  DONE(surefoot_worlds_make("{\"environment\": \"pendulum\"}", kWorlds, again, &worlds));
  surefoot_environment *alone[kWorlds];
  double states[kWorlds * kVariables], last[kWorlds * kVariables], rewards[kWorlds], one[kVariables];
  uint8_t terminated[kWorlds], truncated[kWorlds], falls[kWorlds], before[kWorlds] = {0};
  int64_t actions[kWorlds];
  uint64_t seeds[kWorlds];
  int ended = 0;
  for (int i = 0; i < kWorlds; ++i) {
    seeds[i] = 100 + (uint64_t)i;
    DONE(surefoot_environment_make("{\"environment\": \"pendulum\"}", &alone[i]));
    DONE(surefoot_environment_reset(alone[i], &seeds[i], NULL));
  }
  const surefoot_batch batch = {.states = states,
                                .rewards = rewards,
                                .terminated = terminated,
                                .truncated = truncated,
                                .falls = falls,
                                .last_states = last};
  DONE(surefoot_worlds_reset(worlds, seeds, NULL, states));
  for (int step = 0; step < kSteps; ++step) {
    for (int i = 0; i < kWorlds; ++i) actions[i] = action_of(i, step);
    DONE(surefoot_worlds_step(worlds, actions, &batch));
    for (int i = 0; i < kWorlds; ++i) {
      surefoot_outcome outcome = {0};
      if (before[i]) {
        DONE(surefoot_environment_reset(alone[i], NULL, one));
        before[i] = 0;
        CHECK(rewards[i] == 0 && !terminated[i] && !truncated[i]);
      } else {
        DONE(surefoot_environment_step(alone[i], actions[i], &outcome, one, NULL));
        CHECK(outcome.reward == rewards[i] && outcome.terminated == terminated[i] && outcome.fall == falls[i]);
        CHECK(outcome.truncated == truncated[i] && !(outcome.terminated && outcome.truncated));
        CHECK(memcmp(one, last + i * kVariables, sizeof one) == 0);
        if (outcome.terminated || outcome.truncated) {
          ++ended;
          if (again == SUREFOOT_AGAIN_NEXT_STEP) before[i] = 1;
          if (again == SUREFOOT_AGAIN_AT_ONCE) DONE(surefoot_environment_reset(alone[i], NULL, one));
        }
      }
      CHECK(memcmp(one, states + i * kVariables, sizeof one) == 0);
    }
  }
  CHECK(ended > kWorlds);
  for (int i = 0; i < kWorlds; ++i) surefoot_environment_close(alone[i]);
  surefoot_worlds_close(worlds);
}

/* The same seed, the same episode; reward terms add up to the reward. */
static void seeds_and_terms(void) {
  surefoot_environment *world;
  DONE(surefoot_environment_make("{\"environment\": \"pendulum\", \"scenario\": \"2\"}", &world));
  double first[kVariables], again[kVariables], terms[kTerms];
  const uint64_t seed = 77;
  surefoot_outcome outcome;
  DONE(surefoot_environment_reset(world, &seed, first));
  for (int step = 0; step < 5; ++step) {
    DONE(surefoot_environment_step(world, 2, &outcome, first, terms));
    double sum = 0;
    const char *about;
    DONE(surefoot_environment_about(world, &about));
    const char *list = strstr(about, "\"reward_terms\":[");
    CHECK(list != NULL);
    int count = 1;
    for (const char *c = list; *c != ']'; ++c) count += *c == ',';
    for (int i = 0; i < count; ++i) sum += terms[i];
    CHECK(sum == outcome.reward);
  }
  DONE(surefoot_environment_reset(world, &seed, again));
  for (int step = 0; step < 5; ++step) DONE(surefoot_environment_step(world, 2, &outcome, again, NULL));
  CHECK(memcmp(first, again, sizeof first) == 0);
  surefoot_environment_close(world);
}

static void placed_and_pushed(void) {
  surefoot_environment *world;
  DONE(surefoot_environment_make(NULL, &world));
  const double upright[kVariables] = {0.1, 0, 0};
  double state[kVariables];
  surefoot_outcome outcome;
  DONE(surefoot_environment_place(world, upright, kVariables));
  DONE(surefoot_environment_state(world, state, kVariables));
  for (int i = 0; i < kVariables; ++i) CHECK(state[i] > upright[i] - 1e-6 && state[i] < upright[i] + 1e-6);
  DONE(surefoot_environment_push(world, 0.01));
  DONE(surefoot_environment_step(world, 1, &outcome, state, NULL));
  const double far[kVariables] = {100, 0, 0};
  REFUSED(surefoot_environment_place(world, far, kVariables), SUREFOOT_USAGE, "out of range");
  REFUSED(surefoot_environment_push(world, 1e9), SUREFOOT_USAGE, "1000");
  surefoot_environment_close(world);
}

/* A picture has more than one colour, and turns with the pole. */
static void pictures(void) {
  enum { kWidth = 64, kHeight = 48, kBytes = kWidth * kHeight * 3 };
  surefoot_environment *world;
  DONE(surefoot_environment_make(NULL, &world));
  uint8_t left[kBytes], right[kBytes];
  const double leans[2][kVariables] = {{-0.8, 0, 0}, {0.8, 0, 0}};
  DONE(surefoot_environment_place(world, leans[0], kVariables));
  DONE(surefoot_environment_render(world, kWidth, kHeight, left, kBytes));
  DONE(surefoot_environment_place(world, leans[1], kVariables));
  DONE(surefoot_environment_render(world, kWidth, kHeight, right, kBytes));
  CHECK(memcmp(left, right, kBytes) != 0);
  int dark = 0;
  for (int i = 0; i < kBytes; i += 3) dark += left[i] < 64;
  CHECK(dark > 20 && dark < kWidth * kHeight / 2);
  const char *shapes;
  DONE(surefoot_environment_draw(world, &shapes));
  CHECK(strstr(shapes, "\"shape\":\"polygon\"") != NULL);
  REFUSED(surefoot_environment_render(world, 1, 1, left, 3), SUREFOOT_USAGE, "pixels");
  surefoot_environment_close(world);
}

int main(void) {
  CHECK(surefoot_api() == SUREFOOT_API);
  many_are_as_one(SUREFOOT_AGAIN_NEXT_STEP);
  many_are_as_one(SUREFOOT_AGAIN_AT_ONCE);
  seeds_and_terms();
  placed_and_pushed();
  pictures();
  return 0;
}
