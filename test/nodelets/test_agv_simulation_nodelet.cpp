// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A whole vehicle in the simulated warehouse: launch/agv_simulation.launch.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <falko_slam/LocalizerStatus.h>
#include <falko_slam/SetMode.h>
#include <geometry_msgs/PoseStamped.h>
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <nodelet/NodeletList.h>
#include <nodelet/NodeletUnload.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/String.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "spin_until.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using test::spin_until;

constexpr double kDeadline = 60.0;  // for machines that are busy with other tests [s]

// Hears what the vehicle says.
class VehicleClient {
 public:
  VehicleClient() {
    hear<std_msgs::String>("agv/mode", [this](const auto& m) { mode = m.data; });
    hear<LocalizerStatus>("status", [this](const auto& m) { status = m; });
    hear<nav_msgs::Odometry>("odometry", [this](const auto& m) { pose = m.pose.pose.position; });
    hear<geometry_msgs::PoseStamped>("ground_truth",
                                     [this](const auto& m) { truth = m.pose.position; });
    hear<nav_msgs::Path>("path", [this](const auto& m) { keyframes = m.poses.size(); });
    hear<diagnostic_msgs::DiagnosticArray>("/diagnostics", [this](const auto& m) {
      for (const DiagnosticStatus& entry : m.status) diagnostics[entry.name] = entry;
    });
  }

  bool localized() const {
    return status && status->level == LocalizerStatus::OK && pose && truth &&
           error() < 0.2;  // stamps differ a little
  }
  double error() const { return std::hypot(pose->x - truth->x, pose->y - truth->y); }
  bool says(const std::string& name, const std::string& words, int level) const {
    const auto found = diagnostics.find(name);
    return found != diagnostics.end() && found->second.level == level &&
           found->second.message.find(words) != std::string::npos;
  }
  std::string told(const std::string& name) { return diagnostics[name].message; }

  std::string mode;
  std::optional<LocalizerStatus> status;
  std::optional<geometry_msgs::Point> pose, truth;
  std::size_t keyframes = 0;
  std::map<std::string, DiagnosticStatus> diagnostics;

 private:
  template <class Message, class Take>
  void hear(const std::string& topic, Take take) {
    subscribers_.push_back(node_.subscribe<Message>(
        topic, 100,
        boost::function<void(const boost::shared_ptr<const Message>&)>(
            [take](const boost::shared_ptr<const Message>& message) { take(*message); })));
  }

  ros::NodeHandle node_;
  std::vector<ros::Subscriber> subscribers_;
};

SetMode::Response set_mode(const std::string& mode, const std::string& file = "") {
  SetMode call;
  call.request.mode = mode;
  call.request.file = file;
  EXPECT_TRUE(ros::service::call("agv/set_mode", call));
  return call.response;
}

std::vector<std::string> loaded() {
  nodelet::NodeletList list;
  EXPECT_TRUE(ros::service::call("falko_slam_manager/list", list));
  return list.response.nodelets;
}

bool is_loaded(const std::string& name) {
  const std::vector<std::string> names = loaded();
  return std::find(names.begin(), names.end(), name) != names.end();
}

// One vehicle for all tests, which go on where the one before ended.
class AgvSimulation : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    client_ = new VehicleClient();
    folder_ = new test::TemporaryFolder();
    ros::param::set("pose_graph/map_folder", folder_->path());
  }
  static void TearDownTestSuite() {
    delete client_;
    delete folder_;
  }

  static VehicleClient* client_;
  static test::TemporaryFolder* folder_;
};
VehicleClient* AgvSimulation::client_;
test::TemporaryFolder* AgvSimulation::folder_;

TEST_F(AgvSimulation, FindsItselfAndAllItsPartsAreWell) {
  EXPECT_TRUE(spin_until([] { return client_->localized(); }, kDeadline));
  EXPECT_EQ(client_->mode, "localization");
  for (const char* part :
       {"agv: mode", "tricycle_odometry: odometry", "keypoint_detector: keypoint detection",
        "calibration: calibration", "localizer: localization", "nav350_simulator: simulation"}) {
    EXPECT_TRUE(
        spin_until([&] { return client_->says(part, "", DiagnosticStatus::OK); }, kDeadline))
        << part << ": " << client_->told(part);
  }
}

