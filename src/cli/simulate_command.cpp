// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <nav_msgs/Odometry.h>

#include <iostream>
#include <memory>

#include "commands.hpp"
#include "console.hpp"
#include "falko_slam/ros_bridge/bag_file.hpp"
#include "falko_slam/ros_bridge/laser_scan_conversion.hpp"
#include "falko_slam/ros_bridge/pose_conversion.hpp"
#include "falko_slam/ros_bridge/topics.hpp"
#include "falko_slam/simulation/simulated_laser.hpp"

namespace falko_slam {
namespace cli {
namespace {

struct SimulateOptions {
  std::string out;
  bool replace = false;
  std::uint64_t seed = 1;
  double speed = 0.8;          // [m/s]
  double scan_period = 0.125;  // [s], NAV350: 8 Hz
  SimulatedLaserParams laser;
};

RawScan as_nav350(const std::vector<float>& ranges, const SimulateOptions& options, Time stamp) {
  RawScan raw;
  raw.stamp = stamp;
  raw.angle_min = options.laser.angle_min;
  raw.angle_increment = options.laser.angle_increment;
  const auto beams = static_cast<double>(options.laser.beams);
  raw.angle_max = raw.angle_min + beams * raw.angle_increment;  // one past the last beam
  raw.scan_time = options.scan_period;
  raw.time_increment = options.scan_period / beams;
  raw.range_min = 0.05;
  raw.range_max = options.laser.range_max;
  raw.ranges = ranges.data();
  raw.range_count = ranges.size();
  return raw;
}

void simulate(SimulateOptions options) {
  constexpr double kTurn = kTwoPi;
  options.laser.angle_increment = kTurn / static_cast<double>(options.laser.beams);
  const Scene scene = office_scene();
  std::mt19937_64 random(options.seed);
  BagFile bag(options.out, options.replace);
  const std::vector<Pose2> path = office_path(options.speed * options.scan_period);
  const Duration period = from_seconds(options.scan_period);
  Time stamp(std::chrono::seconds(1));
  bag.write_latched(topics::kTfStatic, stamp, to_transform({}, stamp, "base_link", "laser"));
  Progress progress("scans", path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Pose2& pose = path[i];
    const Pose2 way = pose.inverse() * path[(i + 1) % path.size()];
    nav_msgs::Odometry odometry;
    odometry.header.stamp = to_ros(stamp);
    odometry.header.frame_id = "odom";
    odometry.child_frame_id = "base_link";
    odometry.pose.pose = to_message(pose);
    const auto ranges = simulate_moving_ranges(scene, pose, way, options.laser, random);
    bag.write(topics::kTf, stamp, to_transform(pose, stamp, "odom", "base_link"));
    bag.write(topics::kOdometry, stamp, odometry);
    bag.write(topics::kScan, stamp, to_message(as_nav350(ranges, options, stamp), "laser"));
    stamp += period;
    progress.step();
  }
  bag.finish();
  std::cout << path.size() << " scans of " << options.laser.beams << " beams, "
            << to_seconds(stamp - Time(std::chrono::seconds(1))) << " s of driving\n"
            << "wrote " << options.out << ": " << describe_resources() << "\n";
}

}  // namespace

void add_simulate(CLI::App& app) {
  auto options = std::make_shared<SimulateOptions>();
  CLI::App* verb = app.add_subcommand(
      "simulate", "drive a laser around an office and write what it sees to a bag");
  verb->add_option("--out", options->out, "bag to write")->required();
  verb->add_option("--beams", options->laser.beams, "over 360 degrees, default 1440")
      ->check(CLI::Range(8, 100000));
  verb->add_option("--noise", options->laser.noise, "of the ranges [m], default 0.01")
      ->check(number_in(0.0, 1.0));
  verb->add_option("--seed", options->seed, "of the noise, default 1")
      ->check(CLI::NonNegativeNumber);
  verb->add_flag("--force", options->replace, "replace an existing bag");
  verb->callback([options] { simulate(*options); });
}

}  // namespace cli
}  // namespace falko_slam
