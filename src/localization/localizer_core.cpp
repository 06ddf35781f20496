// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "localizer_core.hpp"

#include <algorithm>
#include <utility>

namespace falko_slam {
namespace {

// The reflectors, or all where there are none.
LandmarkMap telling_part_of(const LandmarkMap& map) {
  LandmarkMap result;
  for (const MapLandmark& landmark : map.landmarks) {
    if (landmark.kind == LandmarkKind::kReflector) result.landmarks.push_back(landmark);
  }
  return result.landmarks.empty() ? map : result;
}

const LocalizerParams& validated(const LocalizerParams& params) {
  validate(params);
  return params;
}

}  // namespace

Localizer::Impl::Impl(const LocalizerParams& params, const LandmarkMap& map)
    : params_(validated(params)),
      index_(landmark_index(map)),
      telling_map_(telling_part_of(map)),
      telling_index_(landmark_index(telling_map_)),
      filter_params_{params_.base_T_laser, params_.association},
      detector_(params_, map),
      evidence_(params_.monitor.evidence, filter_params_, map, index_,
                params_.association.gate_probability),
      telling_evidence_(params_.monitor.evidence, filter_params_, telling_map_, telling_index_,
                        params_.association.gate_probability),
      corner_evidence_(params_.monitor.evidence, filter_params_, map, index_,
                       params_.association.gate_probability, TellingKinds::kAll),
      monitor_(params_.monitor),
      hypotheses_(params_, telling_index_, telling_evidence_),
      track_(from_seconds(2.0 * params_.history.span + 1.0)),
      scene_(params_.base_T_laser) {
  if (params_.recovery.corners && telling_map_.landmarks.size() < map.landmarks.size()) {
    LocalizerParams of_both = params_;
    of_both.constellation.max_candidates = params_.recovery.corner_candidates;
    with_corners_.emplace(of_both, index_, corner_evidence_);
  }
  forget_pose(params_.search_alone);
}

void Localizer::Impl::set_pose(Time stamp, const std::optional<PoseEstimate>& map_T_base) {
  if (!map_T_base) return forget_pose(params_.search_alone);
  const LandmarkFilter check(landmark_params(), *map_T_base, index_);  // throws for what is none
  latest_ = std::max(latest_, stamp);
  searching_ = false;
  forget_places();
  restart_at(stamp, *map_T_base);
  monitor_.begin(latest_, 0.0);
  fitted_ = latest_;
  judge();
}

void Localizer::Impl::forget_pose(bool search) {
  history_.reset();
  forget_places();
  searching_ = search;
  judge();
}

// The pose of a stamp and the motions since then. Those of a stamp after the last motion are taken
// back to it.
void Localizer::Impl::restart_at(Time stamp, const PoseEstimate& map_T_base) {
  PoseEstimate pose = map_T_base;
  if (track_.empty()) track_.add(stamp, {});
  if (stamp > track_.end()) {
    pose.pose = pose.pose * (track_.at(track_.end()).inverse() * track_.at(stamp)).inverse();
    stamp = track_.end();
  }
  history_.emplace(LandmarkFilter(landmark_params(), pose, index_), std::max(stamp, track_.begin()),
                   params_.history);
  for (const auto& [time, motion] : track_.since(stamp)) history_->add_motion(time, motion);
}

PoseEstimate Localizer::Impl::prior_at(Time instant) const {
  PoseEstimate prior = history_->map_T_base();
  prior.pose = prior.pose * (track_.at(history_->stamp()).inverse() * track_.at(instant));
  return prior;
}

LandmarkFilterParams Localizer::Impl::landmark_params() const {
  LandmarkFilterParams params = params_.landmarks;
  params.base_T_laser = params_.base_T_laser;
  const int max_nodes = params.association.max_nodes;
  params.association = params_.association;
  params.association.max_nodes = std::min(max_nodes, params_.association.max_nodes);
  return params;
}

void Localizer::Impl::forget_places() {
  hypotheses_.clear();
  if (with_corners_) with_corners_->clear();
}

void Localizer::Impl::check(Time now) {
  if (!track_.empty()) {
    latest_ = std::max(latest_, now);
    bridge_silence(now);
  }
  judge();
}

std::vector<ActiveLandmark> Localizer::Impl::landmarks() const {
  if (!history_) return {};
  return history_->filter().landmarks();
}

void Localizer::Impl::judge() {
  report_.hypotheses = hypotheses_.places().size();
  if (with_corners_) report_.hypotheses += with_corners_->places().size();
  report_.map_T_base.reset();
  report_.evidence = 0.0;
  report_.stamp = latest_;
  if (history_) {
    const auto [status, reason] = monitor_.judge(latest_, history_->map_T_base());
    report_.status = status;
    report_.reason = reason;
    report_.evidence = monitor_.evidence();
    if (status == LocalizationStatus::kLost) {
      history_.reset();
      forget_places();
      searching_ = params_.search_alone;
      return;
    }
    report_.stamp = history_->stamp();
    report_.map_T_base = history_->map_T_base();
    report_.map_T_base->covariance +=
        pose_covariance(params_.mount_position, params_.mount_heading);
    return;
  }
  if (!searching_) {
    report_.status = LocalizationStatus::kLost;
    report_.reason = LocalizationReason::kNoPose;
    return;
  }
  report_.status = LocalizationStatus::kRecovering;
  const auto& places = hypotheses_.places();
  report_.reason =
      places.empty() ? LocalizationReason::kSearching : LocalizationReason::kConfirming;
  const bool rivals =
      places.size() > 1 && places[0].log_odds - places[1].log_odds < params_.recovery.margin;
  if (rivals) report_.reason = LocalizationReason::kAmbiguous;
}

}  // namespace falko_slam
