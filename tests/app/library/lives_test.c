/* SPDX-License-Identifier: GPL-3.0-or-later
 * Lives: files, own worlds, own policies, results of experiments. The folder to write to is the argument. */
#include <inttypes.h>
#include <math.h>
#include <unistd.h>

#include "check.h"

static char path_[512];
static const char *file_in(const char *folder, const char *name) {
  snprintf(path_, sizeof path_, "%s/%s", folder, name);
  unlink(path_);
  return path_;
}

static uint64_t hash_of(surefoot_life *life) {
  uint64_t hash;
  DONE(surefoot_life_hash(life, &hash));
  return hash;
}

static void run(surefoot_life *life, int64_t episodes) {
  const surefoot_extent extent = {.episodes = episodes};
  int32_t reached = 0;
  DONE(surefoot_life_run(life, &extent, &reached));
  CHECK(reached);
}

/* A life that was kept in a file goes on with the same bits. */
static void checkpoints(const char *folder) {
  surefoot_life *whole, *first, *second;
  const char *about = "{\"seed\": 5, \"policy\": \"softmax\", \"parameters\": {\"policy.temperature\": 2}}";
  DONE(surefoot_life_make(about, NULL, NULL, &whole));
  DONE(surefoot_life_make(about, NULL, NULL, &first));
  run(whole, 120);
  run(first, 50);
  surefoot_extent some_steps = {.patience = 0};
  surefoot_totals totals;
  DONE(surefoot_life_totals(first, &totals));
  some_steps.steps = totals.steps + 13; /* in the middle of an episode */
  int32_t reached;
  DONE(surefoot_life_run(first, &some_steps, &reached));
  const char *file = file_in(folder, "life.surefoot");
  DONE(surefoot_life_checkpoint(first, file));
  char json[600];
  snprintf(json, sizeof json, "{\"resume\": \"%s\"}", file);
  DONE(surefoot_life_make(json, NULL, NULL, &second));
  CHECK(hash_of(first) == hash_of(second));
  run(second, 120);
  CHECK(hash_of(whole) == hash_of(second));
  size_t there;
  surefoot_episode rows[200];
  DONE(surefoot_life_episodes(second, 0, rows, 200, &there));
  CHECK(there == 120 && rows[119].episode == 120 && rows[119].steps >= rows[118].steps + rows[119].transitions);
  surefoot_life_close(whole);
  surefoot_life_close(first);
  surefoot_life_close(second);
}

/* What was learned, from the life and from its file. */
static void learned(const char *folder) {
  surefoot_life *life;
  surefoot_q_function *q;
  DONE(surefoot_life_make("{\"agent\": \"sarsa-2q\"}", NULL, NULL, &life));
  run(life, 60);
  const char *file = file_in(folder, "q.safetensors");
  DONE(surefoot_life_save(life, file));
  REFUSED(surefoot_life_save(life, file), SUREFOOT_FILE, "exists");
  DONE(surefoot_q_function_open(file, &q));
  const double states[2 * 3] = {0.1, 0, 0, -0.2, 0.5, 0};
  double a[10], b[10], sum[10], pi[10], visits[2]; /* of five actions */
  for (int layer = SUREFOOT_LAYER_SUM; layer <= SUREFOOT_LAYER_NEGATIVE; ++layer) {
    DONE(surefoot_life_values(life, layer, states, 2, a, 10));
    DONE(surefoot_q_function_values(q, layer, states, 2, b, 10));
    CHECK(memcmp(a, b, sizeof a) == 0);
    for (int i = 0; i < 10; ++i) sum[i] = layer == SUREFOOT_LAYER_SUM ? a[i] : sum[i] - a[i];
  }
  for (int i = 0; i < 10; ++i) CHECK(fabs(sum[i]) < 1e-9); /* Q = Q+ + Q- */
  REFUSED(surefoot_life_values(life, SUREFOOT_LAYER_RISK, states, 2, a, 10), SUREFOOT_USAGE, "risk");
  DONE(surefoot_q_function_follow(q, "epsilon-greedy", "{\"policy.epsilon\": 0.3}"));
  DONE(surefoot_q_function_probabilities(q, states, 2, pi, 10));
  for (int s = 0; s < 2; ++s) {
    double best = -INFINITY;
    int at = 0, ties = 0;
    for (int i = 0; i < 5; ++i)
      if (pi[5 * s + i] > best) best = pi[5 * s + i], at = i;
    for (int i = 0; i < 5; ++i) ties += i != at && pi[5 * s + i] == best;
    if (ties == 0) CHECK(fabs(best - 0.76) < 1e-12); /* 1 - 0.3 + 0.3 / 5 */
  }
  DONE(surefoot_life_visits(life, states, 2, visits, 2));
  CHECK(visits[0] >= 0);
  REFUSED(surefoot_q_function_follow(q, "softmx", NULL), SUREFOOT_USAGE, "softmax");
  surefoot_q_function_close(q);
  surefoot_life_close(life);
}