TEST_F(AgvSimulation, NamesTopicsThatAreMissingOrWrong) {
  ros::NodeHandle node;
  const ros::Publisher cloud = node.advertise<sensor_msgs::PointCloud2>("points", 1);
  const std::string deaf = "deaf_detector: keypoint detection";
  const std::string puzzled = "puzzled_detector: keypoint detection";

  EXPECT_TRUE(spin_until(
      [&] {
        return client_->says(deaf, "nobody publishes it (did you mean /scan, of this type?)",
                             DiagnosticStatus::WARN);
      },
      kDeadline))
      << client_->told(deaf);
  EXPECT_NE(client_->told(deaf).find("no message on /scna for "), std::string::npos);
  EXPECT_TRUE(spin_until(
      [&] {
        return client_->says(puzzled,
                             "publishes it with type sensor_msgs/PointCloud2, expected "
                             "sensor_msgs/LaserScan",
                             DiagnosticStatus::WARN);
      },
      kDeadline))
      << client_->told(puzzled);
}

TEST_F(AgvSimulation, RefusesWhatCannotBeAndStaysAsItIs) {
  EXPECT_EQ(set_mode("flying").message, "mode 'flying': must be mapping or localization");
  const SetMode::Response response = set_mode("localization", "/nowhere/map.yaml");
  EXPECT_FALSE(response.success);
  EXPECT_NE(response.message.find("/nowhere/map.yaml"), std::string::npos) << response.message;
  EXPECT_TRUE(spin_until(
      [] { return client_->says("agv: mode", "/nowhere/map.yaml", DiagnosticStatus::WARN); },
      kDeadline));
  EXPECT_TRUE(is_loaded("/localizer"));
  EXPECT_EQ(client_->mode, "localization");
}

TEST_F(AgvSimulation, MapsAndKeepsTheMapAndFindsItselfAgain) {
  const SetMode::Response to_mapping = set_mode("mapping");
  ASSERT_TRUE(to_mapping.success) << to_mapping.message;
  EXPECT_TRUE(is_loaded("/pose_graph"));
  EXPECT_FALSE(is_loaded("/localizer"));
  EXPECT_TRUE(
      spin_until([] { return client_->mode == "mapping" && client_->keyframes > 2; }, kDeadline));

  client_->status.reset();
  client_->pose.reset();
  const SetMode::Response back = set_mode("localization");
  ASSERT_TRUE(back.success) << back.message;
  EXPECT_NE(back.message.find(", by odometry since it was there last"), std::string::npos)
      << back.message;
  EXPECT_TRUE(spin_until([] { return client_->pose && client_->truth; }, kDeadline));
  EXPECT_LT(client_->error(), 0.5);  // of the first pose
  EXPECT_TRUE(is_loaded("/localizer"));
  EXPECT_FALSE(is_loaded("/pose_graph"));
  EXPECT_EQ(folder_->names().size(), 4U) << back.message;  // .slam, .yaml, .pgm, .png
  EXPECT_TRUE(spin_until([] { return client_->localized(); }, kDeadline));
}

TEST_F(AgvSimulation, DoesNotLeaveAMapThatCannotBeSaved) {
  ros::param::set("pose_graph/map_folder", "/dev/full");
  ASSERT_TRUE(set_mode("mapping").success);
  client_->keyframes = 0;
  ASSERT_TRUE(spin_until([] { return client_->keyframes > 0; }, kDeadline));

  const SetMode::Response refused = set_mode("localization");
  EXPECT_FALSE(refused.success);
  EXPECT_NE(refused.message.find("/dev/full"), std::string::npos) << refused.message;
  EXPECT_TRUE(is_loaded("/pose_graph"));
  SetMode discarding;
  discarding.request.mode = "localization";
  discarding.request.discard_map = true;
  ASSERT_TRUE(ros::service::call("agv/set_mode", discarding));
  EXPECT_TRUE(discarding.response.success) << discarding.response.message;
  EXPECT_TRUE(is_loaded("/localizer"));
}

TEST_F(AgvSimulation, LoadsTheNodeletOfItsModeAgain) {
  ASSERT_EQ(ros::Time::isSimTime(), true);
  nodelet::NodeletUnload unload;
  unload.request.name = "/localizer";
  ASSERT_TRUE(ros::service::call("falko_slam_manager/unload_nodelet", unload));
  client_->status.reset();
  EXPECT_TRUE(spin_until([] { return client_->localized(); }, kDeadline));
  EXPECT_TRUE(is_loaded("/localizer"));
}

}  // namespace
}  // namespace falko_slam

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_agv_simulation_nodelet");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
