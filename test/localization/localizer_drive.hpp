// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "falko_slam/evaluation/simulated_drive.hpp"
#include "falko_slam/evaluation/surveyed_map.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/localization/localizer.hpp"
#include "falko_slam/simulation/scenario_file.hpp"

namespace falko_slam {
namespace test {

/// The first half minute of the warehouse's tour: 20 s along the docks, where eight reflectors and
/// more are in sight, then into an aisle.
class LocalizerDrive {
 public:
  LocalizerDrive()
      : scenario_(read_scenario(FALKO_SLAM_SOURCE_DIR "/config/scenarios/warehouse.yaml")),
        drive_(simulate_drive(scenario_, {}, {}, 1, 30.0)),
        truth_(drive_.truth) {
    std::mt19937_64 random(1);
    map_ = surveyed_map(scenario_.world, 0.0, random);
  }

  static const LocalizerDrive& shared() {
    static const LocalizerDrive drive;
    return drive;
  }

  const LandmarkMap& map() const { return map_; }
  const std::vector<DriveInputEvent>& events() const { return drive_.events; }
  Time at(double seconds) const { return drive_.truth.front().stamp + from_seconds(seconds); }
  Pose2 truth(Time stamp) const { return *truth_.interpolate(stamp, std::chrono::seconds(1)); }

  Localizer localizer(const LandmarkMap& map) const {
    LocalizerParams params;
    params.base_T_laser = drive_.base_T_laser;
    return {params, map};
  }
  Localizer localizer_at_start() const {
    Localizer localizer = this->localizer(map_);
    localizer.set_pose(at(0.0), PoseEstimate{truth(at(0.0)), pose_covariance(0.02, 0.005)});
    return localizer;
  }

  using Edit = std::function<bool(DriveInputEvent&)>;  ///< false: the event is left out
  using Look = std::function<void(const LocalizerReport&)>;

  /// Events between two times [s]; stamps may be moved by `shift`. Looks at each report of a scan.
  void play(Localizer& localizer, double from, double to, const Look& look = {},
            const Edit& edit = {}, Duration shift = {}) const {
    for (DriveInputEvent event : drive_.events) {
      const Time since = event.scan ? event.scan->first_beam_time : event.stamp;
      if (since <= at(from) || event.stamp > at(to)) continue;
      if (edit && !edit(event)) continue;
      if (event.motion) localizer.add_motion(event.stamp + shift, *event.motion);
      if (!event.scan) continue;
      event.scan->first_beam_time += shift;
      const LocalizerReport& report = localizer.add_scan(*event.scan);
      if (look) look(report);
    }
  }

  /// Position error of the report's pose [m]; infinite where there is none.
  double error(const LocalizerReport& report, Duration shift = {}) const {
    if (!report.map_T_base) return std::numeric_limits<double>::infinity();
    return (report.map_T_base->pose.translation() - truth(report.stamp - shift).translation())
        .norm();
  }

 private:
  Scenario scenario_;
  SimulatedDrive drive_;
  TrajectoryIndex truth_;
  LandmarkMap map_;
};

}  // namespace test
}  // namespace falko_slam
