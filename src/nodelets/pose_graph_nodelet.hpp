// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <falko_slam/LoadState.h>
#include <falko_slam/SaveMap.h>
#include <falko_slam/SaveState.h>
#include <nav_msgs/GetMap.h>
#include <nodelet/nodelet.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>
#include <tf2_msgs/TFMessage.h>
#include <tf2_ros/transform_broadcaster.h>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "falko_slam/common/bounded_queue.hpp"
#include "falko_slam/ros_bridge/map_transform.hpp"
#include "falko_slam/ros_bridge/slam_conversion.hpp"
#include "falko_slam/ros_bridge/slam_diagnostics.hpp"
#include "falko_slam/ros_bridge/slam_node_params.hpp"
#include "falko_slam/slam/growing_map.hpp"
#include "scan_input.hpp"

namespace falko_slam {

/// LaserScan and tf in, tf to the map and the map out: a wrapper of FeatureSlam.
///
/// Topics and services: README.md. Parameters: config/slam.yaml.
///
/// Four threads: the nodelet's queue takes scans and sends tf and never waits for the others; one
/// works through the scans; one draws path, markers and map; one answers services, one after the
/// other. Mutexes are taken in this order: map, SLAM, state.
class PoseGraphNodelet : public nodelet::Nodelet {
 public:
  ~PoseGraphNodelet() override;

 private:
  struct Input {
    SlamScan scan;
    std::size_t drive;  // counts those that this nodelet has begun
  };
  struct Draft {  // what a map is drawn of
    std::vector<MappedScan> scans;
    std_msgs::Header header;
  };
  struct Drawing {
    GridMap map;
    std_msgs::Header header;
  };
  struct Changes {  // since the last drawing
    bool graph = false;
    bool poses = false;
    bool everything = false;
  };

  using TransformEvent = ros::MessageEvent<tf2_msgs::TFMessage const>;

  void onInit() override;
  void load_parameters();
  void load_first_state();
  void start_publishing();
  void start_listening();
  void start_services();
  void start_timers();
  void start_threads();

  // The nodelet's queue.
  void on_received(const ScanReport& report);
  void on_dropped(const std::string& missing);
  void on_placed(SlamScan scan);
  void on_time_jump(double seconds);
  void on_transform_timer();
  void on_second_timer();
  bool has_moved(const SlamScan& scan) const;
  void begin_drive(const std::string& reason);
  void on_transforms(const TransformEvent& event);

  // The thread of SLAM.
  void work();
  void take(const Input& input);
  void publish_step(const Input& input, const SlamStep& step);
  void publish_closures(const SlamScan& scan, KeyframeId source);
  void share_new_scans();

  // The thread that draws.
  void draw_views();
  void publish_views();
  bool map_is_due();
  Draft draft();
  Drawing draw_map();
  void publish(const Drawing& drawing);
  std_msgs::Header map_header() const;

  // The thread of services.
  bool on_dynamic_map(nav_msgs::GetMap::Request& request, nav_msgs::GetMap::Response& response);
  bool on_save_map(SaveMap::Request& request, SaveMap::Response& response);
  bool on_save_state(SaveState::Request& request, SaveState::Response& response);
  bool on_load_state(LoadState::Request& request, LoadState::Response& response);
  bool on_pause(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  bool on_reset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  /// Returns how many keyframes there were.
  std::size_t replace_slam(std::unique_ptr<FeatureSlam> slam);

  SlamNodeParams params_;

  std::mutex slam_mutex_;
  std::unique_ptr<FeatureSlam> slam_;
  std::vector<std::shared_ptr<const LaserScan>> shared_scans_;  // of its keyframes
  ClosureNews closure_news_;
  std::size_t slam_drive_ = 0;
  Changes view_changes_, map_changes_;
  double drawn_ = -1e9;        // when the map was, steady clock [s]
  double drawing_time_ = 0.0;  // how long it took [s]
  std::uint32_t marker_subscribers_ = 0;

  std::mutex map_mutex_;
  GrowingMap growing_map_;

  std::mutex state_mutex_;
  std::unique_ptr<SlamDiagnostics> diagnostics_;
  std::unique_ptr<MapTransform> transform_;
  bool paused_ = false;
  bool resumed_ = false;
  std::size_t drive_ = 0;
  std::optional<Pose2> last_odom_T_base_;
  double conflict_ = -1e9;  // when another broadcaster was seen, steady clock [s]

  using InputQueue = BoundedQueue<std::shared_ptr<const Input>>;
  std::unique_ptr<InputQueue> queue_;
  std::thread worker_, drawer_;
  std::mutex stop_mutex_;
  std::condition_variable stopping_;
  bool stop_ = false;
  bool wake_ = false;

  std::unique_ptr<ScanInput> input_;
  std::unique_ptr<diagnostic_updater::Updater> updater_;
  std::unique_ptr<tf2_ros::TransformBroadcaster> broadcaster_;
  ros::Publisher pose_, map_, map_metadata_, path_, markers_, constraints_;
  ros::Subscriber transforms_;
  ros::Timer transform_timer_;
  ros::WallTimer second_timer_;
  ros::CallbackQueue service_queue_;
  std::vector<ros::ServiceServer> services_;
  std::unique_ptr<ros::AsyncSpinner> service_thread_;
};

}  // namespace falko_slam
