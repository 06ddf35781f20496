// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/calibrator.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "calibration_remarks.hpp"
#include "chi_square_law.hpp"
#include "falko_slam/calibration/extrinsic_calibration.hpp"
#include "falko_slam/calibration/intrinsic_calibration.hpp"
#include "falko_slam/common/validation.hpp"
#include "noise_mixture.hpp"

namespace falko_slam {
namespace {

using Parameter = CalibrationParameter;

constexpr double kGreatestOffset = 0.6;   // [rad]: beyond, a sign is wrong
constexpr double kGreatestMisfit = 0.05;  // of the way of a segment, in the middle of all
constexpr double kImprobable = 1e-3;      // tail of chi2 that is not put down to chance
constexpr double kTail = 0.025;           // on either side of a 95 % interval
constexpr int kRelinearisations = 2;
constexpr int kSelections = 4;

class Calibration {
 public:
  Calibration(const std::vector<PathSegment>& segments, const CalibratorParams& params)
      : segments_(segments), params_(params) {
    for (const PathSegment& segment : segments) {
      set_.stretches.push_back(stretch_of(segment));
      set_.phases.push_back(static_cast<std::size_t>(phase_of(segment)));
      SegmentReport report;
      report.phase = phase_of(segment);
      result_.segments.push_back(report);
    }
    set_.used.assign(segments.size(), true);
  }

  CalibrationResult run() {
    if (!observable() || !start()) return result_;
    leave_out_outliers();
    if (!observable()) return result_;
    estimate();
    report_segments();
    if (contradictory()) return result_;
    judge();
    return result_;
  }

 private:
  bool observable();
  bool start();
  void leave_out_outliers();
  void estimate();
  void report_segments();
  bool contradictory();
  void judge();

  std::vector<PathSegment> used_segments() const;
  double chi2_of(std::size_t segment, const StretchFit& fitted) const;
  void take(const std::vector<MixtureComponent>& mixture);
  void remark(const CalibrationRemark& remark);

