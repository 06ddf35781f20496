// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <falko_slam/KeyframeArray.h>
#include <falko_slam/LoopConstraintArray.h>
#include <nodelet/loader.h>
#include <rosgraph_msgs/Clock.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <string>
#include <vector>

#include "falko_slam/ros_bridge/pose_conversion.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"
#include "spin_until.hpp"
#include "support/seeds.hpp"
#include "support/simulated_laser.hpp"

namespace falko_slam {
namespace test {

inline const Pose2 kBaseTLaser{0.4, 0.1, 0.2};

/// A vehicle in the office with a loop closure nodelet of a namespace: moves, sends tf and scans,
/// and hears keyframes and constraints. Its frames are the namespace's own.
class LoopClient {
 public:
  explicit LoopClient(const std::string& name, const std::string& odom_frame)
      : odom_frame_(odom_frame), node_(name) {
    clock_ = node_.advertise<rosgraph_msgs::Clock>("/clock", 10);
    tf_ = node_.advertise<tf2_msgs::TFMessage>("/tf", 100);
    scans_ = node_.advertise<sensor_msgs::LaserScan>("scan", 10);
    listen();
    geometry_msgs::TransformStamped mount =
        to_transform(kBaseTLaser, Time(), "base_link", "laser").transforms[0];
    mounts_.sendTransform(mount);
  }

  bool connected() {
    return spin_until([this] {
      return scans_.getNumSubscribers() > 0 && keyframe_subscriber_.getNumPublishers() > 0 &&
             constraint_subscriber_.getNumPublishers() > 0 && tf_.getNumSubscribers() > 0;
    });
  }

  void set_time(double seconds) {
    stamp_ = ros::Time(seconds);
    send_time();
  }
  const ros::Time& stamp() const { return stamp_; }

  /// What the laser sees from there, 0.125 s later than the last one.
  sensor_msgs::LaserScan scan_at(const Pose2& world_T_base) {
    SimulatedLaserParams laser;
    laser.beams = 360;
    laser.angle_increment = kTwoPi / 360.0;
    stamp_ += ros::Duration(0.125);
    sensor_msgs::LaserScan scan;
    scan.header.stamp = stamp_;
    scan.header.frame_id = "laser";
    scan.angle_min = static_cast<float>(laser.angle_min);
    scan.angle_max = static_cast<float>(-laser.angle_min);
    scan.angle_increment = static_cast<float>(laser.angle_increment);
    scan.range_min = 0.05F;
    scan.range_max = 100.0F;
    scan.ranges = simulate_ranges(scene_, world_T_base * kBaseTLaser, laser, random_);
    return scan;
  }

  void send_odometry(const Pose2& odom_T_base) { send_odometry_of(stamp_, odom_T_base); }
  void send_odometry_of(const ros::Time& stamp, const Pose2& odom_T_base) {
    tf_.publish(to_transform(odom_T_base, from_ros(stamp), odom_frame_, "base_link"));
  }
  void send(const sensor_msgs::LaserScan& scan) { scans_.publish(scan); }

  /// One step of a drive; true if the keyframe and its constraints have come. Sent again as long as
  /// they have not: where tf has just begun anew the first scan may come too early.
  bool step(const Pose2& world_T_base, const Pose2& odom_T_base) {
    const sensor_msgs::LaserScan scan = scan_at(world_T_base);
    send_time();
    const auto came = [&] {
      return !constraints.empty() && constraints.back().header.stamp == scan.header.stamp &&
             !keyframes.empty() && keyframes.back().header.stamp == scan.header.stamp;
    };
    for (int attempt = 0; attempt < 20 && !came(); ++attempt) {
      send_odometry(odom_T_base);
      send(scan);
      spin_until(came, 0.5);
    }
    return came();
  }

  ros::NodeHandle& node() { return node_; }

  std::vector<KeyframeScan> keyframes;  // since the last reset
  std::size_t resets = 0;
  std::vector<LoopConstraintArray> constraints;

 private:
  void listen() {
    keyframe_subscriber_ =
        node_.subscribe<KeyframeArray>("keyframes", 100, [this](const KeyframeArrayConstPtr& m) {
          if (m->reset) keyframes.clear(), ++resets;
          keyframes.insert(keyframes.end(), m->keyframes.begin(), m->keyframes.end());
        });
    constraint_subscriber_ = node_.subscribe<LoopConstraintArray>(
        "constraints", 100,
        [this](const LoopConstraintArrayConstPtr& m) { constraints.push_back(*m); });
  }
  void send_time() {
    rosgraph_msgs::Clock clock;
    clock.clock = stamp_;
    clock_.publish(clock);
    spin_until([&] { return ros::Time::now() == stamp_; });
  }

  std::string odom_frame_;
  ros::NodeHandle node_;
  ros::Publisher clock_, tf_, scans_;
  ros::Subscriber keyframe_subscriber_, constraint_subscriber_;
  tf2_ros::StaticTransformBroadcaster mounts_;
  Scene scene_ = office_scene();
  std::mt19937_64 random_ = seeded_random();
  ros::Time stamp_ = ros::Time(1000.0);
};

/// A nodelet in a namespace of its own, and its client.
struct LoadedLoopClosure {
  explicit LoadedLoopClosure(const std::string& name, const std::string& folder,
                             const std::string& database = "")
      : client(name, name.substr(1) + "_odom"), loader(false) {
    ros::NodeHandle node(name + "/loop_closure");
    node.setParam("odom_frame", name.substr(1) + "_odom");
    node.setParam("folder", folder);
    node.setParam("database", database);
    loaded = loader.load(name + "/loop_closure", "falko_slam/LoopClosure", {}, {});
  }

  template <class Service>
  Service call(const char* service, Service call) {
    EXPECT_TRUE(ros::service::call(
        client.node().resolveName(std::string("loop_closure/") + service), call));
    return call;
  }

  LoopClient client;
  nodelet::Loader loader;
  bool loaded = false;
};

}  // namespace test
}  // namespace falko_slam
