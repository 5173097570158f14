/* SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Surefoot from C and from every language that can call C: worlds in which robots fall, learners, experiments and
 * their statistics. It is the program's own code: a life has the same bits, and the same hash, as `surefoot train`
 * gives.
 *
 * Rules that hold for every call
 *
 *   - It returns a status. SUREFOOT_DONE is 0; anything else is an error, and surefoot_last_error() has a sentence that
 *     names the thing, the value and what is allowed. The numbers are the exit codes of the program.
 *   - A call that fails has changed nothing, unless it says otherwise.
 *   - What is made by …_make or …_open is given back by …_close. NULL may be closed.
 *   - A handle is used by one thread at a time; different handles by any threads. A call finds out if another thread is
 *     inside the same handle, and returns SUREFOOT_BUSY. A handle that was closed must not be used again.
 *   - A text that is handed out (const char **) belongs to the handle and is valid until the next call with it.
 *     All texts are UTF-8, all descriptions JSON. File names are as the system has them.
 *   - Arrays come with their number of elements, which must be exactly what is needed; matrices are row by row.
 *   - Numbers from outside must be finite. Units are those of the description (…_about): SI.
 *
 * The library turns off, for this process, the profiling clock inside Debian's libbox2d.so.2 and gives it sine and
 * cosine functions of its own: without them a fall would have other bits on other processors.
 */
#ifndef SUREFOOT_H
#define SUREFOOT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define SUREFOOT_CALL __attribute__((visibility("default"))) __attribute__((warn_unused_result))
#define SUREFOOT_PLAIN __attribute__((visibility("default")))
#else
#define SUREFOOT_CALL
#define SUREFOOT_PLAIN
#endif

typedef enum surefoot_status {
  SUREFOOT_DONE = 0,
  SUREFOOT_USAGE = 2,      /* an argument is wrong */
  SUREFOOT_FILE = 3,       /* a file cannot be read or written, or is damaged */
  SUREFOOT_DIVERGED = 4,   /* the learned values left every sensible range; the life is over */
  SUREFOOT_MISMATCH = 5,   /* of another version or another task */
  SUREFOOT_UNANSWERED = 6, /* a world in another process, or of the caller, did not answer; can be tried again */
  SUREFOOT_BUSY = 7,       /* another thread is inside this handle */
  SUREFOOT_INTERNAL = 8,   /* no memory, or a fault of the library */
  SUREFOOT_INTERRUPTED = 130
} surefoot_status;

/* 1: the calls of this header. A library with another number has other ones. */
#define SUREFOOT_API 1
SUREFOOT_PLAIN unsigned surefoot_api(void);
/* "1.0.0" */
SUREFOOT_PLAIN const char *surefoot_version(void);
/* Why the last call of this thread failed; empty: it did not. Valid until this thread's next call. Never NULL. */
SUREFOOT_PLAIN const char *surefoot_last_error(void);

/* Everything that can be chosen by name, with every parameter, as `surefoot list --json` prints it. The text belongs to
 * the calling thread and is valid until its next surefoot_list(). */
SUREFOOT_CALL surefoot_status surefoot_list(const char **json);

/* ---- Environments ------------------------------------------------------------------------------------------------ */

/* A world with a task. */
typedef struct surefoot_environment surefoot_environment;

typedef struct surefoot_outcome {
  double reward;      /* the sum of the reward terms */
  int32_t terminated; /* the episode is over, and what comes after it is worth nothing */
  int32_t truncated;  /* a time limit cut it off; never together with `terminated` */
  int32_t fall;       /* this step was a fall */
  int32_t success;    /* this step reached the goal */
} surefoot_outcome;

/* `description`: {"environment": NAME, "preset": NAME, "scenario": NAME, "parameters": {KEY: number or name}}. All may
 * be left out; the environment may be the file of a robot. A robot that is moved by a program starts it only with
 * "programs": true, which allows this program (its command and its files) for the rest of the process. */
