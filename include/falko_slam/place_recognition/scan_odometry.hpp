// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "falko_slam/place_recognition/scan_agreement.hpp"
#include "falko_slam/place_recognition/scan_registration.hpp"

namespace falko_slam {

struct ScanOdometryParams {
  /// A registration is taken if it moves the odometry's step by no more than this [m], [rad], if
  /// this share of the walls in view agrees, and if the walls leave no direction open (see
  /// Registration::constraint). With a move of 0 steps are taken as they are.
  /// [0, 100], [0, pi], [0, 1], [0, 1]
  double max_move = 0.5;
  double max_turn = 0.35;
  double min_agreement = 0.5;
  double min_constraint = 0.05;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const ScanOdometryParams& params);

/// Odometry from keyframe to keyframe, each step mended by registering the scan with the one
/// before: right to a few centimetres over some metres, which the raw odometry of wheels is not.
///
/// Frame: the odometry's at the first keyframe; from there on it drifts in its own way. Where
/// registration does not help the step is the odometry's. Not thread-safe.
class ScanOdometry {
 public:
  explicit ScanOdometry(const ScanOdometryParams& params = {},
                        const RegistrationParams& registration = {},
                        const AgreementParams& agreement = {});

  /// The mended pose of the scan, for each keyframe in turn.
  Pose2 add(const ScanView& view, const Pose2& odom_T_laser);
  /// What comes next has nothing to do with what was before.
  void reset() { last_.reset(); }

 private:
  struct Last {
    ScanView view;
    Pose2 odom_T_laser;
    Pose2 mended;
  };

  Pose2 mended_step(const ScanView& view, const Pose2& step) const;

  ScanOdometryParams params_;
  RegistrationParams registration_;
  AgreementParams agreement_;
  std::optional<Last> last_;
};

}  // namespace falko_slam
