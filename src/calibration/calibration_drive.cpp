// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "falko_slam/calibration/monte_carlo.hpp"
#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/alignment.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

double normal(std::mt19937_64& random, double deviation) {
  return deviation > 0.0 ? std::normal_distribution<double>(0.0, deviation)(random) : 0.0;
}

struct Reflector {
  Eigen::Vector2d point;
  double face;  // direction it looks to [rad]
};
using Reflectors = std::vector<Reflector>;

// Seen from where the laser stands as an arc begins.
Reflectors reflectors(const SimulatedCalibrationNoise& noise, std::mt19937_64& random) {
  std::uniform_real_distribution<double> distance(noise.min_distance, noise.max_distance);
  std::uniform_real_distribution<double> direction(-kPi, kPi);
  Reflectors points;
  for (int i = 0; i < noise.reflectors; ++i) {
    const double far = distance(random), angle = direction(random);
    points.push_back({{far * std::cos(angle), far * std::sin(angle)}, direction(random)});
  }
  return points;
}

Eigen::Vector2d seen_from(const Eigen::Vector2d& place, const Reflector& reflector, double bias) {
  const Eigen::Vector2d view = reflector.point - place;
  const double turned = 2.0 * std::atan2(view.y(), view.x()) + reflector.face;
  return reflector.point + bias * Eigen::Vector2d(std::cos(turned), std::sin(turned));
}

// The motion of the laser as reflectors seen at both ends tell it.
PoseEstimate measured_motion(const Pose2& start_T_end, const Reflectors& points,
                             const SimulatedCalibrationNoise& noise, std::mt19937_64& random) {
  const double deviation = noise.detection / std::sqrt(noise.scans_at_rest);
  // One for all points, unlike normal(): it makes two numbers at a time, and published figures are
  // of both.
  std::normal_distribution<double> unit;
  const auto error = [&] { return deviation * unit(random); };
  const Pose2 end_T_start = start_T_end.inverse();
  std::vector<PointPair> pairs;
  for (const Reflector& reflector : points) {
    const Eigen::Vector2d at_start = seen_from({0.0, 0.0}, reflector, noise.viewpoint_bias);
    const Eigen::Vector2d at_end =
        seen_from(start_T_end.translation(), reflector, noise.viewpoint_bias);
    PointPair pair;
    pair.point_in_target = at_start + Eigen::Vector2d(error(), error());
    pair.point_in_source = end_T_start * at_end + Eigen::Vector2d(error(), error());
    pairs.push_back(pair);
  }
  return align(pairs, std::sqrt(2.0) * deviation)->target_T_source;
}

}  // namespace

std::vector<CalibrationCondition> thesis_conditions() {
  std::vector<CalibrationCondition> conditions;
  const auto add = [&conditions](int arcs, double least, double most, double turn, double speed) {
    conditions.push_back({arcs, degrees_to_radians(least), degrees_to_radians(most),
                          degrees_to_radians(turn), speed});
  };
  add(2, 18, 50, 180, 1.0);
  add(4, 18, 34, 180, 1.0);
  for (const double turn : {60.0, 120.0}) add(4, 18, 50, turn, 1.0);
  for (const double speed : {0.8, 1.0, 1.2, 1.4}) add(4, 18, 50, 180, speed);
  add(4, 35, 50, 180, 1.0);
  for (const int arcs : {6, 8, 10}) add(arcs, 18, 50, 180, 1.0);
  for (const double speed : {0.8, 1.2, 1.4}) add(4, 18, 34, 180, speed);
  for (const double speed : {0.8, 1.0, 1.2}) add(6, 18, 34, 180, speed);
  add(6, 18, 34, 240, 1.2);
  add(6, 18, 50, 240, 0.8);
  return conditions;
}

