// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <falko_slam/LoopConstraintArray.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Path.h>
#include <nodelet/loader.h>
#include <rosgraph_msgs/Clock.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "falko_slam/ros_bridge/pose_conversion.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"
#include "spin_until.hpp"
#include "support/seeds.hpp"
#include "support/simulated_laser.hpp"

namespace falko_slam {
namespace test {

inline Pose2 pose_of(const geometry_msgs::Pose& pose) {
  return {pose.position.x, pose.position.y,
          2.0 * std::atan2(pose.orientation.z, pose.orientation.w)};
}

/// A vehicle in the office with a PoseGraph nodelet of a namespace: moves, sends tf and scans, and
/// hears what comes of them. Its frames are <name>_map, <name>_odom, <name>_base and <name>_laser.
class SlamClient {
 public:
  explicit SlamClient(const std::string& name) : name_(name), node_("/" + name) {
    clock_ = node_.advertise<rosgraph_msgs::Clock>("/clock", 10);
    tf_ = node_.advertise<tf2_msgs::TFMessage>("/tf", 100);
    scans_ = node_.advertise<sensor_msgs::LaserScan>("scan", 100);
    mounts_.sendTransform(to_transform(kMount, Time(), frame("base"), frame("laser")).transforms);
    listen();
    // After all that others have lived through: time jumps only where a test wants it to.
    stamp = ros::Time::now() + ros::Duration(100.0);
  }

  std::string frame(const std::string& which) const { return name_ + "_" + which; }
  /// `tf_listeners`: processes.
  bool connected(std::uint32_t tf_listeners = 1) {
    return spin_until([this, tf_listeners] {
      return scans_.getNumSubscribers() > 0 && tf_.getNumSubscribers() >= tf_listeners &&
             heard_[0].getNumPublishers() > 0 && heard_[1].getNumPublishers() > 0;
    });
  }

  /// So many seconds later.
  void advance(double seconds) { set_time(stamp.toSec() + seconds); }
  void set_time(double seconds) {
    stamp = ros::Time(seconds);
    rosgraph_msgs::Clock clock;
    clock.clock = stamp;
    clock_.publish(clock);
    spin_until([&] { return ros::Time::now() == stamp; });
  }

  sensor_msgs::LaserScan scan_at(const Pose2& world_T_base) {
    SimulatedLaserParams laser;
    laser.beams = 360;
    laser.angle_increment = kTwoPi / 360.0;
    sensor_msgs::LaserScan scan;
    scan.header.stamp = stamp;
    scan.header.frame_id = frame("laser");
    scan.angle_min = static_cast<float>(laser.angle_min);
    scan.angle_max = static_cast<float>(-laser.angle_min);
    scan.angle_increment = static_cast<float>(laser.angle_increment);
    scan.range_min = 0.05F;
    scan.range_max = 100.0F;
    scan.ranges = simulate_ranges(scene_, world_T_base * kMount, laser, random_);
    return scan;
  }
  void send_odometry(const Pose2& odom_T_base) {
    tf_.publish(to_transform(odom_T_base, from_ros(stamp), frame("odom"), frame("base")));
  }
  /// As if somebody else knew it.
  void send_map_transform() {
    tf_.publish(
        to_transform({}, from_ros(stamp + ros::Duration(1.0)), frame("map"), frame("odom")));
  }
  void send(const sensor_msgs::LaserScan& scan) { scans_.publish(scan); }

  /// One step of a drive, 0.125 s later; waits until all of it is done.
  void step(const Pose2& world_T_base, const Pose2& odom_T_base) {
    advance(0.125);
    send_odometry(odom_T_base);
    send(scan_at(world_T_base));
    spin_for(0.004);
  }

  /// The newest status, with `text` in its message, of level `level`.
  bool diagnosed(const std::string& text, int level) {
    return spin_until(
        [&] {
          return static_cast<int>(status.level) == level &&
                 status.message.find(text) != std::string::npos;
        },
        5.0);
  }
  std::string value(const std::string& key) const {
    for (const auto& entry : status.values) {
      if (entry.key == key) return entry.value;
    }
    return "no such key";
  }
  const geometry_msgs::PoseWithCovarianceStamped& last_pose() const { return poses.back(); }

