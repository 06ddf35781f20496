// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/segment_recorder.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "calibration/recorded_drives.hpp"
#include "falko_slam/calibration/recorded_segment.hpp"
#include "falko_slam/evaluation/simulated_calibration.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

// A hall with reflectors and a vehicle that its controller knows badly.
Scenario hall(std::vector<DriveStep> drive) {
  Scenario scenario;
  scenario.world.surfaces = {{"matt", 0.5, 0.0}, {"reflector", 0.3, 500.0}};
  add_box(scenario.world.fixed, {}, {44.0, 40.0}, 0);
  for (const auto& [x, y] : {std::pair{12.0, 3.0},
                             {-9.0, 8.0},
                             {4.0, -13.0},
                             {-15.0, -4.0},
                             {6.0, 16.0},
                             {-3.0, 11.0},
                             {16.0, -9.0},
                             {-8.0, -14.0}}) {
    scenario.world.fixed.cylinders.push_back({{x, y}, 0.04, 1});
  }
  scenario.drive = std::move(drive);
  return scenario;
}

std::vector<RecordedSegment> recorded_by_reflectors(const Scenario& scenario,
                                                    const SegmentRecorderParams& params) {
  return test::recorded(scenario, params,
                        [](const SimulationStep::Scan& scan, SegmentRecorder& recorder) {
                          recorder.add(observation_of(scan));
                        });
}

TEST(SegmentRecorder, CutsADriveAtItsHalts) {
  const std::vector<ArcStep> arcs = {
      {0.8, 0.5, kPi, 0.0}, {-0.8, -0.6, kPi / 2.0, 0.0}, {0.6, -0.4, 1.0, 0.0}};
  const Scenario scenario =
      hall({test::kHalt, arcs[0], test::kHalt, arcs[1], test::kHalt, arcs[2], test::kHalt});
  const auto segments = recorded_by_reflectors(scenario, test::recorder_params(scenario));

  ASSERT_EQ(segments.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const RecordedSegment& found = segments[i];
    ASSERT_EQ(found.complaint, "") << i;
    EXPECT_EQ(found.lost_scans, 0U);
    EXPECT_NEAR(found.segment.steering, arcs[i].steering, 1e-4);
    EXPECT_EQ(found.segment.ticks > 0.0, arcs[i].wheel_speed > 0.0);
    EXPECT_NEAR(std::abs(found.segment.turn), arcs[i].turn, 0.02);
    const TricycleParams& truth = scenario.vehicle.tricycle;
    const Pose2& mount = scenario.vehicle.base_T_laser;
    const Pose2 expected =
        mount.inverse() * drive_arc(truth, found.segment.ticks, found.segment.steering) * mount;
    const Pose2 error = expected.inverse() * found.segment.start_T_end.pose;
    EXPECT_LT(error.translation().norm(), 0.02) << i;
    EXPECT_LT(std::abs(error.theta()), 0.002) << i;
  }
}

TEST(SegmentRecorder, NamesWhatIsNoSegment) {
  const Scenario scenario = hall({test::kHalt, ArcStep{0.5, 0.3, 0.0, 0.1}, test::kHalt,
                                  FollowStep{{{6.0, 3.0}, {9.0, -3.0}}, 0.8, 1.5, false},
                                  test::kHalt, ArcStep{-0.5, 0.0, 0.0, 1.0}});
  const auto segments = recorded_by_reflectors(scenario, test::recorder_params(scenario));

  ASSERT_EQ(segments.size(), 3U);
  EXPECT_NE(segments[0].complaint.find("too short"), std::string::npos);
  EXPECT_NE(segments[1].complaint.find("the steering changed"), std::string::npos);
  EXPECT_NE(segments[2].complaint.find("scans at rest after it"), std::string::npos);
}

TEST(SegmentRecorder, NeedsReflectors) {
  Scenario scenario = hall({test::kHalt, ArcStep{0.8, 0.5, 1.0, 0.0}, test::kHalt});
  scenario.world.fixed.cylinders.resize(2);
  const auto segments = recorded_by_reflectors(scenario, test::recorder_params(scenario));

  ASSERT_EQ(segments.size(), 1U);
  EXPECT_NE(segments[0].complaint.find("reflectors seen at both ends"), std::string::npos)
      << segments[0].complaint;
}

TEST(SegmentRecorder, HasNothingBeforeItMoved) {
  SegmentRecorder recorder{SegmentRecorderParams{}};
  recorder.add(ReflectorObservation{Time(std::chrono::seconds(1)), {}});
  recorder.add(EncoderReading{Time(std::chrono::seconds(2)), 7, 3});
  recorder.add(EncoderReading{Time(std::chrono::seconds(2)), 9000, 3});  // not later
  recorder.finish();

  EXPECT_TRUE(recorder.at_rest());
  EXPECT_TRUE(recorder.take().empty());
}

}  // namespace
}  // namespace falko_slam