/* A corridor of five places: to the right is the goal, to the left a fall. */
struct corridor {
  int place, begun, fails_at, steps;
};
static int corridor_reset(void *user, uint64_t seed, double *state) {
  struct corridor *c = user;
  (void)seed;
  c->place = 2;
  ++c->begun;
  state[0] = c->place;
  return 0;
}
static int corridor_step(void *user, int64_t action, double *state, double *terms, surefoot_outcome *outcome) {
  struct corridor *c = user;
  if (++c->steps == c->fails_at) return 1;
  c->place += action == 1 ? 1 : -1;
  state[0] = c->place;
  terms[0] = c->place == 4 ? 1 : c->place == 0 ? -1 : 0;
  outcome->terminated = c->place == 4 || c->place == 0;
  outcome->fall = c->place == 0;
  outcome->success = c->place == 4;
  return 0;
}
static int always_right(void *user, const double *q, size_t actions, double *pi) {
  (void)q;
  ++*(int *)user;
  for (size_t i = 0; i < actions; ++i) pi[i] = i == 1 ? 3 : 0; /* is divided by its sum */
  return 0;
}
static int no_policy(void *user, const double *q, size_t actions, double *pi) {
  (void)user, (void)q, (void)actions, (void)pi;
  return 1;
}

static void own_parts(const char *folder) {
  struct corridor c = {0};
  surefoot_world world = {.task =
                              "{\"state\": [{\"key\": \"place\", \"low\": 0, \"high\": 4, \"whole\": true}],"
                              " \"actions\": [\"left\", \"right\"], \"goal_reward\": 1}",
                          .user = &c,
                          .reset = corridor_reset,
                          .step = corridor_step};
  const char *table = "{\"features\": \"table\", \"parameters\": {\"agent.step_size\": 0.5}}";
  surefoot_life *life;
  DONE(surefoot_life_make(table, &world, NULL, &life));
  CHECK(c.begun == 0); /* its functions are called while it runs, not before */
  run(life, 300);
  double q[2], middle = 3;
  DONE(surefoot_life_values(life, SUREFOOT_LAYER_SUM, &middle, 1, q, 2));
  CHECK(q[1] > 0.9 && q[1] > q[0]); /* one step before the goal: 1 */
  surefoot_totals totals;
  DONE(surefoot_life_totals(life, &totals));
  CHECK(totals.successes > 200 && totals.falls + totals.successes == totals.episodes);

  /* A world that fails: the life stands, and goes on when it answers again. */
  c.fails_at = c.steps + 7;
  const surefoot_extent on = {.episodes = 400};
  int32_t reached;
  REFUSED(surefoot_life_run(life, &on, &reached), SUREFOOT_UNANSWERED, "step");
  DONE(surefoot_life_run(life, &on, &reached));
  CHECK(reached);

  /* Kept in a file, it goes on in the same world. */
  char json[600];
  const char *file = file_in(folder, "own.surefoot");
  surefoot_life *again;
  DONE(surefoot_life_checkpoint(life, file));
  snprintf(json, sizeof json, "{\"resume\": \"%s\"}", file);
  REFUSED(surefoot_life_make(json, NULL, NULL, &again), SUREFOOT_FILE, "own");
  DONE(surefoot_life_make(json, &world, NULL, &again));
  run(again, 410);
  run(life, 410);
  CHECK(hash_of(again) == hash_of(life));
  surefoot_life_close(again);
  surefoot_life_close(life);

  int asked = 0;
  surefoot_policy right = {.user = &asked, .probabilities = always_right};
  DONE(surefoot_life_make(table, &world, &right, &life));
  run(life, 50);
  DONE(surefoot_life_totals(life, &totals));
  CHECK(totals.falls == 0 && totals.successes == 50 && totals.steps == 100 && asked >= 100);
  surefoot_life_close(life);
  surefoot_policy none = {.user = NULL, .probabilities = no_policy};
  DONE(surefoot_life_make(table, &world, &none, &life));
  REFUSED(surefoot_life_run(life, &on, &reached), SUREFOOT_UNANSWERED, "policy");
  surefoot_life_close(life);
  world.task = "{\"state\": [], \"actions\": [1]}";
  REFUSED(surefoot_life_make(table, &world, NULL, &life), SUREFOOT_USAGE, "state");
  CHECK(life == NULL);
}

