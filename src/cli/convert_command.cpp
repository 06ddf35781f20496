// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "console.hpp"
#include "falko_slam/ros_bridge/carmen_bag.hpp"
#include "falko_slam/ros_bridge/tricycle_bag.hpp"
#include "falko_slam/sensor/log_kind.hpp"
#include "output_files.hpp"

namespace falko_slam {
namespace cli {
namespace {

struct ConvertOptions {
  std::string log;
  std::string bag;
  CarmenBagParams params;
};

std::string convert_tricycle_log(const ConvertOptions& options) {
  TricycleBagParams params;
  params.odom_frame = options.params.odom_frame;
  params.base_frame = options.params.base_frame;
  params.laser_frame = options.params.laser_frame;
  params.replace = options.params.replace;
  return falko_slam::convert_tricycle_log(options.log, options.bag, params);
}

std::string convert(const ConvertOptions& options) {
  const bool tricycle = recognize_log(options.log) == LogKind::kTricycle;
  return tricycle ? convert_tricycle_log(options)
                  : convert_carmen_log(options.log, options.bag, options.params);
}

}  // namespace

void add_convert(CLI::App& app) {
  auto options = std::make_shared<ConvertOptions>();
  CLI::App* verb = app.add_subcommand("convert", "CARMEN log or a tricycle's log to ROS bag");
  verb->add_option("log", options->log, "the log, plain, .gz or .bz2; its content tells which")
      ->required();
  verb->add_option("bag", options->bag, "bag to write")->required();
  verb->add_option("--odom-frame", options->params.odom_frame, "default odom");
  verb->add_option("--base-frame", options->params.base_frame, "default base_link");
  verb->add_option("--laser-frame", options->params.laser_frame, "default laser");
  verb->add_flag("--force", options->params.replace, "replace an existing bag");
  verb->callback([options] {
    require_new(options->bag, options->params.replace);
    std::cout << convert(*options) << "\n"
              << "wrote " << options->bag << ": " << describe_resources() << "\n";
  });
}

}  // namespace cli
}  // namespace falko_slam
