// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/scan_motion_estimator.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "falko_slam/calibration/path_segment.hpp"
#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

// A pose that is known from tracking, or not at all: beside walls this says nothing [m], [rad].
constexpr double kUnknownDistance = 1.0;
constexpr double kUnknownTurn = 0.3;

double greatest_deviation(const Eigen::Matrix3d& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(
      Eigen::Matrix2d(covariance.topLeftCorner<2, 2>()));
  return std::sqrt(std::max(0.0, axes.eigenvalues().maxCoeff()));
}

// One number for a covariance: a turn counts as what it moves at this distance.
double badness(const Eigen::Matrix3d& covariance) {
  constexpr double kLever = 5.0;  // [m]
  return covariance(0, 0) + covariance(1, 1) + kLever * kLever * covariance(2, 2);
}

double mean_range(const LaserScan& scan) {
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    if (scan.valid(i)) sum += scan.ranges[i], ++count;
  }
  return count > 0.0 ? sum / count : 0.0;
}

// What an error of the target's frame does to a pose in it.
Eigen::Matrix3d moved_to(const Pose2& target_T_source, const Eigen::Matrix3d& target_covariance) {
  Eigen::Matrix3d jacobian = Eigen::Matrix3d::Identity();
  jacobian(0, 2) = -target_T_source.y();
  jacobian(1, 2) = target_T_source.x();
  return jacobian * target_covariance * jacobian.transpose();
}

Time earliest_beam(const LaserScan& scan) {
  if (scan.size() == 0) return scan.first_beam_time;
  return std::min(scan.first_beam_time, scan.beam_time(scan.size() - 1));
}

ScanViewParams view_params(const ScanMotionParams& params) {
  ScanViewParams view;
  view.max_range = params.walls.max_range;
  view.surface = params.walls.surface;
  return view;
}

}  // namespace

void validate(const ScanMotionParams& params) {
  validate(params.walls);
  validate(params.registration);
  require_in_range("range_noise", params.range_noise, 1e-9, 1.0);
  require_in_range("odometry_share", params.odometry_share, 1e-3, 1.0);
  require_in_range("key_step", params.key_step, 0.01, 100.0);
  require_in_range("key_turn", params.key_turn, 0.01, kPi);
  require_in_range<std::size_t>("min_parts", params.min_parts, 3, 1000);
  require_in_range("min_agreement", params.min_agreement, 0.0, 1.0);
  require_in_range("max_deviation", params.max_deviation, 1e-6, 10.0);
  require_in_range("max_turn_deviation", params.max_turn_deviation, 1e-6, 1.0);
}

ScanMotionEstimator::ScanMotionEstimator(const ScanMotionParams& params)
    : params_((validate(params), params)) {
  tracking_.iterations = 10;
  tracking_.loss_scale = 0.05;
}

void ScanMotionEstimator::add_at_start(const LaserScan& scan) {
  ++scans_;
  at_start_.push_back(scan);
}

ScanMotionEstimator::Key ScanMotionEstimator::key_of(const LaserScan& scan, double noise,
                                                     const Pose2& start_T_laser) const {
  return {ScanView(scan, view_params(params_)), WallScan(scan, noise, params_.walls), start_T_laser,
          Eigen::Matrix3d::Zero()};
}

void ScanMotionEstimator::begin() {
  if (!keys_.empty()) return;
  const MeanScan mean = mean_of(at_start_);
  noise_ = std::max(params_.range_noise, mean.range_noise);
  const double scans = std::max(1.0, static_cast<double>(mean.scans));
  keys_.push_back(key_of(mean.scan, noise_ / std::sqrt(scans), Pose2()));
}

void ScanMotionEstimator::move(const Pose2& step) {
  turn_ += step.theta();
  start_T_laser_ = start_T_laser_ * step;
  untracked_ = untracked_ * step;
}

