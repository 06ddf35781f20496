// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/simulation_bag.hpp"

#include <stdexcept>

#include "falko_slam/ros_bridge/bag_file.hpp"
#include "falko_slam/ros_bridge/recorded_driver.hpp"
#include "falko_slam/ros_bridge/topics.hpp"
#include "falko_slam/ros_bridge/world_markers.hpp"

namespace falko_slam {
namespace {

/// Writes the messages of one step after the other.
class SimulationBagWriter {
 public:
  SimulationBagWriter(BagFile& bag, const Scenario& scenario, const SimulationBagParams& params)
      : bag_(bag), messenger_(scenario, params.frames), sweep_(sweep_of(scenario.laser)) {
    path_.header.frame_id = params.frames.world;
    path_.header.stamp = to_ros(params.start);
    bag_.write_latched(topics::kTfStatic, params.start, messenger_.mount(params.start));
    bag_.write_latched(topics::kWorldMarkers, params.start,
                       world_markers(scenario.world, 0.0, path_.header));
  }

  void write(const SimulationStep& step) {
    const SimulationMessages messages = messenger_.of(step);
    const Time now = step.encoders.stamp;
    for (std::size_t i = 0; i < messages.scans.size(); ++i) {
      const Time measured = from_ros(messages.scans[i].header.stamp) + sweep_;
      bag_.write(topics::kScan, measured, messages.scans[i]);
      if (i < messages.reflectors.size()) {
        bag_.write(topics::kReflectors, measured, messages.reflectors[i]);
      }
    }
    bag_.write(topics::kTf, now, messages.odom_T_base);
    bag_.write(topics::kEncoders, now, messages.encoders);
    bag_.write(topics::kJointStates, now, messages.joints);
    bag_.write(topics::kOdometry, now, messages.odometry);
    bag_.write(topics::kGroundTruth, now, messages.truth);
    extend_path(path_, messages.truth);
  }

  void finish(Time now) {
    bag_.write_latched(topics::kGroundTruthPath, now, path_);
    bag_.finish();
  }

 private:
  BagFile& bag_;
  SimulationMessenger messenger_;
  Duration sweep_;
  nav_msgs::Path path_;
};

// Who leads the vehicle; a vehicle that nobody leads stands for as long as is asked for.
std::unique_ptr<Driver> driver_for(Scenario& scenario, const SimulationBagParams& params,
                                   SimulationBagReport& report) {
  if (!params.drive_bag.empty()) {
    RecordedDrive drive = read_drive(params.drive_bag, params.drive_topic, scenario.vehicle);
    report.drive = drive.description;
    if (drive.first_drive_ticks) scenario.vehicle.first_drive_ticks = *drive.first_drive_ticks;
    return std::move(drive.driver);
  }
  if (scenario.drive.empty() && params.duration <= 0.0) {
    throw std::runtime_error(scenario.name +
                             ": has no drive: give a duration, or a bag that drives");
  }
  report.drive = "the scenario's drive";
  return scenario_driver(scenario.drive, scenario.vehicle);
}

}  // namespace

SimulationBagReport simulate_to_bag(Scenario scenario, const SimulationBagParams& params,
                                    const std::string& bag, const std::function<void()>& progress) {
  SimulationBagReport report;
  const auto driver = driver_for(scenario, params, report);
  Simulation simulation(scenario, params.start, params.seed);
  BagFile file(bag, params.replace);
  SimulationBagWriter writer(file, scenario, params);
  writer.write(simulation.state());
  const Time end = params.start + from_seconds(params.duration);
  while (params.duration <= 0.0 || simulation.time() < end) {
    auto input = driver->next(simulation.vehicle(), simulation.period());
    if (!input && params.duration <= 0.0) break;
    if (!input) input = WheelCommand{0.0, simulation.vehicle().steering()};
    const SimulationStep step = simulation.step(*input);
    writer.write(step);
    for (const SimulationStep::Scan& scan : step.scans) {
      report.truth.push_back({scan.scan.first_beam, scan.world_T_base});
      progress();
    }
    report.scans += step.scans.size();
  }
  writer.finish(simulation.time());
  report.seconds = to_seconds(simulation.time() - params.start);
  return report;
}

}  // namespace falko_slam