  static inline const Pose2 kMount{0.4, 0.1, 0.2};
  ros::NodeHandle& node() { return node_; }

  ros::Time stamp;
  std::vector<geometry_msgs::PoseWithCovarianceStamped> poses;
  std::vector<geometry_msgs::TransformStamped> to_map;  // tf of ours below the map's frame
  std::set<std::string> map_broadcasters;
  std::vector<LoopConstraint> constraints;
  nav_msgs::OccupancyGridConstPtr map;
  nav_msgs::PathConstPtr path;
  diagnostic_msgs::DiagnosticStatus status;

 private:
  template <class Message, class Take>
  void hear(const std::string& topic, Take&& take) {
    const boost::function<void(const boost::shared_ptr<const Message>&)> callback = take;
    heard_.push_back(node_.subscribe<Message>(topic, 1000, callback));
  }
  void listen() {
    hear<geometry_msgs::PoseWithCovarianceStamped>("pose",
                                                   [this](const auto& m) { poses.push_back(*m); });
    hear<nav_msgs::OccupancyGrid>("map", [this](const auto& m) { map = m; });
    hear<nav_msgs::Path>("path", [this](const auto& m) { path = m; });
    hear<LoopConstraintArray>("constraints", [this](const auto& m) {
      constraints.insert(constraints.end(), m->constraints.begin(), m->constraints.end());
    });
    const std::string status_name = "/" + name_ + "/pose_graph: slam";
    hear<diagnostic_msgs::DiagnosticArray>("/diagnostics", [this, status_name](const auto& m) {
      for (const auto& entry : m->status) {
        if (entry.name == status_name || "/" + entry.name == status_name) status = entry;
      }
    });
    using Event = ros::MessageEvent<tf2_msgs::TFMessage const>;
    const boost::function<void(const Event&)> on_tf = [this](const Event& event) {
      for (const auto& transform : event.getMessage()->transforms) {
        if (transform.header.frame_id != frame("map")) continue;
        to_map.push_back(transform);
        map_broadcasters.insert(event.getPublisherName());
      }
    };
    heard_.push_back(node_.subscribe<tf2_msgs::TFMessage>("/tf", 1000, on_tf));
  }

  std::string name_;
  ros::NodeHandle node_;
  ros::Publisher clock_, tf_, scans_;
  std::vector<ros::Subscriber> heard_;
  tf2_ros::StaticTransformBroadcaster mounts_;
  Scene scene_ = office_scene();
  std::mt19937_64 random_ = seeded_random();
};

/// A nodelet in a namespace of its own, and its client.
struct LoadedSlam {
  explicit LoadedSlam(const std::string& name, const std::string& folder,
                      const XmlRpc::XmlRpcValue& more = {})
      : client(name), node("/" + name + "/pose_graph"), loader(false) {
    if (more.valid()) node.setParam("/" + name + "/pose_graph", more);
    for (const char* frame : {"map", "odom", "base"}) {
      node.setParam(std::string(frame) + "_frame", client.frame(frame));
    }
    node.setParam("map_folder", folder);
    node.setParam("map_update_period", 0.2);
    loaded = loader.load("/" + name + "/pose_graph", "falko_slam/PoseGraph", {}, {});
  }
  bool ready() { return loaded && client.connected(); }

  template <class Service>
  Service call(const char* service, Service call = {}) {
    EXPECT_TRUE(ros::service::call(node.resolveName(service), call)) << service;
    return call;
  }
  template <class Service>
  typename Service::Response of_file(const char* service, const std::string& file) {
    Service request;
    request.request.file = file;
    return call(service, request).response;
  }

  SlamClient client;
  ros::NodeHandle node;
  nodelet::Loader loader;
  bool loaded = false;
};

}  // namespace test
}  // namespace falko_slam
