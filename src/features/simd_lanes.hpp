// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace falko_slam {

/// So many numbers are treated at once, which every x86-64 and AArch64 machine can. Arithmetic,
/// comparison and `mask ? a : b` work by lane; a comparison gives a mask of ones or zeros. An
/// extension of GCC and Clang.
constexpr std::size_t kLanes = 4;
using FloatLanes = float __attribute__((vector_size(kLanes * sizeof(float))));
using IntLanes = std::int32_t __attribute__((vector_size(kLanes * sizeof(std::int32_t))));

/// kLanes numbers from memory, at any alignment.
inline void load(const float* numbers, FloatLanes& lanes) {
  std::memcpy(&lanes, numbers, sizeof lanes);
}

inline void store(const FloatLanes& lanes, float* numbers) {
  std::memcpy(numbers, &lanes, sizeof lanes);
}

inline void square_root(FloatLanes& lanes) {
  for (std::size_t i = 0; i < kLanes; ++i) lanes[i] = std::sqrt(lanes[i]);
}

inline bool any(const IntLanes& mask) {
  std::int32_t set = 0;
  for (std::size_t i = 0; i < kLanes; ++i) set |= mask[i];
  return set != 0;
}

}  // namespace falko_slam
