// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "falko_slam/evaluation/error_summary.hpp"
#include "falko_slam/geometry/trajectory.hpp"
#include "falko_slam/localization/localizer.hpp"
#include "falko_slam/sensor/scan_normalizer.hpp"

namespace falko_slam {
namespace cli {

/// A localizer on a recording and what it said after each scan.
class LocalizeRun {
 public:
  /// `truth` may be empty.
  LocalizeRun(const LocalizerParams& params, const LandmarkMap& map,
              const ScanNormalizerParams& scanner, const Trajectory& truth);

  Localizer& localizer() { return localizer_; }

  void add(const RawScan& raw);
  void add(Time stamp, const std::vector<LandmarkObservation>& reflectors);

  const Trajectory& trajectory() const { return trajectory_; }
  const std::string& table() const { return table_; }  ///< CSV, a line for each scan
  const PoseErrors& errors() const { return errors_; }
  std::size_t scans() const { return scans_; }
  std::size_t unusable() const { return unusable_; }
  const std::array<std::size_t, 4>& status() const { return status_; }
  double mean_seconds() const;  ///< from the raw scan to the pose
  double max_seconds() const { return max_seconds_; }

 private:
  void note(const LocalizerReport& report, double seconds);

  ScanNormalizerParams scanner_;
  Localizer localizer_;
  TrajectoryIndex truth_;
  LaserScan scan_;
  Trajectory trajectory_;
  std::string table_;
  PoseErrors errors_;
  std::size_t scans_ = 0, unusable_ = 0;
  std::array<std::size_t, 4> status_{};
  double seconds_ = 0.0, max_seconds_ = 0.0;
};

}  // namespace cli
}  // namespace falko_slam