  const std::vector<PathSegment>& segments_;
  const CalibratorParams& params_;
  StretchSet set_;
  FreeParameters free_;
  VehicleCalibration at_;
  Eigen::MatrixXd covariance_of_x_;
  CalibrationResult result_;
};

void Calibration::remark(const CalibrationRemark& remark) {
  result_.remarks.push_back(remark);
  result_.verdict = std::max(result_.verdict, remark.verdict);
  if (remark.verdict >= CalibrationVerdict::kUnobservable) result_.calibration.reset();
}

std::vector<PathSegment> Calibration::used_segments() const {
  std::vector<PathSegment> used;
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    if (!set_.used[i]) continue;
    used.push_back(segments_[i]);
    used.back().steering *= params_.steer_gain;
  }
  return used;
}

bool Calibration::observable() {
  result_.observability =
      check_observability(used_segments(), params_.model, params_.observability);
  result_.verdict = result_.observability.verdict;
  result_.remarks = result_.observability.remarks;
  return result_.verdict < CalibrationVerdict::kUnobservable;
}

bool Calibration::start() {
  const std::vector<PathSegment> segments = used_segments();
  const auto tricycle = params_.model == TricycleModel::kStandard
                            ? calibrate_standard(segments, params_.wheelbase)
                            : calibrate_asymmetric(segments, params_.wheelbase);
  if (!tricycle) {
    remark({CalibrationVerdict::kUnobservable,
            {Parameter::kDrivingScale},
            "nothing turns that the wheel could explain",
            "check the egomotion of the laser"});
    return false;
  }
  if (std::max(std::abs(tricycle->steer_offset_forward),
               std::abs(tricycle->steer_offset_backward)) > kGreatestOffset) {
    std::ostringstream reason;
    reason << "the steer offsets would be " << tricycle->steer_offset_forward << " and "
           << tricycle->steer_offset_backward << " rad";
    remark({CalibrationVerdict::kContradictory,
            {Parameter::kSteerOffsetForward, Parameter::kSteerOffsetBackward},
            reason.str(),
            "check the signs of ticks, steering and egomotion"});
    return false;
  }
  const auto laser = calibrate_laser_pose(segments, *tricycle);
  if (!laser) {
    remark({CalibrationVerdict::kUnobservable,
            {Parameter::kLaserX, Parameter::kLaserY, Parameter::kLaserTheta},
            "the arcs have one centre of rotation",
            "drive arcs of a half turn with other steering, on both sides"});
    return false;
  }
  result_.closed_form = VehicleCalibration{*tricycle, params_.steer_gain, *laser};
  at_ = params_.start.value_or(*result_.closed_form);
  free_ = free_parameters({params_.model, params_.free_wheelbase, params_.free_steer_gain}, at_);
  return true;
}

// Without what the phase has in common. Slip and steer noise count as great as they may be.
double Calibration::chi2_of(std::size_t segment, const StretchFit& fitted) const {
  const MeasuredStretch& stretch = set_.stretches[segment];
  const StretchPrediction prediction =
      predict(fitted.calibration, stretch.arcs, fitted.common[set_.phases[segment]]);
  CalibrationNoise noise = params_.noise;
  noise.slip *= noise.unknown_factor;
  noise.steer *= noise.unknown_factor;
  const Eigen::Vector3d residual = stretch.motion - prediction.motion;
  return residual.dot(residual_covariance(stretch, prediction, noise).llt().solve(residual));
}

void Calibration::leave_out_outliers() {
  const auto count = static_cast<double>(segments_.size());
  const bool wanted = params_.outlier_probability > 0.0;
  StretchFit fitted =
      fit(set_, free_, at_, params_.noise, wanted ? FitLoss::kCauchy : FitLoss::kNone);
  if (wanted) {
    const double bound = chi_square_bound(params_.outlier_probability / count, 3);
    for (int i = 0; i < kSelections; ++i) {
      std::vector<bool> sound;
      for (std::size_t k = 0; k < segments_.size(); ++k)
        sound.push_back(chi2_of(k, fitted) <= bound);
      const auto outliers = static_cast<double>(std::count(sound.begin(), sound.end(), false));
      // So many are no outliers; then the noise is not what it was said to be.
      if (outliers > params_.max_outlier_share * count) sound.assign(segments_.size(), true);
      const bool settled = i > 0 && sound == set_.used;
      set_.used = sound;
      if (settled) break;
      const int before = fitted.iterations;
      fitted = fit(set_, free_, fitted.calibration, params_.noise, FitLoss::kNone);
      fitted.iterations += before;
    }
  }
  at_ = fitted.calibration;
  result_.iterations = fitted.iterations;
  if (!fitted.converged) {
    remark({CalibrationVerdict::kWeak, {}, "the refinement did not come to an end", ""});
  }
}

void Calibration::estimate() {
  for (int i = 0; i < kRelinearisations; ++i) {
    const std::vector<MixtureComponent> mixture = noise_mixture(set_, free_, at_, params_.noise);
    if (mixture.empty()) {
      remark({CalibrationVerdict::kUnobservable, {}, "the equations are singular", ""});
      return;
    }
    take(mixture);
  }
}

// The mixture's mean, covariance and quantiles.
void Calibration::take(const std::vector<MixtureComponent>& mixture) {
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(free_.count());
  Eigen::Matrix<double, 2 * kDrivePhases, 1> common = Eigen::Matrix<double, 8, 1>::Zero();
  std::vector<double> weights;
  const MixtureComponent* likeliest = &mixture.front();
  for (const MixtureComponent& component : mixture) {
    mean += component.weight * component.correction;
    common += component.weight * component.common;
    weights.push_back(component.weight);
    if (component.weight > likeliest->weight) likeliest = &component;
  }
  covariance_of_x_ = Eigen::MatrixXd::Zero(free_.count(), free_.count());
  for (const MixtureComponent& component : mixture) {
    const Eigen::VectorXd off = component.correction - mean;
    covariance_of_x_ += component.weight * (component.covariance + off * off.transpose());
  }
  const CalibrationVector here = vector_of(at_);
  for (std::size_t i = 0; i < kCalibrationParameters; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const Eigen::VectorXd by_x = free_.columns.row(row).transpose();
    std::vector<double> means, deviations;
    for (const MixtureComponent& component : mixture) {
      means.push_back(by_x.dot(component.correction));
      deviations.push_back(std::sqrt(by_x.dot(component.covariance * by_x)));
    }
    result_.intervals[i] = {here[row] + mixture_quantile(weights, means, deviations, kTail),
                            here[row] + mixture_quantile(weights, means, deviations, 1.0 - kTail)};
  }
  for (std::size_t phase = 0; phase < kDrivePhases; ++phase) {
    const auto slip = static_cast<Eigen::Index>(phase);
    result_.phase_errors[phase] = {common[slip],
                                   common[slip + static_cast<Eigen::Index>(kDrivePhases)]};
  }
  const auto used = static_cast<int>(std::count(set_.used.begin(), set_.used.end(), true));
  result_.chi2 = likeliest->chi2;
  result_.degrees_of_freedom = 3 * used - static_cast<int>(free_.count());
  at_ = calibration_of(here + free_.columns * mean);
  result_.calibration = at_;
  result_.covariance = free_.columns * covariance_of_x_ * free_.columns.transpose();
}

void Calibration::report_segments() {
  StretchFit fitted;
  fitted.calibration = at_;
  fitted.common = result_.phase_errors;
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    SegmentReport& report = result_.segments[i];
    const MeasuredStretch& stretch = set_.stretches[i];
    report.residual =
        stretch.motion - predict(at_, stretch.arcs, fitted.common[set_.phases[i]]).motion;
    report.chi2 = chi2_of(i, fitted);
    report.used = set_.used[i];
  }
}

