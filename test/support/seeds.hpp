// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <random>

namespace falko_slam {
namespace test {

/// The one seed of all random tests: a failure repeats.
constexpr std::uint64_t kSeed = 20161;

inline std::mt19937_64 seeded_random() { return std::mt19937_64(kSeed); }

inline double uniform(std::mt19937_64& random, double min, double max) {
  return std::uniform_real_distribution<double>(min, max)(random);
}

inline double normal(std::mt19937_64& random, double standard_deviation) {
  return standard_deviation * std::normal_distribution<double>()(random);
}

}  // namespace test
}  // namespace falko_slam
