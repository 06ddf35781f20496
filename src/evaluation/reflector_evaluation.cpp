// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/reflector_evaluation.hpp"

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <optional>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/trajectory.hpp"
#include "falko_slam/simulation/simulation.hpp"

namespace falko_slam {
namespace {

constexpr double kSame = 0.3;             // from a true reflector [m]
constexpr std::size_t kRemembered = 100;  // control periods, more than a scan takes
constexpr std::array<double, 8> kBands = {0.0, 2.0, 5.0, 10.0, 15.0, 20.0, 30.0, 100.0};

void add(ReflectorErrors& errors, const Eigen::Vector2d& error, const Eigen::Vector2d& truth,
         double nees) {
  const Eigen::Vector2d sight = truth.normalized();
  const double along = sight.dot(error);
  const double across = sight.x() * error.y() - sight.y() * error.x();
  ++errors.count;
  errors.along_bias += along;
  errors.along_rms += along * along;
  errors.across_bias += across;
  errors.across_rms += across * across;
  errors.nees += nees;
}

// From sums to means.
void finish(ReflectorErrors& errors) {
  if (errors.count == 0) return;
  const auto count = static_cast<double>(errors.count);
  errors.along_bias /= count;
  errors.across_bias /= count;
  errors.along_rms = std::sqrt(errors.along_rms / count);
  errors.across_rms = std::sqrt(errors.across_rms / count);
  errors.nees /= count;
}

Eigen::Vector2d point_of(const ReflectorDetection& found) {
  return found.range * Eigen::Vector2d(std::cos(found.bearing), std::sin(found.bearing));
}

// A reflector of the world as the laser should have seen it.
struct TrueReflector {
  std::size_t index;
  Eigen::Vector2d in_laser;
};

class ReflectorComparison {
 public:
  ReflectorComparison(const Scenario& scenario, const ReflectorEvaluationParams& params)
      : laser_(scenario.laser),
        base_T_laser_(scenario.vehicle.base_T_laser),
        reflectors_(reflectors_of(scenario.world)),
        detector_(with_diameter(params.detector, scenario.world)) {
    for (std::size_t i = 0; i + 1 < kBands.size(); ++i) {
      result_.bands.push_back({kBands[i], kBands[i + 1], {}, {}, {}});
    }
  }

  // `poses` of base_link reach over the scan.
  void compare(const SimulationStep::Scan& scan, const Trajectory& poses) {
    poses_ = TrajectoryIndex(poses);
    begin_ = scan.scan.first_beam;
    normalize(as_raw_scan(laser_, scan.scan), {}, scan_);
    detector_.detect(scan_, found_);
    ++result_.scans;
    result_.found += found_.size();
    result_.reported += scan.reflectors.size();
    std::vector<std::optional<Eigen::Vector2d>> reported = errors_of(scan.reflectors);
    std::vector<bool> seen(reflectors_.size());
    for (const DetectedReflector& found : found_) judge(found, reported, seen);
    for (std::size_t i = 0; i < reported.size(); ++i) {
      if (reported[i] && !seen[i]) ++result_.missed;
    }
  }

  ReflectorEvaluation result() {
    for (ReflectorBand& band : result_.bands) {
      finish(band.found);
      finish(band.hidden);
      finish(band.reported);
    }
    return result_;
  }

 private:
  static ReflectorDetectorParams with_diameter(ReflectorDetectorParams params, const World& world) {
    params.diameter = diameter_of_reflectors(world);
    return params;
  }

  std::optional<TrueReflector> truth_near(const Eigen::Vector2d& point, Time time) const {
    const auto world_T_base = poses_.interpolate(time, std::chrono::seconds(1));
    if (!world_T_base) return std::nullopt;
    const Pose2 laser_T_world = (*world_T_base * base_T_laser_).inverse();
    for (std::size_t i = 0; i < reflectors_.size(); ++i) {
      const Eigen::Vector2d truth = laser_T_world * reflectors_[i].center;
      if ((truth - point).norm() < kSame) return TrueReflector{i, truth};
    }
    return std::nullopt;
  }

  // What the device says of each true reflector, minus the truth.
  std::vector<std::optional<Eigen::Vector2d>> errors_of(
      const std::vector<ReflectorDetection>& reported) const {
    std::vector<std::optional<Eigen::Vector2d>> errors(reflectors_.size());
    for (const ReflectorDetection& other : reported) {
      const auto truth = truth_near(point_of(other), begin_ + from_seconds(other.time_offset));
      if (truth) errors[truth->index] = point_of(other) - truth->in_laser;
    }
    return errors;
  }

  void judge(const DetectedReflector& found,
             const std::vector<std::optional<Eigen::Vector2d>>& reported, std::vector<bool>& seen) {
    const auto truth = truth_near(found.center, found.time);
    if (!truth) {
      ++result_.strangers;
      return;
    }
    seen[truth->index] = true;
    const Eigen::Vector2d error = found.center - truth->in_laser;
    const double nees = error.dot(found.covariance.inverse() * error);
    ReflectorBand& band = band_of(truth->in_laser.norm());
    add(band.found, error, truth->in_laser, nees);
    if (found.partly_hidden) add(band.hidden, error, truth->in_laser, nees);
    if (reported[truth->index]) {
      add(band.reported, *reported[truth->index], truth->in_laser, 0.0);
    }
  }

  ReflectorBand& band_of(double range) {
    std::size_t band = 0;
    while (band + 1 < result_.bands.size() && range >= result_.bands[band].to) ++band;
    return result_.bands[band];
  }

  LaserModel laser_;
  Pose2 base_T_laser_;
  std::vector<Cylinder> reflectors_;
  ReflectorDetector detector_;
  TrajectoryIndex poses_{Trajectory()};
  Time begin_{};
  LaserScan scan_;
  std::vector<DetectedReflector> found_;
  ReflectorEvaluation result_;
};

}  // namespace

void validate(const ReflectorEvaluationParams& params) {
  validate(params.detector);
  require_in_range("every", params.every, 1, 1000);
  require_in_range("duration", params.duration, 0.1, 1e6);
}

ReflectorEvaluation evaluate_reflectors(const Scenario& scenario,
                                        const ReflectorEvaluationParams& params,
                                        const std::function<void()>& step) {
  validate(params);
  Simulation simulation(scenario, kSimulationStart, params.seed);
  const auto driver = scenario_driver(scenario.drive, scenario.vehicle);
  ReflectorComparison comparison(scenario, params);
  Trajectory poses = {{kSimulationStart, simulation.state().world_T_base}};
  std::size_t scans = 0;
  while (simulation.time() - kSimulationStart < from_seconds(params.duration)) {
    const auto input = driver->next(simulation.vehicle(), simulation.period());
    if (!input) break;
    const SimulationStep now = simulation.step(*input);
    poses.push_back({simulation.time(), now.world_T_base});
    for (const SimulationStep::Scan& scan : now.scans) {
      if (scans++ % static_cast<std::size_t>(params.every) == 0) comparison.compare(scan, poses);
      step();
    }
    if (poses.size() > 2 * kRemembered) poses.erase(poses.begin(), poses.end() - kRemembered);
  }
  return comparison.result();
}

}  // namespace falko_slam
