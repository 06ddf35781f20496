// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <falko_slam/GlobalLocalization.h>
#include <falko_slam/LoadKeyframes.h>
#include <falko_slam/SaveKeyframes.h>
#include <gtest/gtest.h>
#include <visualization_msgs/MarkerArray.h>

#include <cmath>
#include <memory>

#include "loop_client.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

using test::LoadedLoopClosure;
using test::LoopClient;
using test::spin_until;

constexpr double kStep = 0.5;
const Pose2 kStart{20.0, -7.0, 1.0};  // where the odometry has the office's frame

Pose2 pose_of(const geometry_msgs::Pose& pose) {
  return {pose.position.x, pose.position.y,
          2.0 * std::atan2(pose.orientation.z, pose.orientation.w)};
}

GlobalLocalization of_scan(const sensor_msgs::LaserScan& scan) {
  GlobalLocalization call;
  call.request.scan = scan;
  return call;
}
SaveKeyframes to_file(const std::string& name) {
  SaveKeyframes call;
  call.request.file = name;
  return call;
}
LoadKeyframes from_file(const std::string& name) {
  LoadKeyframes call;
  call.request.file = name;
  return call;
}

// Twice round the office, the second time beside the first, with an odometry that drifts.
class TwiceRound : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<test::TemporaryFolder>();
    closure_ = std::make_unique<LoadedLoopClosure>("/twice_round", folder_->path());
    ASSERT_TRUE(closure_->loaded);
    LoopClient& client = closure_->client;
    ASSERT_TRUE(client.connected());
    const auto lap = office_path(kStep);
    lap_ = lap.size();
    Pose2 odometry = kStart * lap[0];
    for (std::size_t i = 0; i < 2 * lap_; ++i) {
      truth_.push_back(i < lap_ ? lap[i] : lap[i - lap_] * Pose2(0.15, 0.1, 0.1));
      if (i > 0) {
        const Pose2 step = truth_[i - 1].inverse() * truth_[i];
        odometry = odometry * Pose2(1.02 * step.translation(), step.theta() + 0.001);
      }
      ASSERT_TRUE(client.step(truth_[i], odometry)) << i;
      ASSERT_EQ(client.keyframes.size(), i + 1);
    }
    last_odometry_ = odometry;
  }
  static void TearDownTestSuite() {
    closure_.reset();
    folder_.reset();
    truth_.clear();
  }

  static LoopClient& client() { return closure_->client; }
  static Pose2 laser(std::size_t i) { return truth_[i] * test::kBaseTLaser; }

  static inline std::unique_ptr<test::TemporaryFolder> folder_;
  static inline std::unique_ptr<LoadedLoopClosure> closure_;
  static inline std::vector<Pose2> truth_;
  static inline std::size_t lap_ = 0;
  static inline Pose2 last_odometry_;
};

TEST_F(TwiceRound, PublishesAKeyframeForEveryStep) {
  const auto& keyframes = client().keyframes;
  ASSERT_EQ(keyframes.size(), truth_.size());
  EXPECT_EQ(client().resets, 1U);
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    EXPECT_EQ(keyframes[i].id, i);
    EXPECT_EQ(keyframes[i].drive, 0U);
    EXPECT_EQ(keyframes[i].header.frame_id, "twice_round_odom");
    EXPECT_EQ(keyframes[i].scan.ranges.size(), 360U);
    EXPECT_GT(keyframes[i].keypoints, 0U);
    const Pose2 mount = pose_of(keyframes[i].base_T_keyframe);
    EXPECT_LT((mount.inverse() * test::kBaseTLaser).log().norm(), 1e-6);
  }
  const Pose2 last = pose_of(keyframes.back().odom_T_keyframe);
  EXPECT_LT((last.inverse() * last_odometry_ * test::kBaseTLaser).log().norm(), 1e-6);
}

