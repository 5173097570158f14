/* SPDX-License-Identifier: GPL-3.0-or-later
 * Wrong arguments, wrong moments, two threads: a status and a sentence, and nothing has changed. */
#include <math.h>
#include <pthread.h>

#include "check.h"

static void descriptions(void) {
  const struct {
    const char *text, *words;
  } wrong[] = {{"", "JSON"},
               {"[1, 2]", "JSON object"},
               {"{\"environmnt\": \"pendulum\"}", "environment"},
               {"{\"environment\": \"pendulm\"}", "pendulum"},
               {"{\"environment\": 3}", "text"},
               {"{\"parameters\": 4}", "parameters"},
               {"{\"parameters\": {\"environment.pole_length\": -1}}", "pole_length"},
               {"{\"parameters\": {\"environment.pole_length\": [1]}}", "number"},
               {"{\"parameters\": {\"agent.step_size\": 0.1}}", "environment."},
               {"{\"scenario\": \"no\"}", "scenario"},
               {"{\"environment\": \"/no/robot.toml\"}", "robot.toml"},
               {"\xff\xfe", "JSON"}};
  for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; ++i) {
    surefoot_environment *world = (surefoot_environment *)&world;
    const surefoot_status status = surefoot_environment_make(wrong[i].text, &world);
    CHECK(status == SUREFOOT_USAGE || status == SUREFOOT_FILE);
    CHECK(world == NULL);
    CHECK(strstr(surefoot_last_error(), wrong[i].words) != NULL);
  }
  surefoot_life *life;
  REFUSED(surefoot_life_make("{\"policy\": \"greedy\", \"parameters\": {\"policy.epsilon\": 0.1}}", NULL, NULL, &life),
          SUREFOOT_USAGE, "policy.epsilon");
  REFUSED(surefoot_life_make("{\"seed\": -1}", NULL, NULL, &life), SUREFOOT_USAGE, "seed");
  REFUSED(surefoot_life_make("{\"load\": \"/no/file\"}", NULL, NULL, &life), SUREFOOT_FILE, "/no/file");
}

/* What comes with the program is found from the library, too. */
static void shelf(void) {
  surefoot_environment *world;
  const char *about;
  DONE(surefoot_environment_make("{\"environment\": \"cart-pole\"}", &world));
  DONE(surefoot_environment_about(world, &about));
  CHECK(strstr(about, "cart-pole@") != NULL);
  surefoot_environment_close(world);
  REFUSED(surefoot_experiment("no-plan", "{\"out\": \"x\"}", NULL, NULL, NULL), SUREFOOT_FILE, "plans are");
  DONE(surefoot_list(&about));
  CHECK(strstr(about, "\"mellowmax\"") != NULL && strstr(about, "\"hopper\"") != NULL);
}

static void moments(void) {
  surefoot_environment *world;
  DONE(surefoot_environment_make(NULL, &world));
  surefoot_outcome outcome;
  double state[3];
  REFUSED(surefoot_environment_step(world, 0, &outcome, NULL, NULL), SUREFOOT_USAGE, "reset");
  DONE(surefoot_environment_reset(world, NULL, NULL));
  REFUSED(surefoot_environment_step(world, 5, &outcome, NULL, NULL), SUREFOOT_USAGE, "from 0 to 4");
  REFUSED(surefoot_environment_step(world, -1, &outcome, NULL, NULL), SUREFOOT_USAGE, "from 0 to 4");
  REFUSED(surefoot_environment_step(world, 0, NULL, NULL, NULL), SUREFOOT_USAGE, "NULL");
  REFUSED(surefoot_environment_state(world, state, 2), SUREFOOT_USAGE, "3 numbers");
  REFUSED(surefoot_environment_state(world, NULL, 3), SUREFOOT_USAGE, "NULL");
  REFUSED(surefoot_environment_push(world, NAN), SUREFOOT_USAGE, "push");
  REFUSED(surefoot_environment_set(world, "environment.pole_length", "tall"), SUREFOOT_USAGE, "tall");
  REFUSED(surefoot_environment_set(world, NULL, "1"), SUREFOOT_USAGE, "NULL");
  REFUSED(surefoot_environment_about(NULL, NULL), SUREFOOT_USAGE, "NULL");
  DONE(surefoot_environment_set(world, "environment.pole_length", "0.2"));
  while (surefoot_environment_step(world, 0, &outcome, NULL, NULL) == SUREFOOT_DONE)
    if (outcome.terminated || outcome.truncated) break;
  REFUSED(surefoot_environment_step(world, 0, &outcome, NULL, NULL), SUREFOOT_USAGE, "over");
  DONE(surefoot_environment_reset(world, NULL, state));
  CHECK(strcmp(surefoot_last_error(), "") == 0);
  DONE(surefoot_environment_close(world));
  DONE(surefoot_environment_close(NULL));

  surefoot_worlds *worlds;
  REFUSED(surefoot_worlds_make(NULL, 0, SUREFOOT_AGAIN_AT_ONCE, &worlds), SUREFOOT_USAGE, "from 1");
  REFUSED(surefoot_worlds_make(NULL, 1, 9, &worlds), SUREFOOT_USAGE, "from 0 to 2");
  DONE(surefoot_worlds_make(NULL, 2, SUREFOOT_AGAIN_AT_ONCE, &worlds));
  const int64_t actions[2] = {0, 7};
  double states[6];
  const surefoot_batch batch = {.states = states};
  REFUSED(surefoot_worlds_step(worlds, actions, &batch), SUREFOOT_USAGE, "reset");
  DONE(surefoot_worlds_reset(worlds, NULL, NULL, states));
  REFUSED(surefoot_worlds_step(worlds, actions, &batch), SUREFOOT_USAGE, "world 1");
  surefoot_worlds_close(worlds);
}