// From where the encoders say, on the start and the last two scans that were remembered.
bool ScanMotionEstimator::track(const ScanView& view) {
  constexpr double kLeastDistance = 0.02, kLeastTurn = 0.01;  // of doubt [m], [rad]
  constexpr double kLeastAgreement = 0.5;
  std::vector<PosedView> targets{{&keys_.front().view, keys_.front().start_T_laser}};
  for (std::size_t i = std::max<std::size_t>(1, keys_.size() < 2 ? 1 : keys_.size() - 2);
       i < keys_.size(); ++i) {
    targets.push_back({&keys_[i].view, keys_[i].start_T_laser});
  }
  const double share = 2.0 * params_.odometry_share;
  const Eigen::Matrix3d doubt =
      pose_covariance(kLeastDistance + share * untracked_.translation().norm(),
                      kLeastTurn + share * std::abs(untracked_.theta()));
  const auto found = register_scan(targets, view, start_T_laser_, tracking_, doubt.inverse());
  if (!found) return false;
  const Pose2& pose = found->target_T_source.pose;
  double agreeing = 0.0;
  for (const PosedView& target : targets) {
    const Agreement alike = agreement(*target.view, view, target.target_T_view.inverse() * pose);
    if (alike.seen() > 0) agreeing = std::max(agreeing, alike.ratio());
  }
  if (agreeing < kLeastAgreement) return false;
  turn_ += angle_between(start_T_laser_.theta(), pose.theta());
  start_T_laser_ = pose;
  untracked_ = Pose2();
  return true;
}

// An encoder's motion that is off by a share bends the scan: turned by up to e at its end it looks
// turned by half of that, and displaced by e / pi of its range.
Eigen::Matrix3d ScanMotionEstimator::bend_of(const LaserScan& scan,
                                             const LaserMotion& sweep) const {
  const double turn = std::abs(sweep.begin_T_end.theta());
  const double way = sweep.begin_T_end.translation().norm() + turn * mean_range(scan) / kPi;
  return pose_covariance(params_.odometry_share * way, params_.odometry_share * turn);
}

void ScanMotionEstimator::add_on_the_way(const LaserScan& scan, const Pose2& step,
                                         const LaserMotion& sweep) {
  constexpr double kWorthTracking = 0.25;  // [m], [rad]
  begin();
  ++scans_;
  move(step);
  if (untracked_.translation().norm() + std::abs(untracked_.theta()) < kWorthTracking) return;
  const LaserScan straight = deskew(scan, sweep, earliest_beam(scan));
  const ScanView view(straight, view_params(params_));
  if (!track(view)) {
    ++lost_scans_;
    return;
  }
  const Pose2 since = keys_.back().start_T_laser.inverse() * start_T_laser_;
  if (since.translation().norm() < params_.key_step && std::abs(since.theta()) < params_.key_turn) {
    return;
  }
  keys_.push_back(key_of(straight, noise_, start_T_laser_));
  keys_.back().bent = bend_of(scan, sweep);
}

void ScanMotionEstimator::add_at_end(const LaserScan& scan, const Pose2& step) {
  begin();
  ++scans_;
  if (at_end_.empty()) move(step);
  at_end_.push_back(scan);
}

std::optional<WallRegistration> ScanMotionEstimator::link(const Key& from, const Key& to) const {
  const Eigen::Matrix3d unknown = pose_covariance(kUnknownDistance, kUnknownTurn).inverse();
  auto found = register_walls(from.walls, to.walls, from.start_T_laser.inverse() * to.start_T_laser,
                              unknown, params_.registration);
  if (!found || found->parts < params_.min_parts) return std::nullopt;
  return found;
}