TEST_F(TwiceRound, ClosesTheSecondRoundWithTheTruePose) {
  std::size_t accepted = 0;
  std::size_t refused = 0;
  ASSERT_EQ(client().constraints.size(), truth_.size());
  for (std::size_t i = lap_; i < truth_.size(); ++i) {
    for (const LoopConstraint& constraint : client().constraints[i].constraints) {
      ASSERT_EQ(constraint.source, i);
      EXPECT_EQ(constraint.accepted, constraint.verdict == LoopConstraint::ACCEPTED);
      EXPECT_FALSE(constraint.reason.empty());
      refused += constraint.accepted ? 0U : 1U;
      if (!constraint.accepted) continue;
      ++accepted;
      const Pose2 error =
          laser(i).inverse() * laser(constraint.target) * pose_of(constraint.target_T_source.pose);
      EXPECT_LT(error.translation().norm(), 0.1) << i;
      EXPECT_LT(std::abs(error.theta()), 0.05) << i;
      EXPECT_GT(constraint.target_T_source.covariance[0], 0.0);
      EXPECT_EQ(constraint.target_stamp, client().keyframes[constraint.target].header.stamp);
    }
  }
  EXPECT_GT(accepted, lap_ / 2);
  EXPECT_GT(refused, lap_);
}

TEST_F(TwiceRound, LocatesAScanThatItIsGiven) {
  const std::size_t there = 12;
  const Pose2 beside = truth_[there] * Pose2(0.1, 0.05, -0.3);
  const GlobalLocalization answer =
      closure_->call("global_localization", of_scan(client().scan_at(beside)));
  ASSERT_TRUE(answer.response.success) << answer.response.message;
  ASSERT_FALSE(answer.response.hypotheses.empty());
  EXPECT_LE(answer.response.hypotheses.size(), 5U);
  EXPECT_EQ(answer.response.header.frame_id, "twice_round_odom");
  const PlaceHypothesis& best = answer.response.hypotheses[0];
  // The base, in the odometry of the keyframe.
  const Pose2 odom_T_laser = pose_of(client().keyframes[best.keyframe].odom_T_keyframe);
  const Pose2 expected = odom_T_laser * (laser(best.keyframe).inverse() * beside);
  EXPECT_LT((expected.inverse() * pose_of(best.pose.pose)).translation().norm(), 0.1);
  EXPECT_TRUE(best.current_drive);
}

TEST_F(TwiceRound, LocatesTheLastScanIfItIsGivenNone) {
  GlobalLocalization call;
  call.request.max_hypotheses = 1;
  const GlobalLocalization answer = closure_->call("global_localization", call);
  ASSERT_TRUE(answer.response.success) << answer.response.message;
  EXPECT_EQ(answer.response.hypotheses.size(), 1U);
  EXPECT_EQ(answer.response.header.stamp, client().keyframes.back().header.stamp);
}

TEST_F(TwiceRound, SaysWhyAScanCannotBeLocated) {
  sensor_msgs::LaserScan scan = client().scan_at(truth_[0]);
  scan.header.frame_id = "nowhere";
  const auto lost = closure_->call("global_localization", of_scan(scan)).response;
  EXPECT_FALSE(lost.success);
  EXPECT_NE(lost.message.find("nowhere"), std::string::npos) << lost.message;
  scan.header.frame_id = "laser";
  std::fill(scan.ranges.begin(), scan.ranges.end(), 0.0F);
  const auto blind = closure_->call("global_localization", of_scan(scan)).response;
  EXPECT_FALSE(blind.success);
  EXPECT_NE(blind.message.find("360 zero"), std::string::npos) << blind.message;
}

TEST_F(TwiceRound, DrawsKeyframesAndLoops) {
  visualization_msgs::MarkerArrayConstPtr markers;
  const auto subscriber = client().node().subscribe<visualization_msgs::MarkerArray>(
      "loop_markers", 1, [&](const auto& message) { markers = message; });
  ASSERT_TRUE(spin_until([&] { return markers != nullptr; }));
  std::size_t keyframes = 0;
  std::size_t accepted = 0;
  for (const auto& marker : markers->markers) {
    EXPECT_EQ(marker.header.frame_id, "twice_round_odom");
    if (marker.ns == "keyframes") keyframes = marker.points.size();
    if (marker.ns == "accepted_loops") accepted = marker.points.size() / 2;
  }
  EXPECT_EQ(keyframes, truth_.size());
  EXPECT_GT(accepted, lap_ / 2);
}

