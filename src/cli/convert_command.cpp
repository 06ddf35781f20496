// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "console.hpp"
#include "falko_slam/ros_bridge/carmen_bag.hpp"

namespace falko_slam {
namespace cli {
namespace {

struct ConvertOptions {
  std::string log;
  std::string bag;
  CarmenBagParams params;
};

}  // namespace

void add_convert(CLI::App& app) {
  auto options = std::make_shared<ConvertOptions>();
  CLI::App* verb = app.add_subcommand("convert", "CARMEN log to ROS bag");
  verb->add_option("log", options->log, "CARMEN log, plain, .gz or .bz2")->required();
  verb->add_option("bag", options->bag, "bag to write")->required();
  verb->add_option("--odom-frame", options->params.odom_frame, "default odom");
  verb->add_option("--base-frame", options->params.base_frame, "default base_link");
  verb->add_option("--laser-frame", options->params.laser_frame, "default laser");
  verb->add_flag("--force", options->params.replace, "replace an existing bag");
  verb->callback([options] {
    std::cout << convert_carmen_log(options->log, options->bag, options->params) << "\n"
              << "wrote " << options->bag << ": " << describe_resources() << "\n";
  });
}

}  // namespace cli
}  // namespace falko_slam
