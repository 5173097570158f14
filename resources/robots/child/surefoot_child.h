/* SPDX-License-Identifier: GPL-3.0-or-later
   Moves a robot of Surefoot from C ("surefoot child 1"; little-endian machines). One file includes it:

     static void reset(const uint64_t random[4], const double* parameters, double* numbers) { ... }
     static void step(const double* levels, double* reward, int* terminated, int* truncated, double* numbers) { ... }
     int main(void) { return surefoot_serve(reset, step); }

   Parameters, levels and numbers stand in the order of the robot's file. All chance has to come from `random`, and a
   reset forgets everything before. Nothing may be written to standard output. */
#ifndef SUREFOOT_CHILD_H
#define SUREFOOT_CHILD_H

#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { SUREFOOT_MOST = 65536 };

typedef void (*surefoot_reset)(const uint64_t random[4], const double* parameters, double* numbers);
typedef void (*surefoot_step)(const double* levels, double* reward, int* terminated, int* truncated, double* numbers);

static int surefoot_read(void* to, size_t size) {
  for (ssize_t got; size > 0; to = (char*)to + got, size -= (size_t)got)
    if ((got = read(0, to, size)) <= 0) return 0;
  return 1;
}

static int surefoot_write(uint32_t kind, const void* content, uint32_t size) {
  char frame[8 + SUREFOOT_MOST];
  memcpy(frame, &kind, 4), memcpy(frame + 4, &size, 4), memcpy(frame + 8, content, size);
  return write(1, frame, 8 + size) == (ssize_t)(8 + size);
}

/* Words behind the line's first one: "sends x v" has 2. */
static uint32_t surefoot_count(const char* hello, const char* line) {
  uint32_t words = 0;
  const char* at = strstr(hello, line);
  for (at = at ? at + 1 : at; at && *at && *at != '\n'; ++at) words += *at == ' ' && at[1] != '\n' && at[1] != 0;
  return words;
}

static int surefoot_serve(surefoot_reset reset, surefoot_step step) {
  static union { char text[SUREFOOT_MOST + 1]; double numbers[SUREFOOT_MOST / 8]; } in;
  static double out[SUREFOOT_MOST / 8];
  uint32_t head[2], sends = 0;
  while (surefoot_read(head, 8) && head[1] <= SUREFOOT_MOST && surefoot_read(in.text, head[1])) {
    memset(in.text + head[1], 0, head[1] < SUREFOOT_MOST);
    if (head[0] == 1) {
      sends = surefoot_count(in.text, "\nsends");
      if (!surefoot_write(1, "surefoot child 1", 16)) return 1;
    } else if (head[0] == 2) {
      uint64_t random[4];
      memcpy(random, in.text, sizeof random);
      reset(random, in.numbers + 4, out);
      if (!surefoot_write(2, out, 8 * sends)) return 1;
    } else {
      int terminated = 0, truncated = 0;
      step(in.numbers, out, &terminated, &truncated, out + 3);
      out[1] = terminated != 0, out[2] = truncated != 0;
      if (!surefoot_write(3, out, 8 * (3 + sends))) return 1;
    }
  }
  return 0;
}

#endif