TEST_F(TwiceRound, SavesAndALaterOneLoadsAndFindsItsPlace) {
  const auto saved = closure_->call("save_keyframes", to_file("office/a.keyframes")).response;
  ASSERT_TRUE(saved.success) << saved.message;
  EXPECT_EQ(saved.keyframes, truth_.size());

  LoadedLoopClosure later("/later", folder_->path());
  ASSERT_TRUE(later.loaded && later.client.connected());
  later.client.set_time(client().stamp().toSec() + 100.0);
  const auto loaded = later.call("load_keyframes", from_file("office/a.keyframes")).response;
  ASSERT_TRUE(loaded.success) << loaded.message;
  EXPECT_EQ(loaded.keyframes, truth_.size());
  ASSERT_TRUE(spin_until([&] { return later.client.keyframes.size() == truth_.size(); }));

  const auto answer =
      later.call("global_localization", of_scan(later.client.scan_at(truth_[20]))).response;
  ASSERT_TRUE(answer.success) << answer.message;
  EXPECT_FALSE(answer.hypotheses[0].current_drive);
  const PlaceHypothesis& best = answer.hypotheses[0];
  const Pose2 expected = pose_of(later.client.keyframes[best.keyframe].odom_T_keyframe) *
                         (laser(best.keyframe).inverse() * truth_[20]);
  EXPECT_LT((expected.inverse() * pose_of(best.pose.pose)).translation().norm(), 0.1);
}

// The odometry has started elsewhere: it closes with the first drive, before any way was driven.
TEST_F(TwiceRound, ClosesADriveWithTheDatabaseItBeganWith) {
  ASSERT_TRUE(closure_->call("save_keyframes", to_file("b.keyframes")).response.success);
  LoadedLoopClosure later("/with_database", folder_->path(), "b.keyframes");
  ASSERT_TRUE(later.loaded && later.client.connected());
  ASSERT_TRUE(spin_until([&] { return later.client.keyframes.size() == truth_.size(); }));
  later.client.set_time(client().stamp().toSec() + 200.0);
  std::size_t accepted = 0;
  for (std::size_t i = 0; i < 16; ++i) {
    const Pose2 pose = truth_[i] * Pose2(0.1, -0.1, 0.0);
    ASSERT_TRUE(later.client.step(pose, Pose2(300.0, 0.0, -2.0) * pose)) << i;
    EXPECT_EQ(later.client.keyframes.back().drive, 1U);
    EXPECT_EQ(later.client.keyframes.back().id, truth_.size() + i);
    for (const LoopConstraint& constraint : later.client.constraints.back().constraints) {
      if (!constraint.accepted) continue;
      ++accepted;
      const Pose2 error = (pose * test::kBaseTLaser).inverse() * laser(constraint.target) *
                          pose_of(constraint.target_T_source.pose);
      EXPECT_LT(error.translation().norm(), 0.1) << i;
    }
  }
  EXPECT_GT(accepted, 4U);
}

TEST_F(TwiceRound, RefusesFilesOutsideOfItsFolderAndThingsThatAreNoKeyframes) {
  for (const char* name : {"../a", "/tmp/a", "", "x/../../a"}) {
    const auto saved = closure_->call("save_keyframes", to_file(name)).response;
    EXPECT_FALSE(saved.success) << name;
    EXPECT_NE(saved.message.find("file name '" + std::string(name) + "'"), std::string::npos)
        << saved.message;
    EXPECT_FALSE(closure_->call("load_keyframes", from_file(name)).response.success) << name;
  }
  const std::string path = folder_->write("notes.txt", "to be kept");
  const auto saved = closure_->call("save_keyframes", to_file("notes.txt")).response;
  EXPECT_FALSE(saved.success);
  const auto loaded = closure_->call("load_keyframes", from_file("notes.txt")).response;
  EXPECT_FALSE(loaded.success);
  EXPECT_EQ(loaded.message, path + ": no file of keyframes");
  // And what was there is there.
  GlobalLocalization call;
  EXPECT_TRUE(closure_->call("global_localization", call).response.success);
}

