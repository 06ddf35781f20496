// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/scan_motion_estimator.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "falko_slam/calibration/path_segment.hpp"
#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/place_recognition/scan_agreement.hpp"
#include "scan_chain.hpp"

namespace falko_slam {
namespace {

double mean_range(const LaserScan& scan) {
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    if (scan.valid(i)) sum += scan.ranges[i], ++count;
  }
  return count > 0.0 ? sum / count : 0.0;
}

// As if all beams had left with the first one that did.
LaserScan straightened(const LaserScan& scan, const LaserMotion& sweep) {
  if (scan.size() == 0) return scan;
  return deskew(scan, sweep, std::min(scan.first_beam_time, scan.beam_time(scan.size() - 1)));
}

// A motion that is off by a share bends the scan: turned by up to e at its end it looks turned by
// half of that, and displaced by e / pi of its range.
Eigen::Matrix3d bend_of(const LaserScan& scan, const LaserMotion& sweep, double share) {
  const double turn = std::abs(sweep.begin_T_end.theta());
  const double way = sweep.begin_T_end.translation().norm() + turn * mean_range(scan) / kPi;
  return pose_covariance(share * way, share * turn);
}

// Where the steering is off, turn and sideways motion are, by the same factor.
LaserMotion turned_more(const LaserMotion& sweep, double factor) {
  const Eigen::Vector3d way = sweep.begin_T_end.log();
  return {Pose2::exp({way.x(), factor * way.y(), factor * way.z()}), sweep.duration};
}

std::string open_by(double deviation, double turn_deviation) {
  return "the walls leave the motion open: its standard deviations are " +
         std::to_string(deviation) + " m and " + std::to_string(turn_deviation) + " rad";
}

// Why there is no way to the end.
std::string missing(const WallKey& start, const WallKey& end, const ScanMotionParams& params) {
  const auto direct = link(start, end, params);
  if (!direct) return "the straight walls seen at both ends, and on the way, are too few";
  if (direct->agreement() >= params.min_agreement) {
    return open_by(direct->deviation_without_a_part, std::sqrt(direct->covariance(2, 2)));
  }
  return "only " + std::to_string(std::lround(100.0 * direct->agreement())) +
         " % of the walls seen at both ends agree";
}

}  // namespace

void validate(const ScanMotionParams& params) {
  validate(params.walls);
  validate(params.registration);
  require_in_range("range_noise", params.range_noise, 1e-9, 1.0);
  require_in_range("odometry_share", params.odometry_share, 1e-3, 1.0);
  require_in_range("mended_share", params.mended_share, 0.0, 1.0);
  require_in_range("key_step", params.key_step, 0.01, 100.0);
  require_in_range("key_turn", params.key_turn, 0.01, kPi);
  require_in_range<std::size_t>("min_parts", params.min_parts, 3, 1000);
  require_in_range("min_agreement", params.min_agreement, 0.0, 1.0);
  require_in_range("max_deviation", params.max_deviation, 1e-6, 10.0);
  require_in_range("max_turn_deviation", params.max_turn_deviation, 1e-6, 1.0);
}

ScanMotionEstimator::ScanMotionEstimator(const ScanMotionParams& params)
    : params_((validate(params), params)) {
  view_.max_range = params.walls.max_range;
  view_.surface = params.walls.surface;
  tracking_.iterations = 10;
  tracking_.loss_scale = 0.05;
}

void ScanMotionEstimator::add_at_start(const LaserScan& scan) {
  ++scans_;
  at_start_.push_back(scan);
}

void ScanMotionEstimator::begin() {
  if (!keys_.empty()) return;
  start_ = mean_of(at_start_);
  keys_.push_back({start_.scan, {}, ScanView(start_.scan, view_), Pose2()});
}

WallScan ScanMotionEstimator::walls_of(const MeanScan& mean) const {
  const double scans = std::max(1.0, static_cast<double>(mean.scans));
  const double noise = std::max({params_.range_noise, mean.range_noise, start_.range_noise});
  return {mean.scan, noise / std::sqrt(scans), params_.walls};
}

void ScanMotionEstimator::move(const Pose2& step) {
  turn_ += step.theta();
  turn_of_encoders_ += step.theta();
  start_T_laser_ = start_T_laser_ * step;
  untracked_ = untracked_ * step;
}

