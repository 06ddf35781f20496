// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Segments from scans, and what is kept while a drive is recorded.
#include <gtest/gtest.h>

#include "calibration/recorded_drives.hpp"
#include "falko_slam/calibration/segment_recorder.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/simulation/simulation.hpp"

namespace falko_slam {
namespace {

// A hall without reflectors and a vehicle that its controller knows badly.
Scenario bare_hall(std::vector<DriveStep> drive) {
  Scenario scenario;
  scenario.world.surfaces = {{"matt", 0.5, 0.0}};
  add_box(scenario.world.fixed, {}, {32.0, 28.0}, 0);
  add_box(scenario.world.fixed, {-10.0, 9.0, 0.3}, {2.4, 1.6}, 0);
  add_box(scenario.world.fixed, {11.0, 8.0, 0.0}, {1.2, 3.0}, 0);
  add_box(scenario.world.fixed, {9.5, -10.0, -0.2}, {3.0, 1.4}, 0);
  scenario.drive = std::move(drive);
  return scenario;
}

SegmentRecorderParams scan_recorder_params(const Scenario& scenario) {
  SegmentRecorderParams params = test::recorder_params(scenario);
  params.egomotion = EgomotionSource::kScans;
  return params;
}

std::vector<RecordedSegment> recorded_by_scans(const Scenario& scenario,
                                               const SegmentRecorderParams& params) {
  return test::recorded(scenario, params,
                        [&](const SimulationStep::Scan& scan, SegmentRecorder& recorder) {
                          ScanObservation observation;
                          normalize(as_raw_scan(scenario.laser, scan.scan), {}, observation.scan);
                          recorder.add(observation);
                          recorder.add(ReflectorObservation{scan.scan.first_beam, {}});  // left out
                        });
}

TEST(SegmentRecorderScans, CutsADriveAtItsHalts) {
  const std::vector<ArcStep> arcs = {{0.8, 0.5, kPi, 0.0}, {-0.8, -0.6, kPi / 2.0, 0.0}};
  const Scenario scenario = bare_hall({test::kHalt, arcs[0], test::kHalt, arcs[1], test::kHalt});
  const auto segments = recorded_by_scans(scenario, scan_recorder_params(scenario));

  ASSERT_EQ(segments.size(), 2U);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const RecordedSegment& found = segments[i];
    ASSERT_EQ(found.complaint, "") << i;
    EXPECT_EQ(found.egomotion, EgomotionSource::kScans);
    EXPECT_EQ(found.lost_scans, 0U);
    EXPECT_NEAR(std::abs(found.segment.turn), arcs[i].turn, 0.02);
    EXPECT_GT(found.scan_motion.parts, 15U);
    const TricycleParams& truth = scenario.vehicle.tricycle;
    const Pose2& mount = scenario.vehicle.base_T_laser;
    const Pose2 expected =
        mount.inverse() * drive_arc(truth, found.segment.ticks, found.segment.steering) * mount;
    const Pose2 error = expected.inverse() * found.segment.start_T_end.pose;
    EXPECT_LT(error.translation().norm(), 0.002) << i;
    EXPECT_LT(std::abs(error.theta()), 0.0005) << i;
  }
}

TEST(SegmentRecorderScans, NeedsWalls) {
  Scenario scenario = bare_hall({test::kHalt, ArcStep{0.8, 0.5, 1.0, 0.0}, test::kHalt});
  scenario.world.fixed.faces.clear();
  scenario.world.fixed.cylinders = {{{5.0, 3.0}, 0.2, 0}, {{-5.0, 1.0}, 0.2, 0}};
  const auto segments = recorded_by_scans(scenario, scan_recorder_params(scenario));

  ASSERT_EQ(segments.size(), 1U);
  EXPECT_NE(segments[0].complaint.find("straight walls"), std::string::npos)
      << segments[0].complaint;
}

// Readings and empty observations of reflectors ten times a second.
class HandFedRecorder {
 public:
  explicit HandFedRecorder(const SegmentRecorderParams& params) : recorder_(params) {}

  void drive(int steps, std::uint32_t ticks) {
    for (int i = 0; i < steps; ++i) {
      observe();
      recorder_.add(EncoderReading{now_, ticks_ += ticks, 9000});
    }
  }
  void observe() {
    recorder_.add(ReflectorObservation{now_, {}});
    now_ += std::chrono::milliseconds(100);
  }
  std::string complaint() {
    recorder_.finish();
    const auto segments = recorder_.take();
    return segments.size() == 1 ? segments.front().complaint : "not one segment";
  }
  const SegmentRecorder& recorder() const { return recorder_; }

 private:
  SegmentRecorder recorder_;
  Time now_{std::chrono::seconds(5)};
  std::uint32_t ticks_ = 0;
};

TEST(SegmentRecorderBounds, GivesUpAWayWithoutAnEnd) {
  SegmentRecorderParams params;
  params.max_scans_on_the_way = 50;
  HandFedRecorder fed(params);
  fed.drive(20, 0);
  fed.drive(60, 400);
  fed.drive(20, 0);
  EXPECT_EQ(fed.complaint(), "more than 50 scans on the way");
}

TEST(SegmentRecorderBounds, KeepsSoManyScansOfAHalt) {
  SegmentRecorderParams params;
  params.max_scans_at_rest = 10;
  HandFedRecorder fed(params);
  fed.drive(100, 0);
  EXPECT_EQ(fed.recorder().scans_at_rest(), 10U);
}

TEST(SegmentRecorderBounds, ComplainsOfEncodersThatWereSilent) {
  SegmentRecorderParams params;
  params.max_waiting_scans = 8;
  HandFedRecorder fed(params);
  for (int i = 0; i < 40; ++i) fed.observe();  // before the first reading nothing is missed
  fed.drive(20, 0);
  fed.drive(20, 400);
  for (int i = 0; i < 20; ++i) fed.observe();
  fed.drive(20, 400);
  fed.drive(20, 0);
  EXPECT_NE(fed.complaint().find("the encoders were silent while 1"), std::string::npos);
}

TEST(SegmentRecorderBounds, RefusesBadParameters) {
  SegmentRecorderParams params;
  params.max_waiting_scans = 0;
  EXPECT_THROW(SegmentRecorder{params}, std::invalid_argument);
  params = {};
  params.scans.min_agreement = 2.0;
  EXPECT_THROW(SegmentRecorder{params}, std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
