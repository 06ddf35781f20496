// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/pose_history.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "covariance_check.hpp"
#include "falko_slam/common/validation.hpp"

namespace falko_slam {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

}  // namespace

void validate(const PoseHistoryParams& params) {
  require_in_range("span", params.span, 0.0, 60.0);
  require_in_range("max_ahead", params.max_ahead, 0.0, 10.0);
  require_in_range<std::size_t>("max_inputs", params.max_inputs, 1, 1000000);
}

PoseEstimate part_of_motion(const PoseEstimate& motion, double share) {
  if (share >= 1.0) return motion;
  return {Pose2::exp(share * motion.pose.log()), share * motion.covariance};
}

PoseHistory::PoseHistory(LandmarkFilter filter, Time stamp, const PoseHistoryParams& params)
    : params_(params),
      filter_(std::move(filter)),
      origin_stamp_(stamp),
      origin_(filter_),
      motion_stamp_(stamp) {
  validate(params_);
}

void PoseHistory::restart(Time stamp) {
  inputs_.clear();
  if (stamp < motion_stamp_) filter_.reset(filter_.map_T_base());
  origin_ = filter_;
  origin_stamp_ = motion_stamp_ = stamp;
}

void PoseHistory::restart(Time stamp, const PoseEstimate& map_T_base) {
  filter_.reset(map_T_base);
  restart(stamp);
}

bool PoseHistory::is_too_old(Time stamp) const {
  return stamp < origin_stamp_ || motion_stamp_ - stamp > from_seconds(params_.span);
}

// Behind all of its stamp, motions before the observations of theirs.
std::size_t PoseHistory::place_for(Time stamp, bool motion) const {
  std::size_t place = inputs_.size();
  while (place > 0) {
    const Input& before = inputs_[place - 1];
    const bool follows = before.stamp < stamp || (before.stamp == stamp && !motion);
    if (follows) break;
    --place;
  }
  return place;
}

std::size_t PoseHistory::motion_before(std::size_t place) const {
  while (place > 0 && !inputs_[place - 1].motion) --place;
  return place;
}

InputVerdict PoseHistory::add_motion(Time stamp, const PoseEstimate& motion) {
  const bool finite = motion.pose.translation().allFinite() && std::isfinite(motion.pose.theta());
  if (!finite || !is_positive_semidefinite<3>(motion.covariance)) return InputVerdict::kInvalid;
  if (stamp == origin_stamp_) return InputVerdict::kRepeated;
  if (is_too_old(stamp)) return InputVerdict::kTooOld;
  const std::size_t place = place_for(stamp, true);
  if (place < inputs_.size() && inputs_[place].motion && inputs_[place].stamp == stamp) {
    return InputVerdict::kRepeated;
  }
  const bool late = stamp < motion_stamp_;
  inputs_.insert(inputs_.begin() + static_cast<std::ptrdiff_t>(place),
                 Input{stamp, motion, {}, std::nullopt, {}});
  motion_stamp_ = std::max(motion_stamp_, stamp);
  replay(motion_before(place), kNone);
  trim();
  return late ? InputVerdict::kLate : InputVerdict::kInOrder;
}

InputReport PoseHistory::add_observations(Time stamp, FeatureObservations observations) {
  if (is_too_old(stamp)) return {InputVerdict::kTooOld, std::nullopt};
  if (stamp - motion_stamp_ > from_seconds(params_.max_ahead)) {
    return {InputVerdict::kTooNew, std::nullopt};
  }
  if (inputs_.size() >= params_.max_inputs) return {InputVerdict::kTooMany, std::nullopt};
  const std::size_t place = place_for(stamp, false);
  const bool late = place < inputs_.size();
  inputs_.insert(inputs_.begin() + static_cast<std::ptrdiff_t>(place),
                 Input{stamp, std::nullopt, std::move(observations), std::nullopt, {}});
  InputReport report{late ? InputVerdict::kLate : InputVerdict::kInOrder, replay(place, place)};
  return report;
}

// Does all inputs from this one on anew; what the wanted one did, if it holds observations.
std::optional<FeatureUpdate> PoseHistory::replay(std::size_t first, std::size_t wanted) {
  filter_ = first > 0 ? *inputs_[first - 1].after : origin_;
  std::optional<FeatureUpdate> result;
  for (std::size_t place = first; place < inputs_.size(); ++place) {
    Input& input = inputs_[place];
    advance(place);
    if (!input.motion) {
      FeatureUpdate update = filter_.update(input.stamp, input.observations);
      if (place == wanted) result = std::move(update);
    }
    input.after = filter_;
  }
  return result;
}

// Moves the filter to the stamp of this input along the motion that leads over it, if there is one.
void PoseHistory::advance(std::size_t place) {
  const Time from = place > 0 ? inputs_[place - 1].reached : origin_stamp_;
  Input& input = inputs_[place];
  input.reached = from;
  std::size_t next = place;
  while (next < inputs_.size() && !inputs_[next].motion) ++next;
  if (next == inputs_.size() || input.stamp <= from) return;
  input.reached = input.stamp;
  const std::size_t before = motion_before(place);
  const Time start = before > 0 ? inputs_[before - 1].stamp : origin_stamp_;
  const double share = to_seconds(input.stamp - from) / to_seconds(inputs_[next].stamp - start);
  filter_.predict(part_of_motion(*inputs_[next].motion, share));
}

// Cut behind a motion only, so that those that remain are whole.
void PoseHistory::trim() {
  const Time oldest = motion_stamp_ - from_seconds(params_.span);
  const bool full = inputs_.size() > params_.max_inputs;
  std::size_t count = 0;
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    const bool goes = inputs_[i].stamp < oldest || (full && i < inputs_.size() / 2);
    if (goes && inputs_[i].motion) count = i + 1;
  }
  if (count == 0) return;
  origin_ = *inputs_[count - 1].after;
  origin_stamp_ = inputs_[count - 1].stamp;
  inputs_.erase(inputs_.begin(), inputs_.begin() + static_cast<std::ptrdiff_t>(count));
}

}  // namespace falko_slam