// The start and the last two scans that were remembered.
std::vector<PosedView> ScanMotionEstimator::local_map() const {
  constexpr std::size_t kLast = 2;
  std::vector<PosedView> map;
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    if (i == 0 || i + kLast >= keys_.size())
      map.push_back({&keys_[i].view, keys_[i].start_T_laser});
  }
  return map;
}

// From where the encoders say.
bool ScanMotionEstimator::track(const ScanView& view) {
  constexpr double kLeastDistance = 0.02, kLeastTurn = 0.01;  // of doubt [m], [rad]
  constexpr double kLeastAgreement = 0.5;
  const std::vector<PosedView> map = local_map();
  const double share = 2.0 * params_.odometry_share;
  const Eigen::Matrix3d doubt =
      pose_covariance(kLeastDistance + share * untracked_.translation().norm(),
                      kLeastTurn + share * std::abs(untracked_.theta()));
  const auto found = register_scan(map, view, start_T_laser_, tracking_, doubt.inverse());
  if (!found) return false;
  const Pose2& pose = found->target_T_source.pose;
  double best = 0.0;
  for (const PosedView& seen : map) {
    best = std::max(best, agreement(*seen.view, view, seen.target_T_view.inverse() * pose).ratio());
  }
  if (best < kLeastAgreement) return false;
  turn_ += angle_between(start_T_laser_.theta(), pose.theta());
  start_T_laser_ = pose;
  untracked_ = Pose2();
  return true;
}

void ScanMotionEstimator::add_on_the_way(const LaserScan& scan, const Pose2& step,
                                         const LaserMotion& sweep) {
  constexpr double kWorthTracking = 0.25;  // [m], [rad]
  begin();
  ++scans_;
  move(step);
  if (untracked_.translation().norm() + std::abs(untracked_.theta()) < kWorthTracking) return;
  ScanView view(straightened(scan, sweep), view_);
  if (!track(view)) {
    ++lost_scans_;
    return;
  }
  const Pose2 since = keys_.back().start_T_laser.inverse() * start_T_laser_;
  const bool far =
      since.translation().norm() >= params_.key_step || std::abs(since.theta()) >= params_.key_turn;
  if (far) keys_.push_back({scan, sweep, std::move(view), start_T_laser_});
}

void ScanMotionEstimator::add_at_end(const LaserScan& scan, const Pose2& step) {
  begin();
  ++scans_;
  if (at_end_.empty()) move(step);
  at_end_.push_back(scan);
}

// By how much more the laser turned on the way than the encoders say.
double ScanMotionEstimator::mended_turn() const {
  const bool tells = std::abs(turn_of_encoders_) > 0.3;  // else the tracks' noise is as great
  return tells ? turn_ / turn_of_encoders_ : 1.0;
}

std::optional<ScanMotion> ScanMotionEstimator::refuse(const std::string& complaint) {
  complaint_ = complaint;
  return std::nullopt;
}

std::optional<ScanMotion> ScanMotionEstimator::result() {
  begin();
  const MeanScan mean = mean_of(at_end_);
  track(ScanView(mean.scan, view_));
  std::vector<WallKey> walls{{walls_of(start_), Pose2(), Eigen::Matrix3d::Zero()}};
  for (std::size_t i = 1; i < keys_.size(); ++i) {
    const Key& key = keys_[i];
    const LaserMotion sweep = turned_more(key.sweep, mended_turn());
    walls.push_back({walls_of({straightened(key.scan, sweep), 0.0, 1}), key.start_T_laser,
                     bend_of(key.scan, sweep, params_.mended_share)});
  }
  walls.push_back({walls_of(mean), start_T_laser_, Eigen::Matrix3d::Zero()});
  const auto best = best_chain(walls, params_);
  if (!best) return refuse(missing(walls.front(), walls.back(), params_));
  const double deviation = greatest_deviation(best->start_T_laser.covariance);
  const double turn_deviation = std::sqrt(best->start_T_laser.covariance(2, 2));
  if (deviation > params_.max_deviation || turn_deviation > params_.max_turn_deviation) {
    return refuse(open_by(deviation, turn_deviation));
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
