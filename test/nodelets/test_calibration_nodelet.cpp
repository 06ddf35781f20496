// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <nodelet/loader.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "calibration_client.hpp"
#include "falko_slam/calibration/calibration_file.hpp"
#include "falko_slam/common/whole_file.hpp"
#include "falko_slam/simulation/vehicle_model.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

using test::CalibrationClient;
using test::spin_until;
using State = actionlib::SimpleClientGoalState;

// One whole calibration for all tests; what they leave behind does not touch it.
class Calibrated : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    temporary_ = std::make_unique<test::TemporaryFolder>();
    folder_ = temporary_->path();
    ros::param::set("/calibration/folder", folder_);
    loader_ = std::make_unique<nodelet::Loader>(false);
    ASSERT_TRUE(loader_->load("/calibration", "falko_slam/Calibration", {}, {}));
    client_ = std::make_unique<CalibrationClient>("");
    ASSERT_TRUE(client_->ready());
    client_->start();
    ASSERT_TRUE(client_->ended());
    state_ = client_->state().state_;
    result_ = client_->result();
    feedback_ = client_->feedback;
  }
  static void TearDownTestSuite() {
    client_.reset();
    loader_.reset();
    temporary_.reset();
  }
  static std::string file() { return folder_ + "/calibration.yaml"; }

  static CalibrationClient& client() { return *client_; }
  static inline std::unique_ptr<test::TemporaryFolder> temporary_;
  static inline std::unique_ptr<nodelet::Loader> loader_;
  static inline std::unique_ptr<CalibrationClient> client_;
  static inline State::StateEnum state_ = State::PENDING;
  static inline CalibrateResult result_;
  static inline std::vector<CalibrateFeedback> feedback_;
  static inline std::string folder_;
};

TEST_F(Calibrated, FindsTheVehicleAndWritesItDown) {
  ASSERT_EQ(state_, State::SUCCEEDED) << result_.message;
  EXPECT_EQ(result_.outcome.file, file()) << result_.message;
  const StoredCalibration stored = read_calibration(file());
  const VehicleModel truth;
  const TricycleParams& found = stored.calibration.tricycle;
  EXPECT_NEAR(found.driving_scale, truth.tricycle.driving_scale, 1e-6);
  EXPECT_NEAR(found.steer_offset_forward, truth.tricycle.steer_offset_forward, 0.005);
  EXPECT_NEAR(found.steer_offset_backward, truth.tricycle.steer_offset_backward, 0.005);
  EXPECT_NEAR(stored.calibration.base_T_laser.x(), truth.base_T_laser.x(), 0.005);
  EXPECT_NEAR(stored.calibration.base_T_laser.y(), truth.base_T_laser.y(), 0.005);
  EXPECT_NEAR(stored.calibration.base_T_laser.theta(), truth.base_T_laser.theta(), 0.002);
}

TEST_F(Calibrated, TellsTheSameInTheResultAsInTheFile) {
  ASSERT_EQ(result_.outcome.parameters.size(), kCalibrationParameters);
  ASSERT_EQ(result_.outcome.covariance.size(), 64U);
  const StoredCalibration stored = read_calibration(file());
  const CalibrationVector values = vector_of(stored.calibration);
  for (std::size_t i = 0; i < kCalibrationParameters; ++i) {
    const CalibratedParameter& parameter = result_.outcome.parameters[i];
    const auto row = static_cast<Eigen::Index>(i);
    EXPECT_EQ(parameter.name, name_of(static_cast<CalibrationParameter>(i)));
    EXPECT_EQ(parameter.value, values(row));
    EXPECT_EQ(parameter.low, stored.intervals[i].low);
    EXPECT_EQ(result_.outcome.covariance[9 * i], stored.covariance(row, row));
  }
}

TEST_F(Calibrated, TellsHowFarItIsAndWhatTheArcsWere) {
  ASSERT_FALSE(feedback_.empty());
  double fraction = 0.0;
  for (const CalibrateFeedback& feedback : feedback_) {
    EXPECT_GE(feedback.fraction, fraction);
    fraction = feedback.fraction;
    EXPECT_EQ(feedback.arcs, 8);
  }
  EXPECT_GT(feedback_.back().driven.size(), 5U);
  ASSERT_EQ(result_.outcome.arcs.size(), 8U);
  EXPECT_EQ(result_.outcome.arcs.front().phase, "forward left");
  EXPECT_EQ(result_.outcome.arcs.back().phase, "backward right");
  for (const CalibrationArc& arc : result_.outcome.arcs) {
    EXPECT_EQ(arc.complaint, "");
    EXPECT_NEAR(std::abs(arc.turn), 2.6, 0.1);
    EXPECT_GE(arc.reflectors, 3U);
    EXPECT_LT(std::hypot(arc.residual.x, arc.residual.y), 0.02);
  }
}

TEST_F(Calibrated, APreemptedOneHaltsAndLeavesTheFileAlone) {
  const std::string before = read_whole_file(file());
  for (const auto& [stage, arc] : {std::pair("driving", 1), {"resting", 2}, {"driving", 2}}) {
    client().start();
    ASSERT_TRUE(client().in_stage(stage, arc)) << stage << " " << arc;
    client().cancel();
    ASSERT_TRUE(client().ended());
    EXPECT_EQ(client().state().state_, State::PREEMPTED);
    EXPECT_EQ(client().result().message, "preempted");
    ASSERT_FALSE(client().commands.empty());
    EXPECT_EQ(client().commands.back().wheel_speed, 0.0);
    const std::uint32_t ticks = client().ticks;
    test::spin_for(0.3);
    EXPECT_EQ(client().ticks, ticks);
    EXPECT_EQ(read_whole_file(file()), before);
  }
}