static void lives(void) {
  surefoot_life *life;
  DONE(surefoot_life_make(NULL, NULL, NULL, &life));
  int32_t reached;
  const surefoot_extent none = {0}, backwards = {.steps = -1}, forever = {.minutes = NAN};
  REFUSED(surefoot_life_run(life, &none, &reached), SUREFOOT_USAGE, "limit");
  REFUSED(surefoot_life_run(life, &backwards, &reached), SUREFOOT_USAGE, "extent");
  REFUSED(surefoot_life_run(life, &forever, &reached), SUREFOOT_USAGE, "extent");
  const double nan[3] = {0, NAN, 0};
  double q[5];
  REFUSED(surefoot_life_values(life, SUREFOOT_LAYER_SUM, nan, 1, q, 5), SUREFOOT_USAGE, "finite");
  REFUSED(surefoot_life_values(life, SUREFOOT_LAYER_SUM, nan, 1, q, 2), SUREFOOT_USAGE, "5 numbers");
  REFUSED(surefoot_life_values(life, 8, nan, 1, q, 5), SUREFOOT_USAGE, "layer");
  REFUSED(surefoot_life_set(life, "features.pole_angle", "10"), SUREFOOT_USAGE, "new table");
  REFUSED(surefoot_life_set(life, "policy.epsilon", "2"), SUREFOOT_USAGE, "policy.epsilon");
  DONE(surefoot_life_set(life, "policy.epsilon", "0.2"));
  REFUSED(surefoot_life_follow(life, "boldest"), SUREFOOT_USAGE, "boldest");
  REFUSED(surefoot_life_checkpoint(life, "/no/folder/file"), SUREFOOT_FILE, "/no/folder");
  surefoot_life_close(life);
}

static volatile int running_ = 1;
static void *live_on(void *life) {
  const surefoot_extent extent = {.steps = 2000000};
  int32_t reached;
  surefoot_status status;
  do status = surefoot_life_run(life, &extent, &reached);
  while (status == SUREFOOT_BUSY); /* the other thread was inside when this one began */
  CHECK(status == SUREFOOT_DONE);
  running_ = 0;
  return NULL;
}

/* A second thread is turned away, and the first one's life is not disturbed. */
static void two_threads(void) {
  surefoot_life *life, *alone;
  uint64_t hash, undisturbed;
  DONE(surefoot_life_make(NULL, NULL, NULL, &life));
  DONE(surefoot_life_make(NULL, NULL, NULL, &alone));
  pthread_t thread;
  CHECK(pthread_create(&thread, NULL, live_on, life) == 0);
  int busy = 0;
  while (running_ && busy < 1000)
    if (surefoot_life_hash(life, &hash) == SUREFOOT_BUSY) {
      ++busy;
      CHECK(strstr(surefoot_last_error(), "thread") != NULL);
    }
  pthread_join(thread, NULL);
  CHECK(busy > 0);
  DONE(surefoot_life_hash(life, &hash));
  running_ = 1;
  live_on(alone);
  DONE(surefoot_life_hash(alone, &undisturbed));
  CHECK(hash == undisturbed);
  surefoot_life_close(life);
  surefoot_life_close(alone);
}

int main(void) {
  descriptions();
  shelf();
  moments();
  lives();
  two_threads();
  return 0;
}