SUREFOOT_CALL surefoot_status surefoot_environment_make(const char *description, surefoot_environment **environment);
SUREFOOT_PLAIN surefoot_status surefoot_environment_close(surefoot_environment *environment);
/* {"environment", "preset", "scenario", "parameters": {…},
 *  "state": [{"key", "title", "symbol", "unit", "low", "high", "period", "whole", "resolution" (tiles per span, usual),
 *             "span"}, …],
 *  "actions": [[physical values of action 0, one a variable], …], "action_names": […],
 *  "action_variables": [{"key", "title", "unit", "levels"}, …],
 *  "reward_terms": […], "measures": [{"key", "title", "unit"}, …], "signals": [{"key", "title", "symbol", "unit",
 *  "group", "kind"}, …], "step_time": s or null, "goal_reward": number or null, "can_fall", "can_push", "hand_made"}.
 * Features cover `low` … `high`; a state may lie outside. */
SUREFOOT_CALL surefoot_status surefoot_environment_about(surefoot_environment *environment, const char **json);
/* Sets a parameter of the environment, as text ("0.5", or the name of a choice). It holds from the next reset on. */
SUREFOOT_CALL surefoot_status surefoot_environment_set(surefoot_environment *environment, const char *key,
                                                       const char *value);
/* Begins an episode in a state that is drawn at random. `seed`: the random numbers begin anew from it; NULL: they go on
 * (they began with seed 1). state[state variables] ← where it begins; may be NULL. */
SUREFOOT_CALL surefoot_status surefoot_environment_reset(surefoot_environment *environment, const uint64_t *seed,
                                                         double *state);
/* One decision. An episode must have begun and not be over. `action`: 0 … actions − 1. state[state variables] ← where
 * it led to, reward_terms[reward terms] ← their values; both may be NULL. */
SUREFOOT_CALL surefoot_status surefoot_environment_step(surefoot_environment *environment, int64_t action,
                                                        surefoot_outcome *outcome, double *state, double *reward_terms);
/* values ← the state now. */
SUREFOOT_CALL surefoot_status surefoot_environment_state(surefoot_environment *environment, double *values,
                                                         size_t count);
/* values ← the task's measures of the episode so far. */
SUREFOOT_CALL surefoot_status surefoot_environment_measures(surefoot_environment *environment, double *values,
                                                            size_t count);
/* values ← what moves besides the state, in the order of "signals"; an on/off signal is 0 or 1. */
SUREFOOT_CALL surefoot_status surefoot_environment_signals(surefoot_environment *environment, double *values,
                                                           size_t count);
/* Begins an episode in a given state, within the ranges of its variables. */
SUREFOOT_CALL surefoot_status surefoot_environment_place(surefoot_environment *environment, const double *state,
                                                         size_t count);
/* Pushes the body to the right by an impulse [N s], between two steps. */
SUREFOOT_CALL surefoot_status surefoot_environment_push(surefoot_environment *environment, double impulse);
/* action ← what the hand-made controller of the task would do now. */
SUREFOOT_CALL surefoot_status surefoot_environment_hand_made(surefoot_environment *environment, int64_t *action);
/* The picture of now as shapes in metres, x to the right, y up, the floor at 0: {"focus": [x, y], "height", "width",
 * "metres", "shapes": [{"shape": "line", "points": [[x, y], …], "ink", "width", "dashed"}, {"shape": "polygon",
 * "points", "fill", "ink", "width"}, {"shape": "disc", "centre", "radius", "fill", "ink", "width"}, {"shape": "arrow",
 * "from", "length", "text"}, {"shape": "label", "at", "text"}]}. Inks: solid, body, far, outline, quiet, hairline,
 * fall; fills: none, panel, wash, solid, far, fall. Widths of lines are in pixels. */
SUREFOOT_CALL surefoot_status surefoot_environment_draw(surefoot_environment *environment, const char **json);
/* The same painted: rgb[height][width][3], 0 … 255. Width and height from 16 to 4096; `count` is their product by 3. */
SUREFOOT_CALL surefoot_status surefoot_environment_render(surefoot_environment *environment, int32_t width,
                                                          int32_t height, uint8_t *rgb, size_t count);

/* ---- Many worlds at once ------------------------------------------------------------------------------------------
 */

/* Worlds of one kind that take a step in one call. */
typedef struct surefoot_worlds surefoot_worlds;

/* What becomes of a world whose episode is over (`again`). */
typedef enum surefoot_again {
  SUREFOOT_AGAIN_WHEN_ASKED = 0, /* it stands still (reward 0, its ending told again) until it is reset */
  SUREFOOT_AGAIN_NEXT_STEP = 1,  /* the next step begins its next episode: its action is not used, its reward is 0 */
  SUREFOOT_AGAIN_AT_ONCE = 2     /* the step that ends an episode begins the next */
} surefoot_again;