static int told_;
static int stop_at_once(void *user, const surefoot_progress *progress) {
  (void)user;
  ++told_;
  CHECK(progress->share >= 0 && progress->share <= 1 && progress->lives <= progress->of);
  return 1;
}

static void experiments(const char *folder) {
  const char *plan =
      "title = \"two policies\"\nlives = 4\nreference = \"greedy\"\n"
      "[base]\nenvironment = \"pendulum\"\nepisodes = 30\n"
      "[[condition]]\nname = \"greedy\"\npolicy = \"greedy\"\n"
      "[[condition]]\nname = \"softmax\"\npolicy = \"softmax\"\n";
  char options[600];
  const char *file = file_in(folder, "results.sqlite"), *json;
  snprintf(options, sizeof options, "{\"out\": \"%s\", \"jobs\": 2, \"seed\": 9}", file);
  DONE(surefoot_experiment(plan, options, NULL, NULL, &json));
  CHECK(strstr(json, "\"complete\":true") != NULL && strstr(json, "\"lives\":8") != NULL);
  surefoot_store *store;
  DONE(surefoot_store_open(file, &store));
  DONE(surefoot_store_about(store, &json));
  CHECK(strstr(json, "\"name\":\"softmax\"") != NULL);
  DONE(surefoot_store_statistics(store, &json));
  CHECK(strstr(json, "\"conditions\"") != NULL);
  surefoot_episode rows[30];
  size_t there;
  DONE(surefoot_store_episodes(store, 1, 3, 0, rows, 30, &there));
  CHECK(there == 30 && rows[29].episode == 30 && rows[0].steps == rows[0].transitions);
  REFUSED(surefoot_store_episodes(store, 2, 0, 0, rows, 30, &there), SUREFOOT_USAGE, "no such life");
  surefoot_store_close(store);
  REFUSED(surefoot_experiment(plan, options, NULL, NULL, NULL), SUREFOOT_FILE, "exists");

  snprintf(options, sizeof options, "{\"out\": \"%s\", \"jobs\": 1, \"lives\": 2000}", file_in(folder, "long.sqlite"));
  REFUSED(surefoot_experiment(plan, options, stop_at_once, NULL, NULL), SUREFOOT_INTERRUPTED, "resume");
  CHECK(told_ > 0);
}

int main(int argc, char **argv) {
  CHECK(argc == 2);
  checkpoints(argv[1]);
  learned(argv[1]);
  own_parts(argv[1]);
  experiments(argv[1]);
  return 0;
}
