/* SPDX-License-Identifier: GPL-3.0-or-later
 * Lives one life and prints its hash: hash_of_life CONFIGURATION MINUTES [EPISODES]. */
#include <inttypes.h>

#include "check.h"

int main(int argc, char **argv) {
  CHECK(argc >= 3);
  surefoot_life *life;
  DONE(surefoot_life_make(argv[1], NULL, NULL, &life));
  /* In pieces: how it is cut must not matter. */
  const surefoot_extent piece = {.minutes = atof(argv[2]), .episodes = argc > 3 ? atol(argv[3]) : 0, .patience = 0.01};
  int32_t reached = 0;
  while (!reached) DONE(surefoot_life_run(life, &piece, &reached));
  uint64_t hash;
  DONE(surefoot_life_hash(life, &hash));
  printf("%016" PRIx64 "\n", hash);
  surefoot_life_close(life);
  return 0;
}
