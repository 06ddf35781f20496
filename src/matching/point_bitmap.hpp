// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace falko_slam {

/// Which places lie near a point of a set: a bitmap that repeats itself every 512 cells.
class PointBitmap {
 public:
  explicit PointBitmap(double cell) : per_metre_(1.0 / cell), words_(kSide * kSide / 64, 0) {}

  /// Marks the cell of the point and its eight neighbours.
  void mark(const Eigen::Vector2d& point) {
    const std::uint64_t x = number(point.x());
    const std::uint64_t y = number(point.y());
    for (const std::uint64_t dy : {-1, 0, 1}) {
      for (const std::uint64_t dx : {-1, 0, 1}) {
        const std::size_t bit = bit_of(x + dx, y + dy);
        words_[bit / 64] |= std::uint64_t{1} << (bit % 64);
        marked_.push_back(bit / 64);
      }
    }
  }
  void clear() {
    for (const std::size_t word : marked_) words_[word] = 0;
    marked_.clear();
  }

  /// Always true within a cell's side of a marked point.
  bool near_marked(const Eigen::Vector2d& point) const {
    const std::size_t bit = bit_of(number(point.x()), number(point.y()));
    return ((words_[bit / 64] >> (bit % 64)) & 1U) != 0;
  }

 private:
  static constexpr std::uint64_t kSide = 512;

  // Counted from far enough away that truncation rounds down.
  std::uint64_t number(double coordinate) const {
    return static_cast<std::uint64_t>(
        static_cast<std::int64_t>(coordinate * per_metre_ + 1099511627776.0));
  }
  static std::size_t bit_of(std::uint64_t x, std::uint64_t y) {
    return (y % kSide) * kSide + x % kSide;
  }

  double per_metre_;
  std::vector<std::uint64_t> words_;
  std::vector<std::size_t> marked_;
};

}  // namespace falko_slam
