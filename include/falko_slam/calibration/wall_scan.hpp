// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "falko_slam/sensor/unrolled_scan.hpp"

namespace falko_slam {

struct WallScanParams {
  double max_range = 60.0;  ///< farther beams are left out [m], [0.1, 1e5]
  /// A beam that is farther from the straight line of its wall, and beyond noise, ends it [m],
  /// [0, 1].
  double straightness = 0.005;
  /// Beams left out at either end of a wall: their light falls on what is beside it, too, [0, 100].
  std::size_t end_beams = 2;
  std::size_t min_beams = 5;  ///< without these; fewer are no wall, [3, 1000]
  double piece_length = 0.5;  ///< of what is compared as one point [m], [0.01, 100]
  double part_length = 4.0;   ///< of a wall that errs as one [m], [0.01, 1000]
  SurfaceStepParams surface;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const WallScanParams& params);

/// A short piece of a straight wall: some beams next to each other.
struct WallPiece {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();  ///< in the frame of the laser [m]
  double variance = 0.0;                             ///< of its distance across the wall [m^2]
  std::size_t first = 0, last = 0;                   ///< beams, as StraightWall counts them
  std::size_t wall = 0;                              ///< index into walls()
  std::size_t part = 0;                              ///< number of the part of a wall, over all
};

/// Beams that lie on one straight line, counted as in UnrolledScan.
struct StraightWall {
  std::size_t first = 0, last = 0;
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();  ///< towards the laser
  double angle_variance = 0.0;                        ///< of the normal [rad^2]
  double residual_variance = 0.0;                     ///< of a beam's distance to it [m^2]
};

/// What is straight in a scan: each connected surface, split as in \cite douglas1973.
class WallScan {
 public:
  WallScan() = default;
  /// `noise` is the standard deviation of its ranges [m].
  WallScan(const LaserScan& scan, double noise, const WallScanParams& params = {});

  const std::vector<StraightWall>& walls() const { return walls_; }
  const std::vector<WallPiece>& pieces() const { return pieces_; }
  std::size_t parts() const { return parts_; }

  /// The beam that looks into a direction [rad], counted as in StraightWall.
  std::optional<std::size_t> beam_at(double bearing) const;
  std::optional<std::size_t> wall_at(std::size_t beam) const;
  double angle_increment() const { return angle_increment_; }          ///< [rad]
  double range(std::size_t beam) const { return beams_.range(beam); }  ///< 0: not valid [m]
  /// Of the beams from first to last: their mean, with its variance across their wall.
  WallPiece piece(std::size_t wall, std::size_t first, std::size_t last) const;
  double length_of(const WallPiece& piece) const {  ///< from its first beam to its last [m]
    return (beams_.point(piece.last) - beams_.point(piece.first)).norm();
  }

 private:
  void split(std::size_t first, std::size_t last, double noise, const WallScanParams& params);
  void add_wall(std::size_t first, std::size_t last, const WallScanParams& params);

  UnrolledScan beams_;
  double angle_min_ = 0.0, angle_increment_ = 0.0;
  bool closed_ = false;
  std::vector<std::size_t> wall_of_;
  std::vector<StraightWall> walls_;
  std::vector<WallPiece> pieces_;
  std::size_t parts_ = 0;
};

}  // namespace falko_slam
