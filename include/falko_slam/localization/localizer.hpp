// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "falko_slam/localization/landmark_filter.hpp"
#include "falko_slam/localization/landmark_map.hpp"
#include "falko_slam/localization/localizer_params.hpp"
#include "falko_slam/localization/localizer_report.hpp"
#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

/// Where base_link is on a fixed map of landmarks, and what that is worth: from motions of
/// base_link and scans, or the reflectors that a device reports, to a pose with a status.
///
/// Motions are what odometry says between two stamps, in the frame of base_link at the first one.
/// Inputs may come late and out of order within LocalizerParams::history. Nothing that is not
/// finite gets in. A scan costs what detection and PoseFilter cost; while the pose is searched for,
/// ConstellationSearch in addition.
///
/// A pose is given while the status is kOk or kDegraded. Without one, or with one that turns out
/// to be wrong, it is searched for by itself (`LocalizerParams::search_alone`), or when
/// globalize() is called. Not thread-safe.
class Localizer {
 public:
  /// Throws std::invalid_argument with the field and its value, or as validate(LandmarkMap) does.
  Localizer(const LocalizerParams& params, const LandmarkMap& map);
  ~Localizer();
  Localizer(Localizer&&) noexcept;
  Localizer& operator=(Localizer&&) noexcept;

  /// The motion of base_link since the last one's stamp. The first one says where time begins.
  InputVerdict add_motion(Time stamp, const PoseEstimate& motion);

  const LocalizerReport& add_scan(const LaserScan& scan);

  /// Reflectors in the frame of the laser at one instant.
  const LocalizerReport& add_reflectors(Time stamp,
                                        const std::vector<LandmarkObservation>& observations);

  /// The pose at a stamp, as a person or another system knows it; motions since then are added. Its
  /// covariance is taken at its word. Empty: the pose is unknown, as at the beginning. Throws
  /// std::invalid_argument for a pose or covariance that is none.
  void set_pose(Time stamp, const std::optional<PoseEstimate>& map_T_base);

  /// Forgets the pose and searches for it.
  void globalize();

  /// What has been silent until now: to be called regularly by who has a clock.
  const LocalizerReport& check(Time now);

  const LocalizerReport& state() const;
  /// Those that no map holds and the filter keeps beside the pose; none without a pose.
  std::vector<ActiveLandmark> landmarks() const;
  const LocalizerParams& params() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace falko_slam
