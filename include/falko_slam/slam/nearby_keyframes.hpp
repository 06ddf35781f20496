// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "falko_slam/common/keyframe_id.hpp"
#include "falko_slam/geometry/pose2.hpp"

namespace falko_slam {

struct NearbyKeyframesParams {
  /// Keyframes within this distance and this turn of the source; for scans all around the turn does
  /// not matter. [0.1, 100] [m], [0.1, pi] [rad]
  double max_distance = 3.0;
  double max_turn = 1.0;
  /// Of those within this length of way of each other the nearest one. [0, 100] [m]
  double spacing = 1.0;
  /// At least this much way must lie between the source and them. [0, 1000] [m]
  double min_path = 2.0;
  /// At most so many. [1, 100]
  int count = 3;
  /// Where they are, seen from the source, must be known to this standard deviation. [0, 10] [m]
  double max_drift = 0.15;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const NearbyKeyframesParams& params);

/// A keyframe that is surely near another one.
struct NearbyKeyframe {
  KeyframeId id;
  double drift = 0.0;  ///< standard deviation of where it is, seen from there: an upper bound [m]
};

/// Knows which keyframes are connected with which, and how well: finds those that a keyframe is
/// surely near to, to be registered with it without any search. Not thread-safe.
class NearbyKeyframes {
 public:
  explicit NearbyKeyframes(const NearbyKeyframesParams& params = {});

  /// The next keyframe; `path` is the length of the way there [m], `all_around` of a closed scan.
  void add(double path, bool all_around);
  /// The pose of `b` was measured from `a` with this covariance of x, y [m] and theta [rad].
  void connect(KeyframeId a, KeyframeId b, const Eigen::Matrix3d& covariance);

  /// The nearest first. `poses` are those of all keyframes, in one frame where they are connected.
  std::vector<NearbyKeyframe> find(KeyframeId source, const std::vector<Pose2>& poses);
  /// Standard deviation of where `target` is, seen from `source`, along the surest chain of
  /// measurements [m]: an upper bound. Empty if it is above `limit`.
  std::optional<double> drift(KeyframeId source, KeyframeId target, const std::vector<Pose2>& poses,
                              double limit);

  /// The same of all keyframes; infinite where nothing connects them.
  std::vector<double> drifts(KeyframeId source, const std::vector<Pose2>& poses);

  double path(KeyframeId id) const { return nodes_[id.value].path; }

 private:
  struct Link {
    std::size_t to;
    double place_variance;  // [m^2]
    double turn_variance;   // [rad^2]
  };
  struct Node {
    double path;
    bool all_around;
    std::vector<Link> links;
    double variance = 0.0;   // from the source of the last search
    std::size_t search = 0;  // that reached it
    bool settled = false;
  };
  template <class Visit>
  void search_from(std::size_t source, const std::vector<Pose2>& poses, double limit,
                   const Visit& visit);
  std::vector<std::size_t> candidates(std::size_t source, const std::vector<Pose2>& poses) const;

  NearbyKeyframesParams params_;
  std::vector<Node> nodes_;
  std::size_t searches_ = 0;
};

}  // namespace falko_slam