bool Calibration::contradictory() {
  if (!result_.calibration) return true;
  std::vector<double> misfits;
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const double way = std::abs(at_.tricycle.driving_scale * segments_[i].ticks);
    misfits.push_back(result_.segments[i].residual.head<2>().norm() / way);
  }
  const auto middle = misfits.begin() + static_cast<std::ptrdiff_t>(misfits.size() / 2);
  std::nth_element(misfits.begin(), middle, misfits.end());
  if (*middle <= kGreatestMisfit) return false;
  std::ostringstream reason;
  reason << "no tricycle drives like that: half of the segments end more than "
         << std::round(100.0 * *middle) << " % of their way beside what is expected";
  remark({CalibrationVerdict::kContradictory,
          {},
          reason.str(),
          "check the signs and units of ticks, steering and egomotion"});
  return true;
}

void Calibration::judge() {
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    if (set_.used[i]) continue;
    std::ostringstream reason;
    reason << "segment " << i + 1 << " (" << name_of(result_.segments[i].phase)
           << ") was left out: chi2 " << result_.segments[i].chi2;
    result_.remarks.push_back({CalibrationVerdict::kOk, {}, reason.str(), "look at its residual"});
  }
  const double excess = result_.chi2 / std::max(1, result_.degrees_of_freedom);
  if (chi_square_tail(result_.chi2, result_.degrees_of_freedom) < kImprobable) {
    result_.covariance *= excess;
    covariance_of_x_ *= excess;
    const CalibrationVector here = vector_of(at_);
    for (std::size_t i = 0; i < kCalibrationParameters; ++i) {
      const double centre = here[static_cast<Eigen::Index>(i)];
      ParameterInterval& interval = result_.intervals[i];
      interval.low = centre + std::sqrt(excess) * (interval.low - centre);
      interval.high = centre + std::sqrt(excess) * (interval.high - centre);
    }
    std::ostringstream reason;
    reason << "chi2 is " << result_.chi2 << " of " << result_.degrees_of_freedom
           << " degrees of freedom: the noise is greater than was said";
    remark({CalibrationVerdict::kWeak, {}, reason.str(), "measure slip and steer noise"});
  }
  for (const auto& weak : weak_parameters(set_, free_, at_, covariance_of_x_, params_)) {
    remark(weak);
  }
  const std::vector<Parameter> tied = tied_parameters(result_.covariance);
  if (!tied.empty()) {
    std::string names;
    for (const Parameter parameter : tied) {
      names += (names.empty() ? "" : ", ") + std::string(name_of(parameter));
    }
    remark({CalibrationVerdict::kWeak, tied, "the data tie " + names + " to each other",
            "measure one of them by other means and hold it"});
  }
}

}  // namespace

void validate(const CalibratorParams& params) {
  require_in_range("wheelbase", params.wheelbase, 0.05, 20.0);
  require_in_range("steer_gain", params.steer_gain, 0.01, 100.0);
  validate(params.noise);
  validate(params.observability);
  require_in_range("limits.steer_offset", params.limits.steer_offset, 1e-9, 1.0);
  require_in_range("limits.driving_scale", params.limits.driving_scale, 1e-9, 1.0);
  require_in_range("limits.laser_position", params.limits.laser_position, 1e-9, 10.0);
  require_in_range("limits.laser_theta", params.limits.laser_theta, 1e-9, 1.0);
  require_in_range("limits.wheelbase", params.limits.wheelbase, 1e-9, 1.0);
  require_in_range("limits.steer_gain", params.limits.steer_gain, 1e-9, 1.0);
  require_in_range("outlier_probability", params.outlier_probability, 0.0, 0.5);
  require_in_range("max_outlier_share", params.max_outlier_share, 0.0, 0.5);
  if (params.start) validate(params.start->tricycle);
}

CalibrationResult calibrate(const std::vector<PathSegment>& segments,
                            const CalibratorParams& params) {
  validate(params);
  validate(segments);
  return Calibration(segments, params).run();
}

}  // namespace falko_slam
