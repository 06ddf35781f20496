// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a localizer does with motions, and where they do not come or a clock is set back.
#include "localizer_core.hpp"

#include <algorithm>
#include <cmath>

#include "covariance_check.hpp"

namespace falko_slam {
namespace {

constexpr int kSetBack = 3;  // motions in a row from before the track: the clock, not one of them

}  // namespace

InputVerdict Localizer::Impl::add_motion(Time stamp, const PoseEstimate& motion) {
  if (!is_usable(motion)) return InputVerdict::kInvalid;
  if (clock_went_back(stamp)) {
    restart_clock(stamp);
    return InputVerdict::kInOrder;
  }
  if (set_back_ > 0) return InputVerdict::kTooOld;
  if (bridged_from_ && stamp <= track_.end()) {  // of a time that was bridged already
    bridged_from_ = std::max(*bridged_from_, stamp);
    return InputVerdict::kTooOld;
  }
  const PoseEstimate rest = without_bridged(stamp, motion);
  track_.add(stamp, rest);
  latest_ = std::max(latest_, stamp);
  monitor_.motion_seen(stamp);
  const InputVerdict verdict =
      history_ ? history_->add_motion(stamp, rest) : InputVerdict::kInOrder;
  judge();
  return verdict;
}

// One late motion is late; several that follow each other are a clock that was set back.
bool Localizer::Impl::clock_went_back(Time stamp) {
  const bool old = !track_.empty() && stamp < track_.end() - from_seconds(params_.history.span);
  const bool follows = set_back_ == 0 || stamp > set_back_stamp_;
  set_back_ = old ? (follows ? set_back_ + 1 : 1) : 0;
  set_back_stamp_ = stamp;
  return set_back_ >= kSetBack;
}

// The way since the last motion of the old clock is not known: as long as a few motions take.
void Localizer::Impl::restart_clock(Time stamp) {
  set_back_ = 0;
  bridged_from_.reset();
  track_.clear();
  track_.add(stamp, {});
  latest_ = searched_ = fitted_ = stamp;
  forget_places();
  scene_.clear();
  if (history_) {
    PoseEstimate pose = history_->map_T_base();
    pose.covariance += pose_covariance(params_.max_speed * 0.1, params_.max_turn_rate * 0.1);
    history_->restart(stamp, pose);
    monitor_.clock_set_back(stamp);
  }
  judge();
}

// Without motions the vehicle may be anywhere within reach: it stands, with that covariance.
void Localizer::Impl::bridge_silence(Time until) {
  if (track_.empty()) track_.add(until, {});
  const double silence = to_seconds(until - track_.end());
  if (silence <= (bridged_from_ ? 0.0 : params_.monitor.motion_silence)) return;
  if (!bridged_from_) bridged_from_ = track_.end();
  const PoseEstimate guess{
      {}, pose_covariance(params_.max_speed * silence, params_.max_turn_rate * silence)};
  track_.add(until, guess);
  if (history_) history_->add_motion(until, guess);
}

PoseEstimate Localizer::Impl::without_bridged(Time stamp, const PoseEstimate& motion) {
  if (!bridged_from_) return motion;
  const double share = to_seconds(stamp - track_.end()) / to_seconds(stamp - *bridged_from_);
  bridged_from_.reset();
  return part_of_motion(motion, share);
}

}  // namespace falko_slam
