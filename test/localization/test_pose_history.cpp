// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/pose_history.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "localization/landmark_drive.hpp"

namespace falko_slam {
namespace {

struct Event {
  Time stamp{};
  bool is_motion = false;
  PoseEstimate motion;
  std::vector<LandmarkObservation> observations;
};

Time at(int milliseconds) { return Time(std::chrono::milliseconds(milliseconds)); }

std::shared_ptr<const LandmarkIndex> hall() {
  std::mt19937_64 random = test::seeded_random();
  return std::make_shared<LandmarkIndex>(test::scattered_landmarks(40, 20.0, 1.5, 0.003, random));
}

PoseHistory history_on(const std::shared_ptr<const LandmarkIndex>& map,
                       const PoseHistoryParams& params = {}) {
  return {LandmarkFilter({}, {{}, pose_covariance(0.05, 0.01)}, map), at(0), params};
}

// Motions every 20 ms, scans every 125 ms, of a vehicle on a circle.
std::vector<Event> drive(const LandmarkIndex& map) {
  std::mt19937_64 random = test::seeded_random();
  const PoseEstimate motion{{0.02, 0.0, 0.005}, pose_covariance(1e-3, 2e-4)};
  std::vector<Event> events;
  for (int i = 1; i <= 100; ++i) events.push_back({at(20 * i), true, motion, {}});
  for (int i = 1; i <= 15; ++i) {
    const double way = 125.0 * i / 20.0;
    const Pose2 truth = Pose2::exp(way * motion.pose.log());
    Event scan;
    scan.stamp = at(125 * i);
    for (std::size_t k = 0; k < 8; ++k) {
      scan.observations.push_back(
          test::noisy(test::seen(ObservationModel::kCartesian, truth, {},
                                 map.landmarks()[k].position, test::diagonal(0.01, 0.01)),
                      random));
    }
    events.push_back(scan);
  }
  const auto earlier = [](const Event& a, const Event& b) { return a.stamp < b.stamp; };
  std::stable_sort(events.begin(), events.end(), earlier);
  return events;
}

void feed(PoseHistory& history, const Event& event) {
  if (event.is_motion) {
    history.add_motion(event.stamp, event.motion);
  } else {
    history.add_observations(event.stamp, {event.observations, {}});
  }
}

void expect_same(const PoseHistory& a, const PoseHistory& b) {
  EXPECT_EQ(a.map_T_base().pose.x(), b.map_T_base().pose.x());
  EXPECT_EQ(a.map_T_base().pose.y(), b.map_T_base().pose.y());
  EXPECT_EQ(a.map_T_base().pose.theta(), b.map_T_base().pose.theta());
  EXPECT_EQ(a.map_T_base().covariance, b.map_T_base().covariance);
}

TEST(PoseHistory, GivesTheSameInWhateverOrderInputsCome) {
  const auto map = hall();
  const std::vector<Event> events = drive(*map);
  PoseHistoryParams params;
  params.span = 10.0;
  params.max_ahead = 10.0;
  PoseHistory in_order = history_on(map, params);
  for (const Event& event : events) feed(in_order, event);

  std::mt19937_64 random = test::seeded_random();
  for (int run = 0; run < 5; ++run) {
    std::vector<Event> shuffled = events;
    std::shuffle(shuffled.begin(), shuffled.end(), random);
    PoseHistory late = history_on(map, params);
    for (const Event& event : shuffled) feed(late, event);
    expect_same(late, in_order);
  }
}

TEST(PoseHistory, GivesTheSameWhereScansComeLateAndTheOldIsForgotten) {
  const auto map = hall();
  const std::vector<Event> events = drive(*map);
  PoseHistoryParams params;
  params.span = 0.4;
  PoseHistory in_order = history_on(map, params), late = history_on(map, params);
  for (const Event& event : events) feed(in_order, event);

  const auto arrival = [](const Event& event) {
    return event.stamp + std::chrono::milliseconds(event.is_motion ? 0 : 230);
  };
  std::vector<Event> delayed = events;
  std::stable_sort(delayed.begin(), delayed.end(),
                   [&](const Event& a, const Event& b) { return arrival(a) < arrival(b); });
  for (const Event& event : delayed) feed(late, event);
  expect_same(late, in_order);
  EXPECT_LT(late.inputs(), 40U);
}

// Some of what is seen is in no map and gets into the state: that must be undone and done anew.
TEST(PoseHistory, GivesTheSameWithLandmarksInTheState) {
  const auto map = hall();
  std::vector<Event> events = drive(*map);
  for (Event& event : events) {
    for (std::size_t k = 4; k < event.observations.size(); ++k) {
      event.observations[k].kind = LandmarkKind::kFeature;
    }
  }
  PoseHistory in_order = history_on(map), late = history_on(map);
  for (const Event& event : events) feed(in_order, event);
  EXPECT_EQ(in_order.filter().landmarks().size(), 4U);
  const auto arrival = [](const Event& event) {
    return event.stamp + std::chrono::milliseconds(event.is_motion ? 0 : 470);
  };
  std::stable_sort(events.begin(), events.end(),
                   [&](const Event& a, const Event& b) { return arrival(a) < arrival(b); });
  for (const Event& event : events) feed(late, event);
  expect_same(late, in_order);
  EXPECT_EQ(late.filter().covariance(), in_order.filter().covariance());
}

TEST(PoseHistory, IsThePlainFilterWhereMotionsEndAtTheScans) {
  const auto map = hall();
  std::vector<Event> events = drive(*map);
  PoseHistory history = history_on(map);
  LandmarkFilter filter({}, {{}, pose_covariance(0.05, 0.01)}, map);
  for (Event& event : events) {
    if (event.is_motion) {
      history.add_motion(event.stamp, event.motion);
      filter.predict(event.motion);
    } else if (event.stamp.time_since_epoch() % std::chrono::milliseconds(20) == Duration(0)) {
      const InputReport report = history.add_observations(event.stamp, {event.observations, {}});
      ASSERT_TRUE(report.update);
      EXPECT_EQ(report.update->nis, filter.update(event.stamp, {event.observations, {}}).nis);
    }
  }
  EXPECT_EQ(history.map_T_base().pose.x(), filter.map_T_base().pose.x());
  EXPECT_EQ(history.map_T_base().covariance, filter.map_T_base().covariance);
}

TEST(PoseHistory, CutsAMotionWhereAScanLiesInBetween) {
  const auto map = hall();
  PoseHistory history = history_on(map);
  const PoseEstimate motion{{1.0, 0.0, 0.4}, pose_covariance(0.1, 0.02)};
  history.add_observations(at(30), {});
  history.add_motion(at(100), motion);
  PoseHistory whole = history_on(map);
  whole.add_motion(at(100), motion);
  EXPECT_LT(difference(history.map_T_base().pose, whole.map_T_base().pose).norm(), 1e-12);
  const Eigen::Matrix3d ratio =
      history.map_T_base().covariance.cwiseQuotient(whole.map_T_base().covariance);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(ratio(i, i), 1.0, 0.05);
}

TEST(PoseHistory, SaysWhatBecameOfAnInput) {
  const auto map = hall();
  PoseHistory history = history_on(map);
  const PoseEstimate motion{{0.02, 0.0, 0.0}, pose_covariance(1e-3, 1e-4)};
  PoseEstimate broken = motion;
  broken.covariance(0, 0) = std::nan("");
  EXPECT_EQ(history.add_motion(at(0), motion), InputVerdict::kRepeated);
  EXPECT_EQ(history.add_motion(at(-1), motion), InputVerdict::kTooOld);
  EXPECT_EQ(history.add_motion(at(20), broken), InputVerdict::kInvalid);
  EXPECT_EQ(history.add_motion(at(20), motion), InputVerdict::kInOrder);
  EXPECT_EQ(history.add_motion(at(60), motion), InputVerdict::kInOrder);
  EXPECT_EQ(history.add_motion(at(40), motion), InputVerdict::kLate);
  EXPECT_EQ(history.add_motion(at(40), motion), InputVerdict::kRepeated);
  EXPECT_EQ(history.add_observations(at(30), {}).verdict, InputVerdict::kLate);
  EXPECT_EQ(history.add_observations(at(500), {}).verdict, InputVerdict::kInOrder);
  EXPECT_EQ(history.add_observations(at(600), {}).verdict, InputVerdict::kTooNew);
  EXPECT_EQ(history.add_motion(at(5000), motion), InputVerdict::kInOrder);
  EXPECT_EQ(history.add_observations(at(50), {}).verdict, InputVerdict::kTooOld);
}

TEST(PoseHistory, GoesOnAfterAClockWasSetBackAndItWasToldSo) {
  const auto map = hall();
  PoseHistory history = history_on(map);
  const PoseEstimate motion{{0.02, 0.0, 0.0}, pose_covariance(1e-3, 1e-4)};
  history.add_motion(at(9000), motion);
  const double x = history.map_T_base().pose.x();
  EXPECT_EQ(history.add_motion(at(100), motion), InputVerdict::kTooOld);
  history.restart(at(100));
  EXPECT_EQ(history.map_T_base().pose.x(), x);
  EXPECT_EQ(history.add_motion(at(120), motion), InputVerdict::kInOrder);
  EXPECT_NEAR(history.map_T_base().pose.x(), x + 0.02, 1e-12);
}

TEST(PoseHistory, HoldsNoMoreThanItMay) {
  const auto map = hall();
  PoseHistoryParams params;
  params.max_inputs = 50;
  params.span = 60.0;
  PoseHistory history = history_on(map, params);
  const PoseEstimate motion{{1e-4, 0.0, 0.0}, pose_covariance(1e-4, 1e-4)};
  for (int i = 1; i < 1000; ++i) history.add_motion(at(i), motion);
  EXPECT_LE(history.inputs(), 50U);
  InputVerdict verdict = InputVerdict::kInOrder;
  for (int i = 0; i < 100; ++i) verdict = history.add_observations(at(1000), {}).verdict;
  EXPECT_EQ(verdict, InputVerdict::kTooMany);
  EXPECT_LE(history.inputs(), 50U);
}

TEST(PoseHistoryParams, AreValidated) {
  PoseHistoryParams params;
  params.span = -1.0;
  EXPECT_THROW(validate(params), std::invalid_argument);
  params = {};
  params.max_ahead = std::nan("");
  EXPECT_THROW(validate(params), std::invalid_argument);
  params = {};
  params.max_inputs = 0;
  EXPECT_THROW(history_on(hall(), params), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