/* What a step brings; a row is a world. Any pointer but `states` may be NULL. */
typedef struct surefoot_batch {
  double *states;       /* [worlds][state variables] */
  double *rewards;      /* [worlds] */
  uint8_t *terminated;  /* [worlds] */
  uint8_t *truncated;   /* [worlds] */
  uint8_t *falls;       /* [worlds] */
  uint8_t *successes;   /* [worlds] */
  double *reward_terms; /* [worlds][reward terms] */
  double *last_states;  /* [worlds][state variables]: the state in which an episode ended; else the state now */
} surefoot_batch;

/* `description` as in surefoot_environment_make; 1 to 100,000 worlds. World i begins with seed i + 1. */
SUREFOOT_CALL surefoot_status surefoot_worlds_make(const char *description, size_t count, int32_t again,
                                                   surefoot_worlds **worlds);
SUREFOOT_PLAIN surefoot_status surefoot_worlds_close(surefoot_worlds *worlds);
/* As surefoot_environment_about. */
SUREFOOT_CALL surefoot_status surefoot_worlds_about(surefoot_worlds *worlds, const char **json);
/* Begins an episode in the worlds for which `which` is not 0 (NULL: in all). `seeds`: [worlds]; NULL: their random
 * numbers go on. `states`: [worlds][state variables], of all worlds. */
SUREFOOT_CALL surefoot_status surefoot_worlds_reset(surefoot_worlds *worlds, const uint64_t *seeds,
                                                    const uint8_t *which, double *states);
/* One decision in every world. `actions`: [worlds]. */
SUREFOOT_CALL surefoot_status surefoot_worlds_step(surefoot_worlds *worlds, const int64_t *actions,
                                                   const surefoot_batch *batch);

/* ---- Lives --------------------------------------------------------------------------------------------------------
 */

/* A learner in its world, from its first step on. */
typedef struct surefoot_life surefoot_life;

/* A world of the caller's own. */
typedef struct surefoot_world {
  /* {"title", "state": [{"key", "low", "high", and if wanted "title", "symbol", "unit", "resolution" (tiles per range),
   *  "period", "whole"}, …], "actions": [numbers or names], and if wanted "action_title", "action_unit",
   *  "reward_terms": [names], "step_time": s, "goal_reward", "time_reward", "can_fall"}. Without reward terms there is
   *  one, "reward". */
  const char *task;
  void *user; /* handed to both calls */
  /* Begins an episode: state ← where. `seed`: for its random numbers. Not 0: it could not. */
  int (*reset)(void *user, uint64_t seed, double *state);
  /* One decision: state ← where it led to, terms ← the reward terms, outcome ← its four flags (its reward is the terms'
   * sum, whatever it says). Not 0: it could not. */
  int (*step)(void *user, int64_t action, double *state, double *terms, surefoot_outcome *outcome);
} surefoot_world;

/* A policy of the caller's own: pi ← the probability of each action from the values of the actions. What it gives is
 * divided by its sum, which must be positive, and no probability negative. Not 0: it could not. */
typedef struct surefoot_policy {
  void *user;
  int (*probabilities)(void *user, const double *q, size_t actions, double *pi);
} surefoot_policy;

/* `configuration`: {"environment", "preset", "scenario", "agent", "features", "policy": NAMES, "parameters": {KEY:
 * value}, "seed": whole number, "life": which life of this seed, from 0, "load": a file with a Q-function to begin
 * with, "resume": a checkpoint to go on from (then nothing else), "programs": true}. All may be left out. `world` and
 * `policy` may be NULL; they are copied, and their calls are made by the thread that runs the life, inside
 * surefoot_life_run. The name of the caller's own world is "own", of the policy "own". */
SUREFOOT_CALL surefoot_status surefoot_life_make(const char *configuration, const surefoot_world *world,
                                                 const surefoot_policy *policy, surefoot_life **life);
SUREFOOT_PLAIN surefoot_status surefoot_life_close(surefoot_life *life);

/* How far a life goes, counted from its beginning; a limit that is 0 is none. */
typedef struct surefoot_extent {
  int64_t steps;
  int64_t episodes;
  double minutes;  /* simulated; for tasks with a clock */
  double patience; /* [s] of real time from now, after which the call comes back in any case */
} surefoot_extent;

