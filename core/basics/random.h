// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers with the same bits on every machine: the distributions of the standard library differ between
// implementations, so both generator and distributions are written out here.
//
// xoshiro256++ (Blackman & Vigna, Scrambled linear pseudorandom number generators, ACM TOMS 47, 2021), its state
// filled by SplitMix64 (Steele, Lea & Flood 2014), as its authors recommend.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace surefoot {

/// The output function of SplitMix64: a bijection of 64 bits in which every input bit moves every output bit.
constexpr std::uint64_t mix64(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/// SplitMix64 as a generator: the next number, the state moved on by the golden ratio.
constexpr std::uint64_t splitMix64(std::uint64_t& state) {
  return mix64(state += 0x9e3779b97f4a7c15ULL);
}

/// 53 random bits as a number in [0, 1).
constexpr double toUnit(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1.0p-53;
}

/// The streams of one life. They never share numbers: a policy that draws more does not change the world.
enum class Stream : std::uint64_t { World = 1, Policy = 2, Weights = 3, Viewer = 4, Tests = 5 };

/// The seed of one stream of life `life` (from 0) under the master seed of an experiment.
constexpr std::uint64_t deriveSeed(std::uint64_t master, std::uint64_t life, Stream stream) {
  std::uint64_t seed = mix64(master + 0x9e3779b97f4a7c15ULL);
  seed = mix64(seed ^ mix64(life + 0xd1b54a32d192ed03ULL));
  return mix64(seed ^ mix64(static_cast<std::uint64_t>(stream) * 0x8cb92ba72f3d8dd7ULL));
}

/// The `index`-th number of an unordered stream, in [0, 1): depends on nothing but seed and index, so that a table of
/// initial weights can be filled in any order or only where it is read.
constexpr double uniformAt(std::uint64_t seed, std::uint64_t index) {
  return toUnit(mix64(seed + (index + 1) * 0x9e3779b97f4a7c15ULL));
}

class Random {
 public:
  explicit Random(std::uint64_t seed) {
    for (auto& word : state_) word = splitMix64(seed);
  }
  explicit Random(const std::array<std::uint64_t, 4>& state) : state_(state) {}

  std::uint64_t next() {
    const std::uint64_t result = std::rotl(state_[0] + state_[3], 23) + state_[0];
    const std::uint64_t t = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= t;
    state_[3] = std::rotl(state_[3], 45);
    return result;
  }

  /// Uniform in [0, 1).
  double uniform() { return toUnit(next()); }
  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  const std::array<std::uint64_t, 4>& state() const { return state_; }

 private:
  std::array<std::uint64_t, 4> state_{};
};

}  // namespace surefoot
