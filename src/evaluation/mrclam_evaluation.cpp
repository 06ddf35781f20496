// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/mrclam_evaluation.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>

#include "falko_slam/common/chi_square.hpp"
#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/localization/pose_filter.hpp"

namespace falko_slam {
namespace {

constexpr Duration kSamplePeriod = std::chrono::seconds(1);
constexpr Duration kTruthGap = std::chrono::milliseconds(100);

double median_of(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

bool inside(double value, int degrees) {
  return value > chi_square_bound(0.975, degrees) && value < chi_square_bound(0.025, degrees);
}

double share_of(std::size_t part, std::size_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

// How far off the filter or the odometry is.
class ErrorSum {
 public:
  void add(const Pose2& estimate, const Pose2& truth) {
    position_.push_back((estimate.translation() - truth.translation()).norm());
    heading_.push_back(std::abs(angle_between(truth.theta(), estimate.theta())));
  }
  PoseRmse rmse() const { return {root_mean_square(position_), root_mean_square(heading_)}; }
  double median_position() const { return median_of(position_); }
  double median_heading() const { return median_of(heading_); }

 private:
  static double root_mean_square(const std::vector<double>& errors) {
    double sum = 0.0;
    for (const double error : errors) sum += error * error;
    return errors.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(errors.size()));
  }
  std::vector<double> position_, heading_;
};

class Replay {
 public:
  Replay(const MrclamRun& run, const MrclamParams& params)
      : run_(run), params_(params), truth_(run.truth), map_(map_of(run)) {
    const auto start = run.odometry.empty()
                           ? std::nullopt
                           : truth_.interpolate(run.odometry.front().stamp, kTruthGap);
    if (!start) throw std::runtime_error("no odometry, or no true pose where it begins");
    odometry_ = *start;
    filter_ = std::make_unique<PoseFilter>(PoseFilterParams{{}, params.association}, map_,
                                           PoseEstimate{*start, pose_covariance(0.05, 0.05)});
  }

  MrclamEvaluation evaluate() {
    const auto& odometry = run_.odometry;
    Time next_sample = odometry.front().stamp;
    for (std::size_t i = 0; i + 1 < odometry.size(); ++i) {
      drive(odometry[i], odometry[i + 1].stamp);
      look(odometry[i].stamp, odometry[i + 1].stamp);
      if (odometry[i + 1].stamp < next_sample) continue;
      next_sample += kSamplePeriod;
      sample(odometry[i + 1].stamp);
    }
    return summary();
  }

 private:
  static std::shared_ptr<const LandmarkIndex> map_of(const MrclamRun& run) {
    std::vector<Landmark> landmarks;
    for (const MrclamLandmark& landmark : run.landmarks) {
      landmarks.push_back({landmark.number, landmark.position.point, landmark.position.covariance});
    }
    return std::make_shared<LandmarkIndex>(std::move(landmarks));
  }

  void drive(const MrclamOdometry& command, Time until) {
    const double time = std::max(0.0, to_seconds(until - command.stamp));
    const double way = command.speed * time;
    const double turn = params_.turn_scale * command.turn_rate * time;
    odometry_ = odometry_ * Pose2::exp({way, 0.0, turn});
    const double along = params_.way_noise * params_.way_noise * std::abs(way);
    const bool moves = way != 0.0 || turn != 0.0;
    const double about = params_.turn_noise * params_.turn_noise * std::abs(turn) +
                         (moves ? params_.heading_drift * params_.heading_drift * time : 0.0);
    PoseEstimate motion{Pose2::exp({way, 0.0, turn}), Eigen::Matrix3d::Zero()};
    motion.covariance.diagonal() << along, along, about;
    filter_->predict(motion);
  }

  // How much the noise of a landmark's observation counts for more: n of them, correlated by rho
  // from one to the next, tell as much as n (1 - rho) / (1 + rho) new ones.
  double inflation(const MrclamMeasurement& measurement) {
    double factor = 1.0;
    const auto before = last_seen_.find(measurement.landmark);
    if (params_.correlation_time > 0.0 && before != last_seen_.end()) {
      const double gap = std::max(0.01, to_seconds(measurement.stamp - before->second));
      const double rho = std::exp(-gap / params_.correlation_time);
      factor = (1.0 + rho) / (1.0 - rho);
    }
    last_seen_[measurement.landmark] = measurement.stamp;
    return factor;
  }

  void look(Time from, Time until) {
    std::vector<LandmarkObservation> observations;
    std::vector<std::uint32_t> numbers;
    for (; next_ < run_.measurements.size() && run_.measurements[next_].stamp <= until; ++next_) {
      const MrclamMeasurement& measurement = run_.measurements[next_];
      if (measurement.stamp <= from) continue;
      LandmarkObservation observation;
      observation.model = ObservationModel::kRangeBearing;
      observation.value << measurement.range, measurement.bearing;
      observation.covariance =
          inflation(measurement) * Eigen::Vector2d(params_.range_noise * params_.range_noise,
                                                   params_.bearing_noise * params_.bearing_noise)
                                       .asDiagonal()
                                       .toDenseMatrix();
      if (params_.use_ids) observation.id = measurement.landmark;
      observations.push_back(observation);
      numbers.push_back(measurement.landmark);
    }
    if (!observations.empty()) note(filter_->update(observations), numbers);
  }

  void note(const PoseUpdate& update, const std::vector<std::uint32_t>& numbers) {
    result_.observations += numbers.size();
    result_.used += update.association.pairs.size();
    for (const LandmarkPair& pair : update.association.pairs) {
      if (map_->landmarks()[pair.landmark].id != numbers[pair.observation]) ++result_.wrong;
    }
    if (!update.corrected()) return;
    ++result_.updates;
    nis_ += update.nis;
    nis_degrees_ += update.degrees_of_freedom;
    if (inside(update.nis, update.degrees_of_freedom)) ++nis_inside_;
  }

  void sample(Time stamp) {
    const auto truth = truth_.interpolate(stamp, kTruthGap);
    if (!truth) return;
    const PoseEstimate& estimate = filter_->map_T_base();
    filter_errors_.add(estimate.pose, *truth);
    odometry_errors_.add(odometry_, *truth);
    const Eigen::Vector3d error(estimate.pose.x() - truth->x(), estimate.pose.y() - truth->y(),
                                angle_between(truth->theta(), estimate.pose.theta()));
    nees_.push_back(error.dot(estimate.covariance.ldlt().solve(error)));
  }

  MrclamEvaluation summary() {
    result_.filter = filter_errors_.rmse();
    result_.odometry = odometry_errors_.rmse();
    result_.median_position = filter_errors_.median_position();
    result_.median_heading = filter_errors_.median_heading();
    result_.mean_nis = nis_degrees_ > 0 ? nis_ / nis_degrees_ : 0.0;
    result_.nis_inside = share_of(nis_inside_, result_.updates);
    std::size_t good = 0;
    double sum = 0.0;
    for (const double nees : nees_) {
      good += inside(nees, 3) ? 1 : 0;
      sum += nees;
    }
    result_.mean_nees = nees_.empty() ? 0.0 : sum / (3.0 * static_cast<double>(nees_.size()));
    result_.median_nees = median_of(nees_) / 3.0;
    result_.nees_inside = share_of(good, nees_.size());
    return result_;
  }

  const MrclamRun& run_;
  const MrclamParams& params_;
  TrajectoryIndex truth_;
  std::shared_ptr<const LandmarkIndex> map_;
  std::unique_ptr<PoseFilter> filter_;
  Pose2 odometry_;
  std::size_t next_ = 0;
  std::map<std::uint32_t, Time> last_seen_;
  MrclamEvaluation result_;
  ErrorSum filter_errors_, odometry_errors_;
  double nis_ = 0.0;
  int nis_degrees_ = 0;
  std::size_t nis_inside_ = 0;
  std::vector<double> nees_;
};

}  // namespace

void validate(const MrclamParams& params) {
  require_in_range("way_noise", params.way_noise, 0.0, 10.0);
  require_in_range("turn_noise", params.turn_noise, 0.0, 10.0);
  require_in_range("heading_drift", params.heading_drift, 0.0, 10.0);
  require_in_range("turn_scale", params.turn_scale, 1e-3, 10.0);
  require_in_range("range_noise", params.range_noise, 1e-6, 10.0);
  require_in_range("bearing_noise", params.bearing_noise, 1e-6, 10.0);
  require_in_range("correlation_time", params.correlation_time, 0.0, 1000.0);
  validate(params.association);
}

MrclamEvaluation evaluate_mrclam(const MrclamRun& run, const MrclamParams& params) {
  validate(params);
  return Replay(run, params).evaluate();
}

}  // namespace falko_slam