/* The life goes on until a limit is reached. `reached` ← 1: a limit of the life itself; 0: patience ran out.
 * SUREFOOT_DIVERGED and SUREFOOT_UNANSWERED: what was lived before stays. */
SUREFOOT_CALL surefoot_status surefoot_life_run(surefoot_life *life, const surefoot_extent *extent, int32_t *reached);

typedef struct surefoot_totals {
  int64_t steps, episodes, falls, successes; /* episodes: those that are over */
  double simulated_seconds;                  /* NaN: the task has no clock */
  double average_reward;                     /* of the last 80 episodes; 0 before the first */
  double exploring;                          /* share of the steps whose action was not the best by Q */
  int64_t states_outside;                    /* states outside the ranges that the features cover */
} surefoot_totals;
SUREFOOT_CALL surefoot_status surefoot_life_totals(surefoot_life *life, surefoot_totals *totals);
/* Every row of the log and every weight, in 64 bits; equal to "hash" of `surefoot train --json`. */
SUREFOOT_CALL surefoot_status surefoot_life_hash(surefoot_life *life, uint64_t *hash);
/* What `surefoot train --json` prints of such a life. */
SUREFOOT_CALL surefoot_status surefoot_life_about(surefoot_life *life, const char **json);
/* Of its world, as surefoot_environment_about. */
SUREFOOT_CALL surefoot_status surefoot_life_task(surefoot_life *life, const char **json);

typedef enum surefoot_ending {
  SUREFOOT_ENDING_END = 0,
  SUREFOOT_ENDING_SUCCESS = 1,
  SUREFOOT_ENDING_FALL = 2,
  SUREFOOT_ENDING_TRUNCATED = 3
} surefoot_ending;

#define SUREFOOT_MEASURES 4
/* An episode that is over. */
typedef struct surefoot_episode {
  int64_t episode;                    /* from 1 */
  int64_t transitions;                /* its steps */
  int64_t steps;                      /* of the life up to its end */
  double reward;                      /* total, undiscounted */
  double average_reward;              /* of the last 80 episodes; NaN in a store */
  double measures[SUREFOOT_MEASURES]; /* as the task has them; others are 0 (NaN in a store) */
  int32_t falls;
  int32_t ending; /* surefoot_ending */
} surefoot_episode;
/* rows ← episodes from number `first` (from 0) on, at most `count`; `there` ← how many the life has. `rows` may be NULL
 * if `count` is 0. */
SUREFOOT_CALL surefoot_status surefoot_life_episodes(surefoot_life *life, size_t first, surefoot_episode *rows,
                                                     size_t count, size_t *there);

/* Which estimate (`layer`). */
typedef enum surefoot_layer {
  SUREFOOT_LAYER_SUM = 0,      /* Q */
  SUREFOOT_LAYER_POSITIVE = 1, /* Q+, of learners that keep it */
  SUREFOOT_LAYER_NEGATIVE = 2, /* Q- */
  SUREFOOT_LAYER_RISK = 3      /* the risk of a fall, where it is learned */
} surefoot_layer;

/* values[states][actions] ← the layer in each state; `states`: [n][state variables]. `count`: n × actions. */
SUREFOOT_CALL surefoot_status surefoot_life_values(surefoot_life *life, int32_t layer, const double *states, size_t n,
                                                   double *values, size_t count);
/* pi[n][actions] ← the probability of each action under the policy as it is now. */
SUREFOOT_CALL surefoot_status surefoot_life_probabilities(surefoot_life *life, const double *states, size_t n,
                                                          double *pi, size_t count);
/* visits[n] ← how often the features of each state were visited, on average. */
SUREFOOT_CALL surefoot_status surefoot_life_visits(surefoot_life *life, const double *states, size_t n, double *visits,
                                                   size_t count);

/* Sets a parameter, as text; when it takes effect, `surefoot list` says. */
SUREFOOT_CALL surefoot_status surefoot_life_set(surefoot_life *life, const char *key, const char *value);
/* Follows another policy from now on. */
SUREFOOT_CALL surefoot_status surefoot_life_follow(surefoot_life *life, const char *policy);
/* As for an environment. */
SUREFOOT_CALL surefoot_status surefoot_life_push(surefoot_life *life, double impulse);
SUREFOOT_CALL surefoot_status surefoot_life_place(surefoot_life *life, const double *state, size_t count);