class LoopClosure : public ::testing::Test {
 protected:
  // The newest status of the nodelet.
  void watch(LoopClient& client) {
    const std::string name = client.node().resolveName("loop_closure").substr(1) + ": loop closure";
    subscriber_ = client.node().subscribe<diagnostic_msgs::DiagnosticArray>(
        "/diagnostics", 10, [this, name](const diagnostic_msgs::DiagnosticArrayConstPtr& message) {
          for (const auto& entry : message->status) {
            if (entry.name == name) status_ = entry;
          }
        });
  }

  test::TemporaryFolder folder_;
  ros::Subscriber subscriber_;
  diagnostic_msgs::DiagnosticStatus status_;
};

TEST_F(LoopClosure, AnswersBeforeThereIsAnyKeyframe) {
  LoadedLoopClosure closure("/empty", folder_.path());
  ASSERT_TRUE(closure.loaded);
  const auto place = closure.call("global_localization", GlobalLocalization()).response;
  EXPECT_FALSE(place.success);
  EXPECT_EQ(place.message, "no usable scan has been received, and none was given");
  const auto given =
      closure.call("global_localization", of_scan(closure.client.scan_at({}))).response;
  EXPECT_EQ(given.message, "there are no keyframes yet");
  const auto saved = closure.call("save_keyframes", to_file("a")).response;
  EXPECT_FALSE(saved.success);
  EXPECT_NE(saved.message.find("there is no keyframe to save"), std::string::npos);
  EXPECT_TRUE(folder_.names().empty());
}

TEST_F(LoopClosure, NamesTheTransformThatIsMissing) {
  LoadedLoopClosure closure("/without_tf", folder_.path());
  ASSERT_TRUE(closure.loaded && closure.client.connected());
  watch(closure.client);
  EXPECT_TRUE(spin_until([&] {
    closure.client.send(closure.client.scan_at({}));
    return status_.message.find("scans dropped") != std::string::npos;
  }));
  EXPECT_EQ(static_cast<int>(status_.level), diagnostic_msgs::DiagnosticStatus::WARN);
  EXPECT_NE(status_.message.find("no transform from laser to without_tf_odom"), std::string::npos)
      << status_.message;
}

TEST_F(LoopClosure, SurvivesBadScans) {
  LoadedLoopClosure closure("/bad_scans", folder_.path());
  ASSERT_TRUE(closure.loaded && closure.client.connected());
  watch(closure.client);
  sensor_msgs::LaserScan scan = closure.client.scan_at({});
  scan.ranges.clear();
  closure.client.send_odometry({});
  EXPECT_TRUE(spin_until([&] {
    closure.client.send(scan);
    return status_.message.find("unusable scan") != std::string::npos;
  }));
  scan = closure.client.scan_at({});
  std::fill(scan.ranges.begin(), scan.ranges.end(), std::nanf(""));
  closure.client.send_odometry({});
  closure.client.send(scan);
  scan.header.frame_id = "";
  closure.client.send(scan);
  ASSERT_TRUE(closure.client.step({}, {}));
  EXPECT_EQ(closure.client.keyframes.size(), 1U);
}

