// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "falko_slam/calibration/reflector_motion.hpp"

namespace falko_slam {

/// Reflectors of one scan, in the frame of the laser [m]; which one is which nobody knows.
using ReflectorPoints = std::vector<Eigen::Vector2d>;

struct ReflectorMotionParams {
  /// A reflector is the one that was expected so near [m], + this share of its distance. Between
  /// two scans the encoders tell where to expect it.
  double gate_distance = 0.15;  ///< [0.001, 10]
  double gate_share = 0.02;     ///< [0, 1]
  /// Standard deviation of a coordinate in one scan [m], (0, 1]; the scans at rest may tell that it
  /// is more, never less.
  double detection_noise = 0.003;
  /// The same of what does not average out, such as how a reflector looks from another side [m],
  /// [0, 1].
  double lasting_noise = 0.0015;
  std::size_t min_reflectors = 3;  ///< seen at both ends, [2, 1000]
};
/// Throws std::invalid_argument with the field and its value.
void validate(const ReflectorMotionParams& params);

/// Finds out how a laser moved, from the reflectors that it saw: at rest, on the way, at rest
/// again, \cite kallasi2017, 5.2.
///
/// The reflectors of a halt are averaged over its scans. On the way each scan is laid over what is
/// known so far (nearest neighbours, rigid registration), only so that every reflector keeps its
/// identity; the motion itself is that between the two halts, registered once. Not thread-safe.
class ReflectorMotionEstimator {
 public:
  explicit ReflectorMotionEstimator(const ReflectorMotionParams& params = {});

  /// A scan while the vehicle stands before it starts.
  void add_at_start(const ReflectorPoints& points);
  /// A scan on the way; `step` is the laser's motion since the scan before, by the encoders.
  void add_on_the_way(const ReflectorPoints& points, const Pose2& step);
  /// A scan while the vehicle stands at the end; `step` only counts for the first one.
  void add_at_end(const ReflectorPoints& points, const Pose2& step = {});

  /// Empty, with a `complaint()`, if too few reflectors were seen at both ends.
  std::optional<ReflectorMotion> result() const;
  const std::string& complaint() const { return complaint_; }
  /// Scans that fitted nowhere: there the encoders alone led on.
  std::size_t lost_scans() const { return lost_scans_; }

 private:
  struct Landmark {
    Eigen::Vector2d in_start = Eigen::Vector2d::Zero();  // where it is expected to be seen
    std::vector<Eigen::Vector2d> at_start, at_end;       // in the laser's frame there
  };
  struct Pair {
    std::size_t landmark;
    std::size_t point;
  };

  std::vector<Pair> associate(const ReflectorPoints& points, const Pose2& start_T_laser) const;
  std::vector<Pair> fit(const ReflectorPoints& points);
  void move(const Pose2& step);
  double noise_at_rest() const;
  void add_new(const ReflectorPoints& points, const std::vector<Pair>& known);

  ReflectorMotionParams params_;
  std::vector<Landmark> landmarks_;
  Pose2 start_T_laser_;
  double turn_ = 0.0;
  std::size_t scans_ = 0, scans_at_start_ = 0, scans_at_end_ = 0;
  std::size_t lost_scans_ = 0;
  bool ended_ = false;
  mutable std::string complaint_;
};

}  // namespace falko_slam
