// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/simulation_bag.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "falko_slam/ros_bridge/calibration_recording.hpp"
#include "falko_slam/ros_bridge/localization_recording.hpp"
#include "falko_slam/ros_bridge/pose_recording.hpp"
#include "falko_slam/ros_bridge/topics.hpp"
#include "falko_slam/simulation/scenario_file.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

// Ten seconds of a calibration drive: what one part writes the others read.
class SimulationBag : public ::testing::Test {
 protected:
  SimulationBag() {
    scenario_ = read_scenario(FALKO_SLAM_SOURCE_DIR "/config/scenarios/calibration_area.yaml");
    SimulationBagParams params;
    params.duration = 10.0;
    report_ = simulate_to_bag(scenario_, params, bag_, [] {});
  }

  test::TemporaryFolder folder_;
  std::string bag_ = folder_.file("drive.bag");
  Scenario scenario_;
  SimulationBagReport report_;
};

TEST_F(SimulationBag, HoldsTheTruthAsATopic) {
  const Trajectory truth = read_pose_topic(bag_, topics::kGroundTruth);
  EXPECT_EQ(report_.scans, 80U);
  ASSERT_GT(truth.size(), report_.scans);
  EXPECT_EQ(read_pose_topic(bag_, "").size(), truth.size());
  try {
    read_pose_topic(bag_, topics::kScan);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()).find(bag_), 0U) << error.what();
  }
}

TEST_F(SimulationBag, CanBeLocalized) {
  LocalizationRecordingParams params;
  const LocalizationRecording recording = open_localization_recording(bag_, params);
  EXPECT_TRUE(recording.laser_known);
  EXPECT_FALSE(recording.upside_down);
  EXPECT_GT(recording.truth.size(), 0U);
  std::size_t motions = 0, scans = 0;
  LocalizationListener listener;
  listener.motion = [&](Time stamp, const PoseEstimate&) {
    EXPECT_GE(stamp, recording.begin);
    ++motions;
  };
  listener.scan = [&](const RawScan& raw) {
    EXPECT_EQ(raw.range_count, 1440U);
    ++scans;
  };
  play_localization_recording(bag_, params, listener);
  EXPECT_GT(motions, 400U);
  EXPECT_NEAR(static_cast<double>(scans), static_cast<double>(report_.scans), 2.0);

  params.reported = true;
  std::size_t seen = 0;
  listener.reflectors = [&](Time, const std::vector<LandmarkObservation>& observations) {
    seen += observations.size();
  };
  play_localization_recording(bag_, params, listener);
  EXPECT_GT(seen, report_.scans);
}

TEST_F(SimulationBag, CanBeCalibrated) {
  EXPECT_EQ(egomotion_in(bag_, {}, 3), EgomotionSource::kReflectors);
  EXPECT_EQ(egomotion_in(bag_, {}, 1000), EgomotionSource::kScans);
  SegmentRecorderParams params;
  params.tricycle = scenario_.vehicle.nominal;
  params.encoders = scenario_.vehicle.encoders;
  params.base_T_laser = scenario_.vehicle.nominal_base_T_laser;
  const CalibrationRecording recording = read_calibration_drive(bag_, {}, params);
  EXPECT_FALSE(recording.description.empty());
  EXPECT_LE(recording.segments.size(), 2U);
}

}  // namespace
}  // namespace falko_slam
