// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "falko_slam/sensor/laser_scan.hpp"
#include "falko_slam/sensor/surface_step.hpp"

namespace falko_slam {

/// A point of a scan with the piece of wall that it stands for.
struct SurfacePoint {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< laser frame [m]
  Eigen::Vector2d normal = Eigen::Vector2d::Zero();    ///< towards the laser; zero: not known
  double length = 0.0;                                 ///< of the piece of wall [m]
  /// Variance of the normal's angle per variance of a point's distance to the wall [1/m^2].
  double normal_gain = 0.0;
};

struct ScanViewParams {
  /// Points nearer than this to the last one kept are left out. [m]
  double point_spacing = 0.05;
  /// Farther beams are left out. [m]
  double max_range = 30.0;
  /// Normals are taken over this length of wall to either side. [m]
  double normal_reach = 0.10;
  SurfaceStepParams surface;
  /// Off: for scans that are registered with others, and never others with them. Saves time.
  bool normals = true;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const ScanViewParams& params);

/// What is compared of two scans: surface points, and for each direction how far it is free.
class ScanView {
 public:
  ScanView() = default;
  explicit ScanView(const LaserScan& scan, const ScanViewParams& params = {});

  /// The surface of all beams that are valid and near enough, `point_spacing` apart.
  const std::vector<SurfacePoint>& points() const { return points_; }

  /// The beam nearest to a direction [rad, laser frame]; none if no beam looks there.
  std::optional<std::size_t> beam_at(double bearing) const {
    if (all_.empty() || beams_per_radian_ <= 0.0) return std::nullopt;
    double beams = (bearing - angle_min_) * beams_per_radian_ + 0.5;
    beams -= beams_per_turn_ * std::floor(beams * turns_per_beam_);
    const double nearest = std::max(0.0, beams);
    if (nearest < static_cast<double>(all_.size())) return static_cast<std::size_t>(nearest);
    return closed_ ? std::optional<std::size_t>(0) : std::nullopt;
  }
  std::size_t beam_count() const { return all_.size(); }
  bool closed() const { return closed_; }
  /// Of the beam; length 0 where it is not valid or too far.
  const SurfacePoint& surface(std::size_t beam) const { return all_[beam]; }
  /// How far the beam saw [m]; 0 where it is not valid.
  double range(std::size_t beam) const { return ranges_[beam]; }

 private:
  std::size_t beside(std::size_t beam, int direction, const ScanViewParams& params) const;
  void measure_wall(std::size_t beam, const ScanViewParams& params);
  void keep_points(double spacing);

  double angle_min_ = 0.0;
  double angle_increment_ = 0.0;
  double beams_per_radian_ = 0.0;  // 0 without an increment
  double beams_per_turn_ = 0.0;
  double turns_per_beam_ = 0.0;
  bool closed_ = false;
  std::vector<double> ranges_;
  std::vector<SurfacePoint> all_;
  std::vector<SurfacePoint> points_;
};

}  // namespace falko_slam
