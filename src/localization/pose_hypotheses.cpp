// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/pose_hypotheses.hpp"

#include <algorithm>
#include <cmath>

namespace falko_slam {
namespace {

// How far a place from two observations may be off before all of them correct it [m], [rad]. Its
// gates shall find the landmarks, nothing else of it remains.
constexpr double kPlaceDeviation = 0.2, kTurnDeviation = 0.03;

constexpr double kSameLandmark = 0.4;  // [m]

double excess(const PoseUpdate& update) {
  return 0.5 * std::max(0.0, update.nis - update.degrees_of_freedom);
}

}  // namespace

PoseHypotheses::PoseHypotheses(const LocalizerParams& params,
                               std::shared_ptr<const LandmarkIndex> map,
                               const PoseEvidence& evidence)
    : params_(params.recovery),
      filter_params_{params.base_T_laser, params.association},
      map_(std::move(map)),
      evidence_(evidence),
      search_(params.constellation, params.base_T_laser, map_) {
  validate(params_);
  const std::vector<Landmark>& landmarks = map_->landmarks();
  has_reflectors_ = std::any_of(landmarks.begin(), landmarks.end(), [](const Landmark& landmark) {
    return landmark.kind == LandmarkKind::kReflector;
  });
}

void PoseHypotheses::clear() {
  places_.clear();
  sightings_.clear();
}

void PoseHypotheses::move(const PoseEstimate& motion) {
  for (PoseHypothesis& place : places_) place.map_T_base = compose(place.map_T_base, motion);
  const PoseEstimate back = inverse(motion);
  for (Sighting& sighting : sightings_) sighting.in_base = transform(back, sighting.in_base);
}

// A scan shows many corners, and of older ones those that come and go would be left.
bool PoseHypotheses::is_remembered(LandmarkKind kind) const {
  return kind == LandmarkKind::kReflector || !has_reflectors_;
}

// What is seen again is remembered as it was seen last.
void PoseHypotheses::remember(const std::vector<LandmarkObservation>& observations) {
  for (Sighting& sighting : sightings_) ++sighting.age;
  const PoseEstimate base_T_laser{filter_params_.base_T_laser, Eigen::Matrix3d::Zero()};
  std::vector<Sighting> seen;
  for (const LandmarkObservation& observation : observations) {
    if (observation.model != ObservationModel::kCartesian || !is_usable(observation)) continue;
    if (!is_remembered(observation.kind)) continue;
    seen.push_back({transform(base_T_laser, {observation.value, observation.covariance}),
                    observation.kind, 0});
  }
  const auto goes = [&](const Sighting& old) {
    return old.age > params_.memory || std::any_of(seen.begin(), seen.end(), [&](const auto& now) {
             return (now.in_base.point - old.in_base.point).norm() < kSameLandmark;
           });
  };
  sightings_.erase(std::remove_if(sightings_.begin(), sightings_.end(), goes), sightings_.end());
  sightings_.insert(sightings_.end(), seen.begin(), seen.end());
}

void PoseHypotheses::correct(PoseHypothesis& place,
                             const std::vector<LandmarkObservation>& observations,
                             const ScanSight* sight) const {
  PoseFilter filter(filter_params_, map_, place.map_T_base);
  const PoseUpdate update = filter.update(observations);
  const ScanEvidence scan = evidence_.judge(place.map_T_base, observations, update, sight);
  place.map_T_base = filter.map_T_base();
  place.log_odds += scan.log_odds - excess(update);
  place.reflector_log_odds += scan.reflector_log_odds;
  place.used += scan.agreement.used;
  place.strangers += scan.agreement.strangers;
  if (update.corrected() && scan.log_odds > 0.0) ++place.scans;
}

// The first two pairs made the place: they are no evidence for it.
std::optional<PoseHypothesis> PoseHypotheses::hypothesis_of(
    const PlaceCandidate& candidate, const std::vector<LandmarkObservation>& observations,
    const ScanSight* sight) const {
  const PoseEstimate prior{candidate.map_T_base, pose_covariance(kPlaceDeviation, kTurnDeviation)};
  PoseFilter filter(filter_params_, map_, prior);
  const PoseUpdate update = filter.update(observations);
  const std::size_t used = update.association.pairs.size();
  if (used < 3) return std::nullopt;
  const ScanEvidence scan = evidence_.judge(prior, observations, update, sight);
  const double share = static_cast<double>(used - 2) / static_cast<double>(used);
  const double log_odds = scan.log_odds > 0.0 ? share * scan.log_odds : scan.log_odds;
  PoseHypothesis place{filter.map_T_base(), log_odds - excess(update), 1};
  place.reflector_log_odds = std::min(0.0, scan.reflector_log_odds);
  return place;
}

void PoseHypotheses::add_new(const std::vector<LandmarkObservation>& observations,
                             const ScanSight* sight) {
  for (const PlaceCandidate& candidate : search_.search(observations)) {
    const auto known = [&](const Pose2& pose) {
      return std::any_of(places_.begin(), places_.end(), [&](const PoseHypothesis& place) {
        return are_same_place(place.map_T_base.pose, pose);
      });
    };
    if (known(candidate.map_T_base)) continue;
    const auto place = hypothesis_of(candidate, observations, sight);
    if (place && !known(place->map_T_base.pose)) places_.push_back(*place);
  }
}

void PoseHypotheses::add_scan(const std::vector<LandmarkObservation>& observations,
                              const ScanSight* sight) {
  for (PoseHypothesis& place : places_) correct(place, observations, sight);
  remember(observations);
  const PoseEstimate laser_T_base{filter_params_.base_T_laser.inverse(), Eigen::Matrix3d::Zero()};
  std::vector<LandmarkObservation> all = observations;
  for (const Sighting& sighting : sightings_) {
    if (sighting.age == 0) continue;
    const PointEstimate in_laser = transform(laser_T_base, sighting.in_base);
    all.push_back(
        {ObservationModel::kCartesian, in_laser.point, in_laser.covariance, {}, sighting.kind});
  }
  add_new(all, sight);
  sort_and_drop();
}

void PoseHypotheses::sort_and_drop() {
  std::stable_sort(places_.begin(), places_.end(),
                   [](const auto& a, const auto& b) { return a.log_odds > b.log_odds; });
  if (places_.empty()) return;
  std::vector<PoseHypothesis> kept;
  for (const PoseHypothesis& place : places_) {
    const bool drop = place.log_odds < places_.front().log_odds - params_.drop ||
                      place.log_odds < -params_.drop ||
                      kept.size() >= static_cast<std::size_t>(params_.max_hypotheses);
    const bool twin = std::any_of(kept.begin(), kept.end(), [&](const PoseHypothesis& other) {
      return are_same_place(other.map_T_base.pose, place.map_T_base.pose);
    });
    if (!drop && !twin) kept.push_back(place);
  }
  places_ = std::move(kept);
}

std::optional<PoseHypothesis> PoseHypotheses::decided() const {
  if (places_.empty()) return std::nullopt;
  const PoseHypothesis& best = places_.front();
  if (best.scans < params_.scans || best.log_odds < params_.min_evidence) return std::nullopt;
  if (places_.size() > 1 && best.log_odds - places_[1].log_odds < params_.margin) {
    return std::nullopt;
  }
  return best;
}

std::optional<PoseHypothesis> PoseHypotheses::decided_with_corners() const {
  const auto best = decided();
  if (!best || best->reflector_log_odds < 0.0) return std::nullopt;
  const auto used = static_cast<double>(best->used);
  const auto seen = used + static_cast<double>(best->strangers);
  return used < params_.min_share * seen ? std::nullopt : best;
}

}  // namespace falko_slam
