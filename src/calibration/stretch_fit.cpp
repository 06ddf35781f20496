// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "stretch_fit.hpp"

#include <ceres/cost_function.h>
#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <Eigen/Cholesky>
#include <deque>
#include <memory>

namespace falko_slam {
namespace {

constexpr int kReweightings = 3;
constexpr double kLossScale = 2.8;  // 95 % of the lengths of a sound whitened residual are below

using RowMajor = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor>;

// Whitened s - predicted by the blocks x (the calibration) and (slip, steer) of the phase.
class StretchCost : public ceres::CostFunction {
 public:
  StretchCost(const MeasuredStretch& stretch, const FreeParameters& free,
              const VehicleCalibration& start, const Eigen::Matrix3d& covariance)
      : stretch_(stretch), free_(free), start_(vector_of(start)), square_root_(covariance) {
    set_num_residuals(3);
    *mutable_parameter_block_sizes() = {static_cast<int>(free.count()), 2};
  }

  bool Evaluate(const double* const* parameters, double* residuals,
                double** jacobians) const override {
    const Eigen::Map<const Eigen::VectorXd> x(parameters[0], free_.count());
    const StretchPrediction prediction =
        predict(calibration_of(start_ + free_.columns * x), stretch_.arcs,
                {parameters[1][0], parameters[1][1]});
    if (!prediction.motion.allFinite()) return false;
    const auto L = square_root_.matrixL();
    Eigen::Map<Eigen::Vector3d> residual(residuals);
    residual = L.solve(stretch_.motion - prediction.motion);
    if (jacobians == nullptr) return true;
    if (jacobians[0] != nullptr) {
      const Eigen::MatrixXd slopes = prediction.dparameters * free_.columns;
      Eigen::Map<RowMajor>(jacobians[0], 3, free_.count()) = -L.solve(slopes);
    }
    if (jacobians[1] != nullptr) {
      Eigen::Matrix<double, 3, 2> slopes;
      slopes << prediction.dslip, prediction.dsteer;
      Eigen::Map<Eigen::Matrix<double, 3, 2, Eigen::RowMajor>>(jacobians[1], 3, 2) =
          -L.solve(slopes);
    }
    return true;
  }

 private:
  const MeasuredStretch& stretch_;
  const FreeParameters& free_;
  CalibrationVector start_;
  Eigen::LLT<Eigen::Matrix3d> square_root_;
};

// What is known of (slip, steer) of a phase before it is driven.
class CommonPrior : public ceres::CostFunction {
 public:
  CommonPrior(double slip, double steer) : weights_(1.0 / slip, 1.0 / steer) {
    set_num_residuals(2);
    *mutable_parameter_block_sizes() = {2};
  }

  bool Evaluate(const double* const* parameters, double* residuals,
                double** jacobians) const override {
    for (Eigen::Index i = 0; i < 2; ++i) residuals[i] = weights_[i] * parameters[0][i];
    if (jacobians == nullptr || jacobians[0] == nullptr) return true;
    Eigen::Map<Eigen::Matrix<double, 2, 2, Eigen::RowMajor>>(jacobians[0], 2, 2) =
        weights_.asDiagonal();
    return true;
  }

