// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <initializer_list>
#include <random>
#include <vector>

namespace falko_slam {

/// Random numbers for one part of what a user's seed stands for, such as {number of the run}: more
/// of one part does not change another.
inline std::mt19937_64 random_sequence(std::uint64_t seed,
                                       std::initializer_list<std::uint32_t> part) {
  std::vector<std::uint32_t> words = {static_cast<std::uint32_t>(seed),
                                      static_cast<std::uint32_t>(seed >> 32U)};
  words.insert(words.end(), part);
  std::seed_seq sequence(words.begin(), words.end());
  return std::mt19937_64(sequence);
}

}  // namespace falko_slam
