// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "next_arc.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <sstream>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

struct Arc {
  DrivePhase phase;
  double steering;
};

std::vector<Arc> possible_arcs() {
  std::vector<Arc> arcs;
  for (const DrivePhase phase : kAllDrivePhases) {
    const bool left = phase == DrivePhase::kForwardLeft || phase == DrivePhase::kBackwardLeft;
    for (const double degrees : {20.0, 30.0, 40.0, 50.0}) {
      arcs.push_back({phase, degrees_to_radians(left ? degrees : -degrees)});
    }
  }
  return arcs;
}

// Half a turn, seen as well as the others were on the average.
MeasuredStretch imagined(const Arc& arc, const VehicleCalibration& calibration,
                         const StretchSet& set) {
  const TricycleParams& tricycle = calibration.tricycle;
  const double ticks =
      kPi * tricycle.wheelbase / (tricycle.driving_scale * std::sin(std::abs(arc.steering)));
  MeasuredStretch stretch{{{is_forward(arc.phase) ? ticks : -ticks, arc.steering}}, {}, {}};
  stretch.covariance.setZero();
  for (const MeasuredStretch& other : set.stretches) stretch.covariance += other.covariance;
  stretch.covariance /= static_cast<double>(set.stretches.size());
  return stretch;
}

}  // namespace

std::string next_arc_for(CalibrationParameter parameter, const StretchSet& set,
                         const FreeParameters& free, const JointEstimate& joint,
                         const CalibrationNoise& noise) {
  const VehicleCalibration& calibration = joint.estimate.calibration;
  const Eigen::MatrixXd information = joint.covariance_of_x.inverse();
  const Eigen::VectorXd by_x =
      free.columns.row(static_cast<Eigen::Index>(index_of(parameter))).transpose();
  double least = std::numeric_limits<double>::infinity();
  Arc best{};
  for (const Arc& arc : possible_arcs()) {
    const MeasuredStretch stretch = imagined(arc, calibration, set);
    const StretchPrediction prediction = predict(calibration, stretch.arcs);
    const Eigen::Matrix3d covariance = residual_covariance(stretch, prediction, noise);
    const Eigen::MatrixXd H = prediction.dparameters * free.columns;
    const Eigen::MatrixXd more = information + H.transpose() * covariance.llt().solve(H);
    const double variance = by_x.dot(more.llt().solve(by_x));
    if (variance >= least) continue;
    least = variance;
    best = arc;
  }
  std::ostringstream text;
  text << "drive more arcs " << name_of(best.phase) << ", half a turn steered by about "
       << std::round(radians_to_degrees(std::abs(best.steering))) << " degrees";
  return text.str();
}

}  // namespace falko_slam