void validate(const CalibrationCondition& condition) {
  require_in_range("arcs_per_phase", condition.arcs_per_phase, 1, 1000);
  require_in_range("min_steering", condition.min_steering, 1e-3, 0.5 * kPi);
  require_in_range("max_steering", condition.max_steering, condition.min_steering, 0.5 * kPi);
  require_in_range("turn", condition.turn, 1e-3, 4.0 * kPi);
}

void validate(const MonteCarloParams& params) {
  const SimulatedCalibrationNoise& noise = params.noise;
  validate(params.truth.tricycle);
  validate(params.calibrator);
  require_in_range("noise.detection", noise.detection, 1e-9, 1.0);
  require_in_range("noise.scans_at_rest", noise.scans_at_rest, 1, 10000);
  require_in_range("noise.reflectors", noise.reflectors, 2, 10000);
  require_in_range("noise.max_distance", noise.max_distance, 1e-3, 1000.0);
  require_in_range("noise.min_distance", noise.min_distance, 1e-3, noise.max_distance);
  require_in_range("noise.slip", noise.slip, 0.0, 0.1);
  require_in_range("noise.steer", noise.steer, 0.0, 0.1);
  require_in_range("noise.common_slip", noise.common_slip, 0.0, 0.1);
  require_in_range("noise.common_steer", noise.common_steer, 0.0, 0.1);
  require_in_range("noise.viewpoint_bias", noise.viewpoint_bias, 0.0, 1.0);
  require_in_range("runs", params.runs, 2, 1000000);
  require_in_range("threads", params.threads, 1, 256);
}

// A displacement of this length has half of its square in each coordinate, and there are two ends.
CalibrationNoise told_of_viewpoint_bias(CalibrationNoise told,
                                        const SimulatedCalibrationNoise& simulated) {
  const double near = simulated.min_distance, far = simulated.max_distance;
  const double spread = std::sqrt((near * near + near * far + far * far) / 3.0);
  told.common_position = simulated.viewpoint_bias / std::sqrt(simulated.reflectors);
  told.common_turn = told.common_position / spread;
  return told;
}

std::vector<PathSegment> simulate_calibration_drive(const CalibrationCondition& condition,
                                                    const MonteCarloParams& params,
                                                    std::mt19937_64& random) {
  const TricycleParams& tricycle = params.truth.tricycle;
  const Pose2& laser = params.truth.base_T_laser;
  const SimulatedCalibrationNoise& noise = params.noise;
  const Reflectors points = reflectors(noise, random);
  const double step =
      (condition.max_steering - condition.min_steering) / std::max(1, condition.arcs_per_phase - 1);
  std::vector<PathSegment> segments;
  for (const DrivePhase phase : kAllDrivePhases) {
    const bool left = phase == DrivePhase::kForwardLeft || phase == DrivePhase::kBackwardLeft;
    const EncoderError common = {normal(random, noise.common_slip),
                                 normal(random, noise.common_steer)};
    for (int i = 0; i < condition.arcs_per_phase; ++i) {
      const double magnitude = condition.min_steering + i * step;
      const double ticks =
          condition.turn * tricycle.wheelbase / (tricycle.driving_scale * std::sin(magnitude));
      PathSegment segment;
      segment.ticks = is_forward(phase) ? ticks : -ticks;
      segment.steering = left ? magnitude : -magnitude;
      const double turned = segment.ticks * (1.0 + common.slip + normal(random, noise.slip));
      const double steered =
          params.truth.steer_gain * segment.steering + common.steer + normal(random, noise.steer);
      const Pose2 motion = laser.inverse() * drive_arc(tricycle, turned, steered) * laser;
      segment.start_T_end = measured_motion(motion, points, noise, random);
      const double about = tricycle.driving_scale * turned *
                           std::sin(true_steering(tricycle, steered, turned)) / tricycle.wheelbase;
      segment.turn = unwrapped_turn(segment.start_T_end.pose.theta(), about);
      segments.push_back(segment);
    }
  }
  return segments;
}

}  // namespace falko_slam
