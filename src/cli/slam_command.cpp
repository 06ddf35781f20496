// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "console.hpp"
#include "falko_slam/ros_bridge/slam_node_params.hpp"
#include "falko_slam/ros_bridge/yaml_parameters.hpp"
#include "output_files.hpp"
#include "slam_run.hpp"

namespace falko_slam {
namespace cli {
namespace {

struct SlamOptions {
  std::string recording;
  std::string out;
  DriveRecordingParams reading;
  bool no_odometry = false;
  bool replace = false;
  bool upside_down = false;
  std::string parameters;
  double outliers = 0.0;
  unsigned seed = 1;
};

SlamParams read_parameters(const SlamOptions& options) {
  SlamParams params;
  if (!options.parameters.empty()) {
    std::vector<std::string> unknown;
    params = read_slam_params(read_parameter_file(options.parameters), options.parameters, unknown);
    for (const std::string& name : unknown) {
      std::cerr << "parameter " << name << " is not known and has no effect\n";
    }
  }
  params.scan.upside_down = params.scan.upside_down || options.upside_down;
  return params;
}

void warn(const DriveRecordingReport& read, const SlamOptions& options) {
  if (!read.base_known) {
    std::cerr << "no transform from " << options.reading.base_frame
              << " to the laser: the laser is taken for " << options.reading.base_frame << "\n";
  }
  if (read.without_odometry == 0) return;
  std::cerr << read.without_odometry << " of " << read.scans << " scans without odometry ("
            << options.reading.odom_frame
            << "): there the motion is found by registration of the scans alone\n";
}

void print(const SlamRun& run, const DriveRecordingReport& read, const SlamOptions& options) {
  std::size_t accepted = 0;
  for (const SlamClosure& closure : run.slam().closures()) accepted += closure.accepted ? 1U : 0U;
  std::printf("%s: %s\n", options.recording.c_str(), read.description.c_str());
  std::printf(
      "%zu scans, %zu of them unusable; %zu did not fit where they were predicted, "
      "%zu fitted nowhere near: there odometry was believed\n",
      run.record().scans(), run.unusable(), run.record().searched(), run.record().lost());
  std::printf("%zu keyframes, %zu closures accepted, %zu refused\n", run.slam().keyframes(),
              accepted, run.slam().closures().size() - accepted);
  std::printf("%s\n%s\n", options.out.c_str(), describe_resources().c_str());
}

void slam(SlamOptions options) {
  options.reading.use_odometry = !options.no_odometry;
  const SlamParams params = read_parameters(options);
  make_output_folder(options.out, options.replace);
  SlamRun run(params, options.outliers, options.seed);
  DriveRecordingReport read;
  {
    Progress progress("scans");
    read = read_drive(options.recording, options.reading, [&](const RecordedScan& scan) {
      run.add(scan);
      progress.step();
    });
  }
  warn(read, options);
  run.finish();
  write_slam(run, read, options.recording, options.out);
  print(run, read, options);
}

}  // namespace

void add_slam(CLI::App& app) {
  auto options = std::make_shared<SlamOptions>();
  CLI::App* verb = app.add_subcommand("slam", "map and trajectory of a recording");
  verb->add_option("recording", options->recording, "CARMEN log (.gz, .bz2) or ROS bag")
      ->required();
  verb->add_option("--out", options->out,
                   "folder for trajectory.tum, trajectory_online.tum, map.yaml, map.pgm, map.png, "
                   "graph.g2o, closures.csv and report.json; made if it is not there")
      ->required();
  verb->add_option("--topic", options->reading.topic,
                   "LaserScan topic of the bag; default: its only one");
  verb->add_option("--odom-frame", options->reading.odom_frame, "of the bag's odometry")
      ->capture_default_str();
  verb->add_option("--base-frame", options->reading.base_frame, "of the vehicle")
      ->capture_default_str();
  verb->add_option(
      "--parameters", options->parameters,
      "YAML file with groups as in config/slam.yaml; what it leaves out keeps its default");
  verb->add_flag("--force", options->replace, "replace what an earlier run wrote to the folder");
  verb->add_flag("--no-odometry", options->no_odometry, "registration of the scans alone");
  verb->add_flag("--upside-down", options->upside_down, "the laser hangs upside down");
  verb->add_option("--inject-outliers", options->outliers,
                   "false closures proposed for each one accepted, to see what they do")
      ->check(number_in(0.0, 1.0));
  verb->add_option("--seed", options->seed, "of the false closures")->capture_default_str();
  verb->callback([options] { slam(*options); });
}

}  // namespace cli
}  // namespace falko_slam
