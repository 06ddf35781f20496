// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/pose_filter.hpp"

#include <Eigen/LU>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "covariance_check.hpp"

namespace falko_slam {
namespace {

Eigen::Matrix3d symmetric(const Eigen::Matrix3d& matrix) {
  return 0.5 * (matrix + matrix.transpose());
}

}  // namespace

PoseEstimate tricycle_motion(const TricycleParams& tricycle, double ticks,
                             const SteeringSweep& steering, const OdometryNoise& noise) {
  const double mean = 0.5 * (steering.before + steering.after);  // (5.10)
  return {drive_rk2(tricycle, ticks, steering), arc_covariance(tricycle, ticks, mean, noise)};
}

PoseCorrection correct(const PoseEstimate& map_T_base, const std::vector<LandmarkPair>& pairs) {
  PoseCorrection result{map_T_base, 0.0};
  Eigen::Matrix3d& P = result.map_T_base.covariance;
  Eigen::Vector3d step = Eigen::Vector3d::Zero();
  for (const LandmarkPair& pair : pairs) {
    const auto& H = pair.dobservation_dpose;
    const Eigen::Vector2d innovation = pair.innovation - H * step;
    const Eigen::Matrix2d inverse_S = (H * P * H.transpose() + pair.noise).inverse();
    const Eigen::Matrix<double, 3, 2> K = P * H.transpose() * inverse_S;  // (5.5)
    const Eigen::Matrix3d I_KH = Eigen::Matrix3d::Identity() - K * H;
    step += K * innovation;                                                       // (5.6)
    P = symmetric(I_KH * P * I_KH.transpose() + K * pair.noise * K.transpose());  // (5.7)
    result.nis += innovation.dot(inverse_S * innovation);
  }
  const Pose2& pose = map_T_base.pose;
  result.map_T_base.pose = {pose.x() + step.x(), pose.y() + step.y(), pose.theta() + step.z()};
  return result;
}

void validate(const PoseFilterParams& params) {
  if (!is_finite(params.base_T_laser)) {
    std::ostringstream text;
    text << "base_T_laser = " << params.base_T_laser << ": must be finite";
    throw std::invalid_argument(text.str());
  }
  validate(params.association);
}

PoseFilter::PoseFilter(const PoseFilterParams& params, std::shared_ptr<const LandmarkIndex> map,
                       const PoseEstimate& map_T_base)
    : params_(params), map_(std::move(map)) {
  validate(params_);
  if (!map_) throw std::invalid_argument("map: there is none");
  reset(map_T_base);
}

void PoseFilter::reset(const PoseEstimate& map_T_base) {
  if (!is_usable(map_T_base)) {
    throw std::invalid_argument(
        "map_T_base: must be finite, with a symmetric positive semidefinite covariance");
  }
  map_T_base_ = map_T_base;
}

bool PoseFilter::predict(const PoseEstimate& motion) {
  if (!is_usable(motion)) return false;
  PoseEstimate moved = compose(map_T_base_, motion);
  moved.covariance = symmetric(moved.covariance);
  if (!is_usable(moved)) return false;
  map_T_base_ = moved;
  return true;
}

PoseUpdate PoseFilter::update(const std::vector<LandmarkObservation>& observations) {
  PoseUpdate update;
  update.association =
      associate(map_T_base_, params_.base_T_laser, *map_, observations, params_.association);
  const PoseCorrection correction = correct(map_T_base_, update.association.pairs);
  if (!is_usable(correction.map_T_base)) {  // overflow: only of absurd numbers
    for (const LandmarkPair& pair : update.association.pairs) {
      update.association.verdicts[pair.observation] = ObservationVerdict::kInvalid;
    }
    update.association.pairs.clear();
    return update;
  }
  map_T_base_ = correction.map_T_base;
  update.nis = correction.nis;
  update.degrees_of_freedom = 2 * static_cast<int>(update.association.pairs.size());
  return update;
}

}  // namespace falko_slam
