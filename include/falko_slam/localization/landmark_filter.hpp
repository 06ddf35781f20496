// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "falko_slam/common/time.hpp"
#include "falko_slam/localization/association.hpp"
#include "falko_slam/localization/line_model.hpp"

namespace falko_slam {

struct LandmarkFilterParams {
  Pose2 base_T_laser;
  /// Landmarks in the state at a time; the cost of a step grows with its square. [1, 500]
  int max_landmarks = 60;
  int hits = 3;  ///< observations of a new landmark before it counts. [1, 100]
  /// A landmark not seen for so long leaves the state. Too short, and one that was covered for a
  /// moment comes back as a new one that knows nothing of the way before. [0.01, 1000] [s]
  double forget_after = 2.0;
  /// A new landmark not seen again for so long is none. [0.01, 1000] [s]
  double give_up_after = 0.5;
  /// A point nearer to one of the state than this is not added. [0, 10] [m]
  double separation = 0.15;
  /// What is taken for a landmark's place changes with the side that it is seen from: a random walk
  /// of this standard deviation while the vehicle goes one metre. Of both coordinates of a point
  /// that is a natural feature. [0, 1] [m / sqrt(m)]
  double point_wander = 0.01;
  double face_wander = 0.001;      ///< of a face, across it. [0, 1] [m / sqrt(m)]
  double face_turn_wander = 2e-4;  ///< of a face, its direction. [0, 1] [rad / sqrt(m)]
  /// A step of its search costs more than with a fixed map: fewer of them.
  AssociationParams association{0.997, 0.999, 6.0, 200};
};
/// Throws std::invalid_argument with the field and its value.
void validate(const LandmarkFilterParams& params);

/// What a scan may show: points, and straight faces as landmarks of their own.
struct FeatureObservations {
  std::vector<LandmarkObservation> points;  ///< ids are those of the map
  std::vector<LineObservation> lines;
};

/// A landmark of the state.
struct ActiveLandmark {
  std::uint64_t number = 0;  ///< never given again
  bool is_line = false;
  LandmarkKind kind = LandmarkKind::kFeature;
  MapLine line;                                      ///< if it is one
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();  ///< the point; of a line what was seen last
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< of the point or (angle, offset)
  double half_length = 0.0;                              ///< of a line [m]
  Time last_seen{};
};

struct FeatureUpdate {
  std::vector<ObservationVerdict> points;  ///< one per point
  /// One per point: the landmark of the map that it corrected the pose with, by its place there.
  std::vector<std::optional<std::size_t>> of_map;
  std::vector<ObservationVerdict> lines;  ///< one per line
  double nis = 0.0;                       ///< of the pairs that were used
  int degrees_of_freedom = 0;
  int dropped = 0;     ///< landmarks that left the state
  bool proven = true;  ///< the search was not cut short by max_nodes
};

/// Localization with or without a map: an extended Kalman filter over the pose and a bounded number
/// of landmarks that come and go beside those of a fixed map (\cite kallasi2017 5.4 keeps these
/// outside of the state and forgets how their errors hang together with the pose's; see
/// doc/decisions/0020-localization-filter.md).
///
/// The covariance is PoseFilter's: of the additive error of (x, y, theta) in map; it grows with the
/// way while no landmark of the map is seen. What may be one of these is it or nothing; all else
/// may become a landmark of the state. A landmark enters where its last hit saw it, with all of the
/// pose's uncertainty; the hits before it count as no information. Noise by incidence and range is
/// the caller's to give with each observation. Constant cost per step; not thread-safe.
class LandmarkFilter {
 public:
  /// Throws std::invalid_argument for params, or a pose or covariance that is none.
  LandmarkFilter(const LandmarkFilterParams& params, const PoseEstimate& map_T_base,
                 std::shared_ptr<const LandmarkIndex> map = nullptr);
  ~LandmarkFilter();
  LandmarkFilter(const LandmarkFilter& other);
  LandmarkFilter& operator=(const LandmarkFilter& other);
  LandmarkFilter(LandmarkFilter&&) noexcept;
  LandmarkFilter& operator=(LandmarkFilter&&) noexcept;

  /// As PoseFilter::predict().
  bool predict(const PoseEstimate& motion);

  /// Stamps must not run backward, or all that was seen later counts as seen just now.
  FeatureUpdate update(Time stamp, const FeatureObservations& observations);

  PoseEstimate map_T_base() const;
  /// The pose is taken as it is, landmarks of the state are dropped. Throws std::invalid_argument
  /// as the constructor does.
  void reset(const PoseEstimate& map_T_base);

  std::vector<ActiveLandmark> landmarks() const;
  /// Of pose (x, y, theta) and landmarks, two rows each in the order of landmarks().
  Eigen::MatrixXd covariance() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace falko_slam
