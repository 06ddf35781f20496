// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/path_segment.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

constexpr double kSameAngle = 1e-6;  // [rad]

[[noreturn]] void refuse(std::size_t index, const char* field, double value, const char* why) {
  std::ostringstream text;
  text << "segments[" << index + 1 << "]." << field << " = " << value << ": " << why;
  throw std::invalid_argument(text.str());
}

void require_finite(std::size_t index, const char* field, double value) {
  if (!std::isfinite(value)) refuse(index, field, value, "must be finite");
}

void validate(const PathSegment& segment, std::size_t index) {
  const Pose2& pose = segment.start_T_end.pose;
  require_finite(index, "ticks", segment.ticks);
  require_finite(index, "steering", segment.steering);
  require_finite(index, "turn", segment.turn);
  require_finite(index, "start_T_end.x", pose.x());
  require_finite(index, "start_T_end.y", pose.y());
  require_finite(index, "start_T_end.theta", pose.theta());
  if (segment.ticks == 0.0) refuse(index, "ticks", 0.0, "the driven wheel did not turn");
  if (std::abs(segment.steering) >= kPi) {
    refuse(index, "steering", segment.steering, "must be in (-pi, pi)");
  }
  if (std::abs(angle_between(pose.theta(), segment.turn)) > kSameAngle) {
    refuse(index, "turn", segment.turn, "is not start_T_end.theta and whole turns");
  }
  const Eigen::Matrix3d& covariance = segment.start_T_end.covariance;
  const bool symmetric =
      covariance.allFinite() && covariance.isApprox(covariance.transpose(), 1e-9);
  if (!symmetric || covariance.llt().info() != Eigen::Success) {
    refuse(index, "start_T_end.covariance", covariance.determinant(),
           "its determinant: it must be symmetric and positive definite");
  }
}

// Block by block, as a matrix that is positive definite can be decomposed.
void validate_covariance_of_all(const std::vector<PathSegment>& segments) {
  Eigen::Matrix3d left = Eigen::Matrix3d::Zero();  // of a covariance when those before are known
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Eigen::Matrix3d& with_next = segments[i].covariance_with_next;
    require_finite(i, "covariance_with_next", with_next.norm());
    left = segments[i].start_T_end.covariance - left;
    const Eigen::LLT<Eigen::Matrix3d> root(left);
    if (root.info() != Eigen::Success) {
      refuse(i - 1, "covariance_with_next", segments[i - 1].covariance_with_next.norm(),
             "its norm: with the next segment there is no positive definite covariance");
    }
    left = with_next.transpose() * root.solve(with_next);
  }
}

}  // namespace

const char* name_of(DrivePhase phase) {
  switch (phase) {
    case DrivePhase::kForwardLeft:
      return "forward left";
    case DrivePhase::kForwardRight:
      return "forward right";
    case DrivePhase::kBackwardLeft:
      return "backward left";
    case DrivePhase::kBackwardRight:
      return "backward right";
  }
  return "?";
}

bool is_forward(DrivePhase phase) {
  return phase == DrivePhase::kForwardLeft || phase == DrivePhase::kForwardRight;
}

void validate(const std::vector<PathSegment>& segments) {
  for (std::size_t i = 0; i < segments.size(); ++i) validate(segments[i], i);
  validate_covariance_of_all(segments);
}

DrivePhase phase_of(const PathSegment& segment) {
  const bool left = segment.steering >= 0.0;
  if (segment.ticks > 0.0) return left ? DrivePhase::kForwardLeft : DrivePhase::kForwardRight;
  return left ? DrivePhase::kBackwardLeft : DrivePhase::kBackwardRight;
}

double unwrapped_turn(double heading, double about) {
  return about + angle_between(about, heading);
}

}  // namespace falko_slam
