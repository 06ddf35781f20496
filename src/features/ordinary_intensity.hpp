// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace falko_slam {

/// How bright ordinary surfaces are, by range: a histogram of intensities for each range cell, both
/// in cells that grow by the same factor. Beams are added, taken out again and forgotten.
class OrdinaryIntensity {
 public:
  static constexpr std::size_t kRangeCells = 48;       ///< four per octave, from 1/16 m to 256 m
  static constexpr std::size_t kIntensityCells = 256;  ///< eight per octave, from 2^-10 to 2^22

  /// Of a beam.
  struct Cell {
    std::uint16_t range;
    std::uint16_t intensity;
  };
  static Cell cell_of(double range, float intensity);

  OrdinaryIntensity();
  void add(Cell cell, float weight);  ///< negative: takes out
  void fade(float share);             ///< all weights become this share of theirs

  /// The brightness that a share (0.5 or more) of the beams at each range stays below, from now on
  /// `at`.
  void settle(float share);

  /// 0: no surfaces have been seen at all. Between and beyond ranges where some were, the level of
  /// the nearest one, continued along the power of the range that fits best.
  float at(double range) const { return level_[cell_of(range, 1.0F).range]; }
  float level(Cell cell) const { return level_[cell.range]; }

 private:
  using Pool = std::array<float, kIntensityCells>;  // of several ranges
  float quantile_of(const Pool& pool, float share, std::size_t end) const;
  float level_of(std::size_t range, float share) const;
  void lower_foil();
  void fill_gaps();

  std::vector<float> weight_;  // [range][intensity]
  std::array<float, kRangeCells> sum_{};
  std::size_t darkest_ = kIntensityCells - 1;  // that was ever added
  std::size_t brightest_ = 0;
  std::array<float, kRangeCells> level_{};
};

}  // namespace falko_slam
