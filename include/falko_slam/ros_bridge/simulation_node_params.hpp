// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <XmlRpcValue.h>

#include <cstdint>
#include <string>
#include <vector>

#include "falko_slam/common/enum_names.hpp"
#include "falko_slam/ros_bridge/simulation_messages.hpp"

namespace falko_slam {

/// Who leads the simulated vehicle.
enum class DriveSource {
  kCommands,  ///< whoever publishes `drive_command`
  kScenario,  ///< the drive in the scenario file
  kBag,       ///< a recorded drive, see read_drive()
};
const EnumNames<DriveSource>& drive_source_names();

/// Parameters of the Nav350Simulator node, config/nav350_simulator.yaml.
struct SimulationNodeParams {
  std::string scenario;  ///< YAML file
  int seed = 1;
  DriveSource drive = DriveSource::kCommands;
  std::string drive_bag;    ///< for DriveSource::kBag
  std::string drive_topic;  ///< of that bag; empty: its only one
  double rate = 1.0;        ///< times real time; other than 1 only as the clock of use_sim_time
  bool publish_tf = true;   ///< odom to base_link, base_link to laser
  /// World to odom, as a perfect localizer would send it. Only where nobody else tells where odom
  /// is: a map frame cannot be its parent, too.
  bool publish_world_tf = false;
  SimulationFrames frames;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const SimulationNodeParams& params);

template <class Params, class Visitor>
void visit_simulation_node_fields(Params& params, Visitor& visitor) {
  visitor.field("scenario", params.scenario);
  visitor.field("seed", params.seed);
  visitor.choice("drive", params.drive, drive_source_names());
  visitor.field("drive_bag", params.drive_bag);
  visitor.field("drive_topic", params.drive_topic);
  visitor.field("rate", params.rate);
  visitor.field("publish_tf", params.publish_tf);
  visitor.field("publish_world_tf", params.publish_world_tf);
  visitor.field("world_frame", params.frames.world);
  visitor.field("odom_frame", params.frames.odom);
  visitor.field("base_frame", params.frames.base);
  visitor.field("laser_frame", params.frames.laser);
}

/// `name` stands before the names in messages; `unknown` gets the names that no field has. Throws
/// std::invalid_argument with the parameter's full name.
SimulationNodeParams read_simulation_node_params(const XmlRpc::XmlRpcValue& tree,
                                                 const std::string& name,
                                                 std::vector<std::string>& unknown);

}  // namespace falko_slam
