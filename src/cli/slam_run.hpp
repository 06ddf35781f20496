// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <map>
#include <random>
#include <string>

#include "falko_slam/ros_bridge/drive_recording.hpp"
#include "falko_slam/slam/feature_slam.hpp"
#include "falko_slam/slam/slam_record.hpp"

namespace falko_slam {
namespace cli {

/// Processor time by what it was spent on [s].
class StageTimes {
 public:
  void enter(const std::string& stage);
  const std::map<std::string, double>& seconds() const { return seconds_; }

 private:
  std::map<std::string, double> seconds_;
  std::string stage_;
  double since_ = 0.0;
};

/// SLAM over a recording, with what is to be reported of it.
class SlamRun {
 public:
  /// `outliers`: so many false closures are proposed for each one accepted, at random.
  SlamRun(const SlamParams& params, double outliers, unsigned seed);

  void add(const RecordedScan& recorded);
  /// The last optimisation.
  void finish();

  const FeatureSlam& slam() const { return slam_; }
  const SlamRecord& record() const { return record_; }
  std::size_t unusable() const { return unusable_; }
  StageTimes& times() { return times_; }

 private:
  void inject_outliers();

  SlamParams params_;
  FeatureSlam slam_;
  SlamRecord record_;
  StageTimes times_;
  LaserScan scan_;
  double outliers_;
  std::mt19937_64 random_;
  std::size_t seen_closures_ = 0;
  std::size_t unusable_ = 0;
};

/// Writes trajectory.tum, trajectory_online.tum, map.pgm, map.yaml, map.png, graph.g2o,
/// closures.csv and report.json to a folder. Throws std::runtime_error that names the file.
void write_slam(SlamRun& run, const DriveRecordingReport& read, const std::string& recording,
                const std::string& folder);

}  // namespace cli
}  // namespace falko_slam
