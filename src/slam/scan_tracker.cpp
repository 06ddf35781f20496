// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/slam/scan_tracker.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "shared_noise.hpp"

namespace falko_slam {
namespace {

// Motion does not go on by itself over a longer time than this [s].
constexpr double kLongestCoast = 1.0;
// A fit that leaves much of the scan unexplained may be a wrong one by about this [m], [rad].
constexpr double kDoubtfulDistance = 0.3;
constexpr double kDoubtfulTurn = 0.2;

RegistrationParams tracking_registration() {
  RegistrationParams params;
  params.iterations = 10;
  params.loss_scale = 0.05;
  return params;
}

// The same covariance, its x and y along the axes of a frame that is turned by `angle`.
Eigen::Matrix3d seen_from(const Eigen::Matrix3d& covariance, double angle) {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  rotation.topLeftCorner<2, 2>() = Pose2(0.0, 0.0, angle).rotation();
  return rotation.transpose() * covariance * rotation;
}

// Of an empty scan nothing is to be remembered.
bool shows_enough(const ScanView& view) { return view.points().size() >= 10; }

// Nothing turns or moves farther between two scans unseen: rooms and corridors that look alike
// turned around would be mistaken for themselves. [m], [rad]
constexpr double kFarthestStart = 1.5;
constexpr double kWidestStart = 1.0;

bool same_place(const Pose2& a, const Pose2& b) {
  constexpr double kNear = 0.02;  // [m], [rad]
  const Pose2 difference = a.inverse() * b;
  return difference.translation().norm() < kNear && std::abs(difference.theta()) < kNear;
}

}  // namespace

void validate(const ScanTrackerParams& params) {
  require_in_range("min_step", params.min_step, 0.01, 100.0);
  require_in_range("min_turn", params.min_turn, 0.01, kPi);
  require_in_range("local_keyframes", params.local_keyframes, 1, 100);
  require_in_range("odometry_distance", params.odometry_distance, 1e-4, 10.0);
  require_in_range("odometry_turn", params.odometry_turn, 1e-4, 10.0);
  require_in_range("odometry_share", params.odometry_share, 0.0, 10.0);
  require_in_range("free_distance", params.free_distance, 1e-4, 10.0);
  require_in_range("free_turn", params.free_turn, 1e-4, 10.0);
  require_in_range("good_agreement", params.good_agreement, 0.0, 1.0);
  require_in_range("least_agreement", params.least_agreement, 0.0, 1.0);
  require_in_range("max_jump", params.max_jump, 0.1, 1e6);
}

ScanTracker::ScanTracker(const ScanTrackerParams& params, const KeyframeParams& keyframe,
                         const AgreementParams& agreement)
    : params_((validate(params), params)),
      registration_(tracking_registration()),
      agreement_((validate(agreement), agreement)),
      builder_(keyframe),
      source_view_(keyframe.view) {
  source_view_.normals = false;
}

void ScanTracker::reset() {
  local_.clear();
  last_.reset();
}

ScanTracker::Prediction ScanTracker::predict(Time stamp,
                                             const std::optional<Pose2>& odom_T_laser) const {
  const double gap = to_seconds(stamp - last_->stamp);
  Pose2 step = gap > 0.0 && gap < kLongestCoast ? last_->step : Pose2();
  Eigen::Matrix3d noise = pose_covariance(params_.free_distance, params_.free_turn);
  if (odom_T_laser && last_->odom_T_laser) {
    const Pose2 driven = last_->odom_T_laser->inverse() * *odom_T_laser;
    const double way = driven.translation().norm();
    if (way <= params_.max_jump) {
      const double share = params_.odometry_share;
      step = driven;
      noise = pose_covariance(params_.odometry_distance + share * way,
                              params_.odometry_turn + share * std::abs(driven.theta()));
    }
  }
  return {step, last_->track_T_laser * step, last_->covariance + noise, gap};
}

// Of the keyframe that shows most of the scan.
double ScanTracker::agreement_at(const ScanView& view, const Pose2& pose) const {
  constexpr double kEnoughView = 0.5;
  constexpr std::size_t kStride = 2;
  Agreement best;
  for (auto local = local_.rbegin(); local != local_.rend(); ++local) {
    const Agreement found =
        agreement(local->view, view, local->track_T_laser.inverse() * pose, agreement_, kStride);
    if (found.agreeing_length > best.agreeing_length) best = found;
  }
  if (best.points == 0) return 0.0;
  const double points = std::ceil(static_cast<double>(best.points) / kStride);
  return best.ratio() * std::min(1.0, static_cast<double>(best.seen()) / points / kEnoughView);
}

std::optional<ScanTracker::Fit> ScanTracker::fit(const ScanView& view, const Pose2& start,
                                                 const Eigen::Matrix3d& prior) const {
  std::vector<PosedView> map;
  for (const Local& local : local_) map.push_back({&local.view, local.track_T_laser});
  const auto found = register_scan(map, view, start, registration_, prior);
  if (!found) return std::nullopt;
  const Pose2& pose = found->target_T_source.pose;
  return Fit{pose, found->information, agreement_at(view, pose)};
}

std::vector<Pose2> ScanTracker::other_starts(const LaserScan& scan, const Pose2& step) {
  constexpr int kTurns = 5;  // to either side
  constexpr double kTurn = 0.08;
  std::vector<Pose2> starts;
  std::vector<Pose2> steps{step};
  for (const Pose2& other : {last_->step, Pose2()}) {
    if (!same_place(other, step)) steps.push_back(other);
  }
  for (const Pose2& way : steps) {
    for (int turn = -kTurns; turn <= kTurns; ++turn) {
      starts.push_back(last_->track_T_laser * way * Pose2(0.0, 0.0, turn * kTurn));
    }
  }
  const Local& newest = local_.back();
  const Pose2 predicted = last_->track_T_laser * step;
  const std::vector<MatchPoint> source = builder_.build(scan).points;
  for (const MatchResult& match : matcher_.match(source, builder_.build(newest.scan).points)) {
    const Pose2 start = newest.track_T_laser * match.target_T_source->pose;
    const Pose2 move = predicted.inverse() * start;
    if (move.translation().norm() > kFarthestStart || std::abs(move.theta()) > kWidestStart) {
      continue;
    }
    starts.push_back(start);
  }
  return starts;
}

// The start that fits best: the farther from the prediction, the better it must fit. What odometry
// says is no firm prior any more.
ScanTracker::Fit ScanTracker::search(const LaserScan& scan, const ScanView& view,
                                     const Prediction& prediction, Fit best) {
  constexpr double kDoubt = 0.01;    // of the prediction's information
  constexpr double kClearly = 0.03;  // better, wherever it is
  constexpr double kPerMeter = 0.4;  // and by this more for each metre and each radian
  constexpr double kPerRadian = 0.4;
  const Eigen::Matrix3d doubtful = kDoubt * prediction.covariance.inverse();
  double most = best.agreement + kClearly;
  for (const Pose2& start : other_starts(scan, prediction.step)) {
    const auto found = fit(view, start, doubtful);
    if (!found) continue;
    const Pose2 move = prediction.pose.inverse() * found->pose;
    const double worth = found->agreement - (kPerMeter * move.translation().norm() +
                                             kPerRadian * std::abs(move.theta())) /
                                                std::max(1.0, prediction.gap);
    if (worth <= most) continue;
    most = worth;
    best = *found;
  }
  return best;
}

bool ScanTracker::far_from_keyframe(const Pose2& pose) const {
  const Pose2 way = local_.back().track_T_laser.inverse() * pose;
  return way.translation().norm() >= params_.min_step || std::abs(way.theta()) >= params_.min_turn;
}

TrackedScan ScanTracker::begin(const LaserScan& scan, Time stamp,
                               const std::optional<Pose2>& odom_T_laser) {
  TrackedScan result;
  result.track_T_laser = odom_T_laser.value_or(Pose2());
  result.keyframe = shows_enough(ScanView(scan, builder_.params().view));
  result.agreement = result.keyframe ? 1.0 : 0.0;
  result.lost = !result.keyframe;
  last_ = Last{result.track_T_laser, Eigen::Matrix3d::Zero(), odom_T_laser, stamp, Pose2()};
  return result;
}

TrackedScan ScanTracker::track(const LaserScan& scan, Time stamp,
                               const std::optional<Pose2>& odom_T_laser) {
  if (local_.empty() || !last_) return begin(scan, stamp, odom_T_laser);
  const Prediction prediction = predict(stamp, odom_T_laser);
  const Eigen::Matrix3d prior = prediction.covariance.inverse();
  const ScanView view(scan, source_view_);
  Fit best{prediction.pose, Eigen::Matrix3d::Zero(), 0.0};
  if (const auto found = fit(view, prediction.pose, prior)) best = *found;

  TrackedScan result;
  result.searched = best.agreement < params_.good_agreement;
  if (result.searched) best = search(scan, view, prediction, best);
  result.agreement = best.agreement;
  result.lost = best.agreement < params_.least_agreement;
  if (result.lost) best = {prediction.pose, Eigen::Matrix3d::Zero(), best.agreement};

  const Pose2& keyframe = local_.back().track_T_laser;
  Eigen::Matrix3d covariance = (best.information + prior).inverse() + shared_noise();
  if (best.agreement < params_.good_agreement) {
    covariance += pose_covariance(kDoubtfulDistance, kDoubtfulTurn);
  }
  result.track_T_laser = best.pose;
  result.keyframe_T_laser.pose = keyframe.inverse() * best.pose;
  result.keyframe_T_laser.covariance = seen_from(covariance, keyframe.theta());
  result.keyframe = far_from_keyframe(best.pose) && shows_enough(view);
  const Pose2 step = last_->track_T_laser.inverse() * best.pose;
  last_ = Last{best.pose, covariance, odom_T_laser, stamp, step};
  return result;
}

void ScanTracker::keep(const LaserScan& scan) {
  local_.push_back({scan, ScanView(scan, builder_.params().view), last_->track_T_laser});
  while (local_.size() > static_cast<std::size_t>(params_.local_keyframes)) local_.pop_front();
  last_->covariance.setZero();
}

}  // namespace falko_slam
