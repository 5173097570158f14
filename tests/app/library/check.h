/* SPDX-License-Identifier: GPL-3.0-or-later
 * What the tests in C say when something does not hold. */
#pragma once

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "surefoot.h"

#define CHECK(holds)                                                                                       \
  do {                                                                                                     \
    if (!(holds)) {                                                                                        \
      fprintf(stderr, "%s:%d: %s\n  last error: %s\n", __FILE__, __LINE__, #holds, surefoot_last_error()); \
      exit(1);                                                                                             \
    }                                                                                                      \
  } while (0)

/* The call succeeds. */
#define DONE(call) CHECK((call) == SUREFOOT_DONE)

/* The call is refused with this status, and a sentence that has these words in it. */
#define REFUSED(call, status, words)                       \
  do {                                                     \
    CHECK((call) == (status));                             \
    CHECK(strstr(surefoot_last_error(), (words)) != NULL); \
  } while (0)