TEST_F(LoopClosure, TakesAScanOnlyAfterTheStepOrTheTurn) {
  LoadedLoopClosure closure("/steps", folder_.path());
  ASSERT_TRUE(closure.loaded && closure.client.connected());
  ASSERT_TRUE(closure.client.step({}, {}));
  const auto pass = [&](const Pose2& pose) {
    const auto scan = closure.client.scan_at(pose);
    closure.client.send_odometry(pose);
    closure.client.send(scan);
  };
  pass({0.1, 0.0, 0.0});
  pass({0.0, 0.0, 0.3});
  ASSERT_TRUE(closure.client.step({0.25, 0.0, 0.0}, {0.25, 0.0, 0.0}));
  ASSERT_TRUE(closure.client.step({0.25, 0.0, 0.4}, {0.25, 0.0, 0.4}));
  EXPECT_EQ(closure.client.keyframes.size(), 3U);
}

TEST_F(LoopClosure, BeginsADriveWhenTimeJumpsBackAndWhenTheOdometryIsReset) {
  LoadedLoopClosure closure("/jumps", folder_.path());
  LoopClient& client = closure.client;
  ASSERT_TRUE(closure.loaded && client.connected());
  client.set_time(5000.0);
  ASSERT_TRUE(client.step({}, {}));
  ASSERT_TRUE(client.step({0.5, 0.0, 0.0}, {0.5, 0.0, 0.0}));
  EXPECT_EQ(client.keyframes.back().drive, 0U);
  client.set_time(2000.0);
  ASSERT_TRUE(client.step({0.6, 0.0, 0.0}, {0.6, 0.0, 0.0}));
  EXPECT_EQ(client.keyframes.back().drive, 1U);
  EXPECT_EQ(client.keyframes.back().path, 0.0);
  // A transform of the time before that was late.
  client.send_odometry_of(ros::Time(5000.5), {0.5, 0.0, 0.0});
  ASSERT_TRUE(client.step({0.9, 0.0, 0.0}, {0.9, 0.0, 0.0}));
  EXPECT_EQ(client.keyframes.back().drive, 1U);
  ASSERT_TRUE(client.step({0.7, 0.0, 0.0}, {50.0, 0.0, 0.0}));
  EXPECT_EQ(client.keyframes.back().drive, 2U);
  // From there on it takes a step again.
  const std::size_t count = client.keyframes.size();
  const auto near = client.scan_at({0.8, 0.0, 0.0});
  client.send_odometry({50.1, 0.0, 0.0});
  client.send(near);
  ASSERT_TRUE(client.step({1.2, 0.0, 0.0}, {50.5, 0.0, 0.0}));
  EXPECT_EQ(client.keyframes.size(), count + 1);
}

TEST_F(LoopClosure, DoesNotLoadWithBadParametersOrADatabaseThatIsNone) {
  nodelet::Loader loader(false);
  ros::NodeHandle node("/refused_loops");
  const auto loads = [&] {
    return loader.load("/refused_loops", "falko_slam/LoopClosure", {}, {});
  };
  node.setParam("loops/min_score", 1.5);
  EXPECT_FALSE(loads());
  node.setParam("loops/min_score", 0.5);
  node.setParam("database", folder_.write("database", "FALKOKEY"));
  EXPECT_FALSE(loads());
  node.setParam("database", "");
  EXPECT_TRUE(loads());
}

class LaunchedLoopClosure : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Ways, LaunchedLoopClosure, ::testing::Values("as_nodelet", "as_node"),
                         [](const auto& way) { return std::string(way.param); });

TEST_P(LaunchedLoopClosure, MakesKeyframes) {
  LoopClient client(GetParam(), "launched_odom");
  ASSERT_TRUE(client.connected());
  client.set_time(ros::Time::now().toSec() + 5000.0);  // both ways hear the same tf
  ASSERT_TRUE(client.step({}, {}));
  ASSERT_TRUE(client.step({1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}));
  GlobalLocalization call;
  ASSERT_TRUE(
      ros::service::call(client.node().resolveName("loop_closure/global_localization"), call));
  EXPECT_TRUE(call.response.success) << call.response.message;
}

}  // namespace
}  // namespace falko_slam

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_loop_closure_nodelet");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
