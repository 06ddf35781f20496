// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "falko_slam/geometry/pose_estimate.hpp"
#include "falko_slam/localization/landmark_index.hpp"
#include "falko_slam/localization/localizer_params.hpp"

namespace falko_slam {

/// A place from where a scan's landmarks may have been seen.
struct PlaceCandidate {
  Pose2 map_T_base;
  std::size_t explained = 0;  ///< observations that have a landmark there
};

/// Where in a map observations fit, with nothing known of the pose.
///
/// Any two observations and any two landmarks of their kinds that are as far apart, to within the
/// deviations of all four, give a place; the pairs of observations with the fewest such landmarks
/// come first. It is kept if at least ConstellationParams::min_landmarks observations have a
/// landmark where they point to. Mirror images do not fit. All pairs of landmarks are kept sorted
/// by distance (the shortest million of them): O(log pairs) for a pair of observations and
/// O(observations) for a place, of which max_candidates are tried.
class ConstellationSearch {
 public:
  /// Throws std::invalid_argument for params.
  ConstellationSearch(const ConstellationParams& params, const Pose2& base_T_laser,
                      std::shared_ptr<const LandmarkIndex> map);

  /// The best ones, those that explain most first; of ones that are near to each other one.
  std::vector<PlaceCandidate> search(const std::vector<LandmarkObservation>& observations);

 private:
  struct MapPair {
    float distance;
    std::uint32_t first, second;
  };
  struct Point {
    Eigen::Vector2d in_laser;
    double variance;  // in its worst direction, with that of the map
    LandmarkKind kind;
  };
  struct PointPair {
    std::size_t first, second;
    double distance, tolerance;
    std::size_t begin, end;  // in pairs_
  };

  void list_map_pairs();
  void list_point_pairs();
  void try_place(const PointPair& pair, std::uint32_t first, std::uint32_t second);
  bool has_near(const Eigen::Vector2d& point_in_map, double radius, LandmarkKind kind);
  std::size_t explained_by(const Pose2& map_T_laser, const PointPair& pair, std::size_t enough);
  void keep(const Pose2& map_T_laser, std::size_t explained);

  ConstellationParams params_;
  Pose2 base_T_laser_;
  std::shared_ptr<const LandmarkIndex> map_;
  std::vector<MapPair> pairs_;  // by distance
  std::vector<Point> points_;
  std::vector<PointPair> point_pairs_;
  std::vector<PlaceCandidate> best_;
  std::vector<std::size_t> near_;
};

/// Nearer to each other than half a metre and six degrees: not told apart.
bool are_same_place(const Pose2& a, const Pose2& b);

}  // namespace falko_slam
