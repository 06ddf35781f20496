// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace falko_slam {

/// Binary shape context \cite kallasi2017 (3.11): which cells of a polar grid around the keypoint,
/// turned to its orientation, hold a point. Cell (ring m, sector j) is bit m * sectors + j, least
/// significant bit of the first word first.
struct Bsc {
  std::vector<std::uint64_t> words;

  bool cell(std::size_t index) const { return ((words[index / 64] >> (index % 64)) & 1U) != 0; }
};

/// Number of cells that differ (3.12). Throws std::invalid_argument if the grids differ in size.
int distance(const Bsc& a, const Bsc& b);

/// Cumulative Gaussian histogram \cite kallasi2017 (3.13)-(3.14) of the directions, relative to the
/// keypoint's orientation, in which its neighbours lie. The bins sum to 1, or to 0 without
/// neighbours: point density cancels.
struct Cgh {
  std::vector<float> bins;
};

/// Symmetric chi-square distance sum (a - b)^2 / (a + b) / 2, in [0, 1].
/// Throws std::invalid_argument if the histograms differ in size.
double distance(const Cgh& a, const Cgh& b);

}  // namespace falko_slam
