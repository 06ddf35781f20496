// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/precision_evaluation.hpp"

#include <cmath>
#include <map>

#include "falko_slam/common/random_sequence.hpp"
#include "falko_slam/evaluation/vehicle_knowledge.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

constexpr double kWheelbase = 1.5;  // of a CB25; an assumption [m]

// \cite kallasi2017, Table 5.3: alpha_F, alpha_B [cdeg], s_w [mm/tick], l_x, l_y [mm], l_theta
// [cdeg].
struct PublishedVehicle {
  const char* name;
  double forward, backward, scale, x, y, theta;
};
constexpr PublishedVehicle kSetting1[] = {
    {"LGV71", -88.77, -76.70, 0.250911, 1485.86, -9.80, 236.49},
    {"LGV74", -61.68, -56.34, 0.249778, 1508.43, -9.00, -22.32},
    {"LGV01", -87.79, -86.39, 0.249122, 1500.61, -2.90, -82.36}};

double centidegrees(double value) { return degrees_to_radians(0.01 * value); }

PrecisionVehicle vehicle_of(const PublishedVehicle& row) {
  PrecisionVehicle vehicle;
  vehicle.name = row.name;
  vehicle.model.tricycle = {kWheelbase, 1e-3 * row.scale, centidegrees(row.forward),
                            centidegrees(row.backward)};
  vehicle.model.base_T_laser = {1e-3 * row.x, 1e-3 * row.y, centidegrees(row.theta)};
  vehicle.model.nominal = {kWheelbase, 2.5e-4, 0.0, 0.0};
  vehicle.model.nominal_base_T_laser = {1.5, 0.0, 0.0};
  return vehicle;
}

// The plant's vehicle with the parameters of this one.
VehicleModel as_this_one(VehicleModel model, const VehicleModel& vehicle) {
  model.tricycle = vehicle.tricycle;
  model.base_T_laser = vehicle.base_T_laser;
  model.nominal = vehicle.nominal;
  model.nominal_base_T_laser = vehicle.nominal_base_T_laser;
  return model;
}

CalibrationResult calibrate_vehicle(const VehicleModel& vehicle, std::size_t number,
                                    const PrecisionParams& params) {
  SimulatedCalibrationParams calibration = params.calibration;
  calibration.vehicle = as_this_one(calibration.vehicle, vehicle);
  calibration.calibrator.wheelbase = vehicle.nominal.wheelbase;
  calibration.seed = params.seed;
  return calibrate_in_a_hall(plan_of(params.condition, calibration), calibration, number);
}

// Without a calibration reflectors are not where they should be: seen by a laser that is mounted to
// this tolerance, they would be refused if the localizer were not told.
LocalizerParams told_of_tolerances(LocalizerParams params) {
  params.mount_position = 0.01;
  params.mount_heading = degrees_to_radians(0.25);
  params.reflectors.range_bias = params.mount_position;
  params.reflectors.bearing_noise = params.mount_heading;
  return params;
}

struct MeanPoint {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double count = 0.0;
};

}  // namespace

std::vector<PrecisionVehicle> thesis_vehicles() {
  std::vector<PrecisionVehicle> vehicles;
  for (const PublishedVehicle& row : kSetting1) vehicles.push_back(vehicle_of(row));
  PrecisionVehicle as_built = vehicles[1];
  as_built.name += " as built";
  as_built.calibrated = false;
  vehicles.push_back(as_built);
  return vehicles;
}

PrecisionRun evaluate_precision(const PrecisionVehicle& vehicle, std::size_t number,
                                const Scenario& plant, const Layout& layout, const LandmarkMap& map,
                                const PrecisionParams& params) {
  PrecisionRun run;
  run.vehicle = vehicle;
  run.believed = nominal_calibration(vehicle.model);
  if (vehicle.calibrated) {
    const CalibrationResult result = calibrate_vehicle(vehicle.model, number, params);
    run.verdict = result.verdict;
    if (!result.estimate) {
      run.drive.trouble = "not calibrated";
      return run;
    }
    run.believed = result.estimate->calibration;
  }
  Scenario scenario = plant;
  scenario.vehicle = as_this_one(plant.vehicle, vehicle.model);
  const LocalizerParams localizer =
      vehicle.calibrated ? params.localizer : told_of_tolerances(params.localizer);
  run.drive = drive_layout(scenario, layout, run.believed, localizer, params.odometry, map,
                           random_sequence(params.seed, {static_cast<std::uint32_t>(number), 2U})(),
                           {params.rounds, 1e9});
  return run;
}

double LocalHalt::distance() const { return std::hypot(x, y); }

std::vector<LocalHalt> local_halts(const std::vector<PrecisionRun>& runs) {
  std::map<std::string, MeanPoint> means;
  for (const PrecisionRun& run : runs) {
    if (!run.vehicle.calibrated) continue;
    for (const HaltingPoint& point : run.drive.halts) {
      MeanPoint& mean = means[point.halt.name];
      mean.sum += point.world_T_base.translation();
      mean.count += 1.0;
    }
  }
  std::vector<LocalHalt> local;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    for (const auto& [halt, world_T_base] : runs[i].drive.halts) {
      const auto mean = means.find(halt.name);
      if (mean == means.end()) continue;
      const Pose2& planned = halt.map_T_planned;
      const Eigen::Vector2d origin = mean->second.sum / mean->second.count;
      const Eigen::Vector2d here = world_T_base.translation();
      const Eigen::Vector2d offset = planned.rotation().transpose() * (here - origin);
      local.push_back({i, halt.name, halt.after_curve, offset.x(), offset.y(),
                       angle_between(planned.theta(), world_T_base.theta()),
                       (here - planned.translation()).norm()});
    }
  }
  return local;
}

}  // namespace falko_slam
