// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/slam/scan_link.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "shared_noise.hpp"

namespace falko_slam {
namespace {

// Where the scans say nothing, the covariance is that of anywhere. [m], [rad]
constexpr double kAnywhere = 10.0;

Eigen::Matrix3d covariance_of(const Eigen::Matrix3d& information) {
  const Eigen::Matrix3d anywhere = Eigen::Matrix3d::Identity() / (kAnywhere * kAnywhere);
  Eigen::Matrix3d covariance = (information + anywhere).inverse();
  covariance += shared_noise();
  return 0.5 * (covariance + covariance.transpose());
}

bool enough(const Agreement& found, const ScanLinkParams& params) {
  return found.ratio() >= params.min_agreement && found.agreeing_length >= params.min_wall &&
         static_cast<double>(found.seen()) >= params.min_view * static_cast<double>(found.points);
}

}  // namespace

void validate(const ScanLinkParams& params) {
  require_in_range("max_move", params.max_move, 0.0, 10.0);
  require_in_range("max_turn", params.max_turn, 0.0, kPi);
  require_in_range("min_agreement", params.min_agreement, 0.0, 1.0);
  require_in_range("min_wall", params.min_wall, 0.0, 1000.0);
  require_in_range("min_view", params.min_view, 0.0, 1.0);
}

std::optional<ScanLink> link_scans(const ScanView& target, const ScanView& source,
                                   const PoseEstimate& guess, const ScanLinkParams& params,
                                   const AgreementParams& agreement_params) {
  const auto found = register_scan({{&target, Pose2()}}, source, guess.pose, RegistrationParams(),
                                   guess.covariance.inverse());
  if (!found) return std::nullopt;
  const Pose2& pose = found->target_T_source.pose;
  const Pose2 move = guess.pose.inverse() * pose;
  if (move.translation().norm() > params.max_move || std::abs(move.theta()) > params.max_turn) {
    return std::nullopt;
  }
  const Agreement forward = agreement(target, source, pose, agreement_params);
  if (!enough(forward, params)) return std::nullopt;
  const Agreement backward = agreement(source, target, pose.inverse(), agreement_params);
  if (!enough(backward, params)) return std::nullopt;
  return ScanLink{{pose, covariance_of(found->information)},
                  std::min(forward.ratio(), backward.ratio())};
}

}  // namespace falko_slam