TEST_F(Calibrated, ANewGoalBeginsWhenTheOldOneHasHalted) {
  CalibrationClient second("");
  ASSERT_TRUE(second.ready());
  client().start();
  ASSERT_TRUE(client().in_stage("driving", 1));
  second.go_on();
  ASSERT_TRUE(client().ended());
  EXPECT_EQ(client().state().state_, State::PREEMPTED);
  EXPECT_TRUE(second.in_stage("driving", 1));
  second.cancel();
  EXPECT_TRUE(second.ended());
}

struct BadGoal {
  const char* complaint;
  CalibrateGoal goal;
};
std::vector<BadGoal> bad_goals() {
  std::vector<BadGoal> goals(6);
  goals[0].complaint = "max_distance = 1.00: the arcs lead";
  goals[0].goal.max_distance = 1.0;
  goals[1].complaint = "model = differential: must be";
  goals[1].goal.model = "differential";
  goals[2].complaint = "max_steering = 3: must be in";
  goals[2].goal.max_steering = 3.0;
  goals[3].complaint = "arcs_per_phase = -2: must be in";
  goals[3].goal.arcs_per_phase = -2;
  goals[4].complaint = "must not hold '..'";
  goals[4].goal.file = "../calibration.yaml";
  goals[5].complaint = "turn = nan: must be in";
  goals[5].goal.turn = std::numeric_limits<double>::quiet_NaN();
  return goals;
}

TEST_F(Calibrated, RefusesBadGoalsBeforeAnythingMoves) {
  for (const BadGoal& bad : bad_goals()) {
    client().start(bad.goal);
    ASSERT_TRUE(client().ended());
    EXPECT_EQ(client().state().state_, State::ABORTED);
    EXPECT_NE(client().result().message.find(bad.complaint), std::string::npos)
        << client().result().message;
    for (const DriveCommand& command : client().commands) EXPECT_EQ(command.wheel_speed, 0.0);
  }
}

TEST_F(Calibrated, ComputesTheSameFromTheArcsThatItGave) {
  ComputeCalibration::Request request;
  request.arcs = result_.outcome.arcs;
  request.file = "again/computed.yaml";
  request.accept_weak = true;
  const ComputeCalibration::Response response = client().compute(request);
  ASSERT_TRUE(response.success) << response.message;
  EXPECT_EQ(response.outcome.file, folder_ + "/again/computed.yaml");
  EXPECT_TRUE(std::filesystem::exists(response.outcome.file));
  for (std::size_t i = 0; i < kCalibrationParameters; ++i) {  // but for the ranges' common offset
    const CalibratedParameter& given = result_.outcome.parameters[i];
    EXPECT_NEAR(response.outcome.parameters[i].value, given.value, 5.0 * given.deviation) << i;
  }
}

TEST_F(Calibrated, GivesNoNumberFromArcsToOneSideAndWritesNothing) {
  ComputeCalibration::Request request;
  for (const CalibrationArc& arc : result_.outcome.arcs) {
    if (arc.steering > 0.0) request.arcs.push_back(arc);
  }
  request.file = "left.yaml";
  const ComputeCalibration::Response response = client().compute(request);
  EXPECT_FALSE(response.success);
  EXPECT_EQ(response.outcome.verdict, "UNOBSERVABLE");
  EXPECT_TRUE(response.outcome.parameters.empty());
  EXPECT_NE(response.message.find("leave out right"), std::string::npos) << response.message;
  EXPECT_FALSE(std::filesystem::exists(folder_ + "/left.yaml"));
}

TEST_F(Calibrated, SaysWhatIsWrongWithGivenArcsAndFiles) {
  ComputeCalibration::Request request;
  request.arcs = result_.outcome.arcs;
  request.arcs[2].ticks = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(client().compute(request).message.find("segments[3].ticks"), std::string::npos);
  request.arcs = result_.outcome.arcs;
  request.accept_weak = true;
  request.file = "/etc/calibration.yaml";
  EXPECT_NE(client().compute(request).message.find("must be relative"), std::string::npos);
  std::ofstream(folder_ + "/taken") << "a file";
  request.file = "taken/calibration.yaml";
  const ComputeCalibration::Response response = client().compute(request);
  EXPECT_FALSE(response.success);
  EXPECT_NE(response.message.find("taken"), std::string::npos) << response.message;
}

TEST(Disobeyed, GivesUpAsANodeOfItsOwn) {
  CalibrationClient client("disobeyed");
  ASSERT_TRUE(client.ready());
  client.start();
  ASSERT_TRUE(client.ended());
  EXPECT_EQ(client.state().state_, State::ABORTED);
  EXPECT_EQ(client.result().message, "the vehicle does not obey: steering");
  EXPECT_TRUE(client.result().outcome.parameters.empty());
}

TEST(Deaf, MovesNothingWithoutEncoders) {
  CalibrationClient client("deaf");
  ASSERT_TRUE(client.ready());
  client.start();
  ASSERT_TRUE(client.ended());
  EXPECT_EQ(client.state().state_, State::ABORTED);
  EXPECT_EQ(client.result().message, "no encoder readings");
  for (const DriveCommand& command : client.commands) EXPECT_EQ(command.wheel_speed, 0.0);
}

}  // namespace
}  // namespace falko_slam

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_calibration_nodelet");
  ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