// From the start to each scan that was remembered, at last to the end: over links that are
// determined on their own, the way of least variance.
std::vector<std::optional<ScanMotionEstimator::Reached>> ScanMotionEstimator::reach(
    const Key& end) const {
  std::vector<std::optional<Reached>> reached(keys_.size() + 1);
  reached.front() = Reached();
  for (std::size_t to = 1; to <= keys_.size(); ++to) {
    const Key& key = to < keys_.size() ? keys_[to] : end;
    for (std::size_t from = 0; from < to; ++from) {
      if (!reached[from]) continue;
      const auto found = link(keys_[from], key);
      if (!found || found->agreement() < params_.min_agreement) continue;
      if (greatest_deviation(found->covariance) > params_.max_deviation) continue;
      const Eigen::Matrix3d covariance =
          found->covariance + key.bent + moved_to(found->target_T_source, keys_[from].bent);
      const ComposeJacobians jacobians =
          compose_jacobians(reached[from]->start_T_laser.pose, found->target_T_source);
      Reached next{
          compose(reached[from]->start_T_laser, {found->target_T_source, covariance}),
          jacobians.dresult_dleft * reached[from]->lasting * jacobians.dresult_dleft.transpose() +
              jacobians.dresult_dright * found->lasting_covariance *
                  jacobians.dresult_dright.transpose(),
          *found, reached[from]->links + 1};
      if (reached[to] && badness(reached[to]->start_T_laser.covariance) <=
                             badness(next.start_T_laser.covariance)) {
        continue;
      }
      reached[to] = next;
    }
  }
  return reached;
}

// What start and end see alike, however little, beside what the way in between says.
std::optional<ScanMotionEstimator::Reached> ScanMotionEstimator::with_start(const Reached& end,
                                                                            const Key& key) const {
  const auto found = register_walls(keys_.front().walls, key.walls, end.start_T_laser.pose,
                                    end.start_T_laser.covariance.inverse(), params_.registration);
  if (!found || found->agreement() < params_.min_agreement) return std::nullopt;
  Reached both = end;
  both.start_T_laser = {found->target_T_source, found->covariance};
  return both;
}

std::optional<ScanMotion> ScanMotionEstimator::refuse(const std::string& complaint) {
  complaint_ = complaint;
  return std::nullopt;
}

std::optional<ScanMotion> ScanMotionEstimator::result() {
  begin();
  const MeanScan mean = mean_of(at_end_);
  const double scans = std::max(1.0, static_cast<double>(mean.scans));
  const double noise = std::max(params_.range_noise, mean.range_noise);
  Key end = key_of(mean.scan, noise / std::sqrt(scans), Pose2());
  track(end.view);
  end.start_T_laser = start_T_laser_;

  auto best = reach(end).back();
  if (!best) {
    const auto direct = link(keys_.front(), end);
    if (!direct) return refuse("the straight walls seen at both ends, and on the way, are too few");
    const double agreement = direct->agreement();
    if (agreement < params_.min_agreement) {
      return refuse("only " + std::to_string(std::lround(100.0 * agreement)) +
                    " % of the walls seen at both ends agree");
    }
    return refuse("the walls leave the motion open: its standard deviation is " +
                  std::to_string(greatest_deviation(direct->covariance)) + " m in one direction");
  }
  if (best->links > 1) best = with_start(*best, end).value_or(*best);
  const Eigen::Matrix3d& covariance = best->start_T_laser.covariance;
  if (greatest_deviation(covariance) > params_.max_deviation ||
      std::sqrt(covariance(2, 2)) > params_.max_turn_deviation) {
    return refuse("the walls leave the motion open: its standard deviations are " +
                  std::to_string(greatest_deviation(covariance)) + " m and " +
                  std::to_string(std::sqrt(covariance(2, 2))) + " rad");
  }
  ScanMotion motion;
  motion.start_T_end = best->start_T_laser;
  motion.turn = unwrapped_turn(motion.start_T_end.pose.theta(), turn_);
  motion.lasting_covariance = best->lasting;
  motion.rms_residual = best->last.rms_residual;
  motion.parts = best->last.parts;
  motion.links = best->links;
  motion.scans = scans_;
  return motion;
}

}  // namespace falko_slam