/* Writes what was learned to a file that does not exist yet: `surefoot window --load FILE` opens it. */
SUREFOOT_CALL surefoot_status surefoot_life_save(surefoot_life *life, const char *file);
/* Writes the whole life, to go on from with "resume"; the file may exist and is replaced. */
SUREFOOT_CALL surefoot_status surefoot_life_checkpoint(surefoot_life *life, const char *file);

/* ---- Q-functions from files
 * ------------------------------------------------------------------------------------------ */

typedef struct surefoot_q_function surefoot_q_function;

SUREFOOT_CALL surefoot_status surefoot_q_function_open(const char *file, surefoot_q_function **q);
SUREFOOT_PLAIN surefoot_status surefoot_q_function_close(surefoot_q_function *q);
/* {"configuration": …, "origin": a sentence, "content": hash of the values, "layers": ["sum", …], "task": as
 * surefoot_environment_about}. */
SUREFOOT_CALL surefoot_status surefoot_q_function_about(surefoot_q_function *q, const char **json);
SUREFOOT_CALL surefoot_status surefoot_q_function_values(surefoot_q_function *q, int32_t layer, const double *states,
                                                         size_t n, double *values, size_t count);
/* The policy of the next call: its name (NULL: that of the file) and {KEY: value} of its parameters (NULL: as in the
 * file). */
SUREFOOT_CALL surefoot_status surefoot_q_function_follow(surefoot_q_function *q, const char *policy,
                                                         const char *parameters);
SUREFOOT_CALL surefoot_status surefoot_q_function_probabilities(surefoot_q_function *q, const double *states, size_t n,
                                                                double *pi, size_t count);
SUREFOOT_CALL surefoot_status surefoot_q_function_visits(surefoot_q_function *q, const double *states, size_t n,
                                                         double *visits, size_t count);

/* ---- Experiments
 * ------------------------------------------------------------------------------------------------------ */

typedef struct surefoot_progress {
  double share;         /* of the work, 0 … 1 */
  int32_t lives, of;    /* done; planned */
  int64_t falls, steps; /* of all lives */
} surefoot_progress;

/* Runs a plan into a store, as `surefoot experiment`. `plan`: the name of a plan that comes with the program, a file,
 * or the text of one (with a line end in it). `options`: {"out": file of the store, and if wanted "lives", "seed",
 * "jobs", "resume": true, "parameters": {KEY: value}, "programs": true}. `progress` (may be NULL) is called about four
 * times a second by the calling thread; not 0: stop. Lives that were done are kept: SUREFOOT_INTERRUPTED then, and
 * "resume" does the rest. `json` (may be NULL) ← {"store", "lives", "of", "complete", "content_hash", "found"}; it
 * belongs to the calling thread and is valid until its next experiment. */
SUREFOOT_CALL surefoot_status surefoot_experiment(const char *plan, const char *options,
                                                  int (*progress)(void *user, const surefoot_progress *progress),
                                                  void *user, const char **json);

/* The results of an experiment. */
typedef struct surefoot_store surefoot_store;

SUREFOOT_CALL surefoot_status surefoot_store_open(const char *file, surefoot_store **store);
SUREFOOT_PLAIN surefoot_status surefoot_store_close(surefoot_store *store);
/* {"title", "seed", "paired", "version", "note", "content_hash", "conditions": [{"name", "reference", "text", "lives",
 *  "goal_reward", "step_time", "configuration"}, …], "lives": [{"condition", "life", "q_function", "episodes", "steps",
 *  "falls", "states_outside", "diverged", "hash", "measures": {…}}, …]}. Conditions are numbered from 0. */
SUREFOOT_CALL surefoot_status surefoot_store_about(surefoot_store *store, const char **json);
/* As `surefoot statistics --json`. */
SUREFOOT_CALL surefoot_status surefoot_store_statistics(surefoot_store *store, const char **json);
/* As surefoot_life_episodes, of a life in the store. */
SUREFOOT_CALL surefoot_status surefoot_store_episodes(surefoot_store *store, int32_t condition, int32_t life,
                                                      size_t first, surefoot_episode *rows, size_t count,
                                                      size_t *there);

#ifdef __cplusplus
}
#endif

#endif