 private:
  Eigen::Vector2d weights_;
};

ceres::Problem::Options problem_options() {
  ceres::Problem::Options options;
  options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  return options;
}

ceres::Solver::Options solver_options() {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = 100;
  options.function_tolerance = 1e-14;
  options.gradient_tolerance = 1e-14;
  options.parameter_tolerance = 1e-12;
  return options;
}

// One solution with weights that stay.
void solve(const StretchSet& set, const FreeParameters& free, const CalibrationNoise& noise,
           ceres::LossFunction* loss, StretchFit& fit) {
  const VehicleCalibration start = fit.calibration;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(free.count());
  std::array<std::array<double, 2>, kDrivePhases> common{};
  std::deque<StretchCost> costs;
  std::deque<CommonPrior> priors;
  ceres::Problem problem(problem_options());
  problem.AddParameterBlock(x.data(), static_cast<int>(free.count()));
  const bool in_common = noise.common_slip > 0.0 && noise.common_steer > 0.0;
  for (std::size_t phase = 0; phase < kDrivePhases; ++phase) {
    common[phase] = {fit.common[phase].slip, fit.common[phase].steer};
    problem.AddParameterBlock(common[phase].data(), 2);
    if (in_common) {
      priors.emplace_back(noise.common_slip, noise.common_steer);
      problem.AddResidualBlock(&priors.back(), nullptr, common[phase].data());
    } else {
      problem.SetParameterBlockConstant(common[phase].data());
    }
  }
  for (std::size_t i = 0; i < set.stretches.size(); ++i) {
    if (!set.used[i]) continue;
    const MeasuredStretch& stretch = set.stretches[i];
    const StretchPrediction prediction = predict(start, stretch.arcs);
    costs.emplace_back(stretch, free, start, residual_covariance(stretch, prediction, noise));
    problem.AddResidualBlock(&costs.back(), loss, x.data(), common[set.phases[i]].data());
  }
  ceres::Solver::Summary summary;
  ceres::Solve(solver_options(), &problem, &summary);
  fit.calibration = calibration_of(vector_of(start) + free.columns * x);
  for (std::size_t phase = 0; phase < kDrivePhases; ++phase) {
    fit.common[phase] = {common[phase][0], common[phase][1]};
  }
  fit.converged = summary.termination_type == ceres::CONVERGENCE;
  fit.iterations += summary.num_successful_steps + summary.num_unsuccessful_steps;
}

}  // namespace

FreeParameters free_parameters(const FreeChoice& choice, const VehicleCalibration& start) {
  using Parameter = CalibrationParameter;
  std::vector<CalibrationVector> columns;
  const auto add = [&columns](Parameter parameter, double scale) {
    columns.emplace_back(CalibrationVector::Zero());
    columns.back()[static_cast<Eigen::Index>(index_of(parameter))] = scale;
  };
  add(Parameter::kSteerOffsetForward, 1.0);
  if (choice.model == TricycleModel::kStandard) {
    columns.back()[static_cast<Eigen::Index>(index_of(Parameter::kSteerOffsetBackward))] = 1.0;
  } else {
    add(Parameter::kSteerOffsetBackward, 1.0);
  }
  add(Parameter::kDrivingScale, start.tricycle.driving_scale);
  add(Parameter::kLaserX, 1.0);
  add(Parameter::kLaserY, 1.0);
  add(Parameter::kLaserTheta, 1.0);
  if (choice.wheelbase) add(Parameter::kWheelbase, start.tricycle.wheelbase);
  if (choice.steer_gain) add(Parameter::kSteerGain, start.steer_gain);
  FreeParameters free;
  free.columns.resize(Eigen::NoChange, static_cast<Eigen::Index>(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i) {
    free.columns.col(static_cast<Eigen::Index>(i)) = columns[i];
  }
  return free;
}

Eigen::Matrix3d residual_covariance(const MeasuredStretch& stretch,
                                    const StretchPrediction& prediction,
                                    const CalibrationNoise& noise) {
  const Eigen::Vector3d by_slip = noise.slip * prediction.dslip;
  const Eigen::Vector3d by_steer = noise.steer * prediction.dsteer;
  return stretch.covariance + by_slip * by_slip.transpose() + by_steer * by_steer.transpose();
}

StretchFit fit(const StretchSet& set, const FreeParameters& free, const VehicleCalibration& start,
               const CalibrationNoise& noise, FitLoss loss) {
  ceres::CauchyLoss cauchy(kLossScale);
  StretchFit result;
  result.calibration = start;
  for (int i = 0; i < kReweightings; ++i) {
    solve(set, free, noise, loss == FitLoss::kCauchy ? &cauchy : nullptr, result);
  }
  return result;
}

}  // namespace falko_slam
