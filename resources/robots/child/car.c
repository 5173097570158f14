/* SPDX-License-Identifier: GPL-3.0-or-later
   The car in the valley (Sutton & Barto, example 10.1) in C. To use it: cc -O2 -o car car.c -lm, and in car.toml
   command = ["./car"]. */
#include "surefoot_child.h"

#include <math.h>

static double power, x, v;

static void reset(const uint64_t random[4], const double* parameters, double* numbers) {
  power = parameters[0];
  x = -0.6 + 0.2 * (double)(random[0] >> 11) / 9007199254740992.0, v = 0.0;
  numbers[0] = x, numbers[1] = v;
}

static void step(const double* levels, double* reward, int* terminated, int* truncated, double* numbers) {
  v = fmin(fmax(v + power * levels[0] - 0.0025 * cos(3 * x), -0.07), 0.07);
  x = fmin(fmax(x + v, -1.2), 0.5);
  if (x == -1.2) v = 0.0;
  *reward = -1, *terminated = x >= 0.5, *truncated = 0;
  numbers[0] = x, numbers[1] = v;
}

int main(void) { return surefoot_serve(reset, step); }
