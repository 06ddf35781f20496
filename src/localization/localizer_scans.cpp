// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a localizer does with scans: it follows a pose, or searches for one.
#include "localizer_core.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace falko_slam {
namespace {

constexpr double kLongestSlip = 0.5;  // without any scan that agrees [s]

constexpr double kReachSlack = 0.05, kReachTurnSlack = 0.02;  // of what was measured [m], [rad]

// What an update did with the first `count` points, those of kinds that the map holds, as if there
// were no landmarks in the state.
PoseUpdate map_part_of(const FeatureUpdate& update, std::size_t count) {
  PoseUpdate part;
  part.nis = update.nis;
  part.degrees_of_freedom = update.degrees_of_freedom;
  part.association.proven = update.proven;
  for (std::size_t i = 0; i < count; ++i) {
    const ObservationVerdict verdict = update.points[i];
    const bool of_state =
        !update.of_map[i] &&
        (verdict == ObservationVerdict::kUsed || verdict == ObservationVerdict::kTentative ||
         verdict == ObservationVerdict::kAdded || verdict == ObservationVerdict::kTooNear);
    part.association.verdicts.push_back(of_state ? ObservationVerdict::kNoLandmark : verdict);
    if (!update.of_map[i]) continue;
    LandmarkPair pair;
    pair.observation = i;
    pair.landmark = *update.of_map[i];
    part.association.pairs.push_back(pair);
  }
  return part;
}

std::size_t used_of_state(const FeatureUpdate& update) {
  auto used = std::count(update.lines.begin(), update.lines.end(), ObservationVerdict::kUsed);
  for (std::size_t i = 0; i < update.points.size(); ++i) {
    if (update.points[i] == ObservationVerdict::kUsed && !update.of_map[i]) ++used;
  }
  return static_cast<std::size_t>(used);
}

std::vector<LandmarkObservation> observations_of(const ScanLandmarks& landmarks) {
  std::vector<LandmarkObservation> observations;
  for (const TimedObservation& seen : landmarks.seen) observations.push_back(seen.observation);
  return observations;
}

}  // namespace

void Localizer::Impl::add_scan(const LaserScan& scan) {
  const ScanSight sight(scan);
  const ScanLandmarks landmarks = detector_.detect(scan, track_);
  const auto again = scene_.share_seen_again(scan, landmarks.instant, track_);
  if (again && *again < params_.monitor.min_scene) {
    monitor_.scene_changed(landmarks.instant);
    forget_places();
  }
  add_landmarks(landmarks, &sight);
}

void Localizer::Impl::add_landmarks(const ScanLandmarks& landmarks, const ScanSight* sight) {
  report_.seen_at = landmarks.instant;
  report_.reflectors = landmarks.report;
  report_.seen.clear();
  report_.agreement = {};
  report_.input = InputVerdict::kInOrder;
  if (!track_.empty() && landmarks.instant < track_.end() - from_seconds(params_.history.span)) {
    report_.input = InputVerdict::kTooOld;
    return;
  }
  latest_ = std::max(latest_, landmarks.instant);
  bridge_silence(landmarks.instant);
  const Observations observations = observations_of(landmarks);
  if (history_) {
    track_scan(landmarks, observations, sight);
  } else if (searching_) {
    search_scan(landmarks, sight);
  } else {
    report_seen(observations, nullptr);
  }
  judge();
}

// A scan that the pose does not explain, but one does that the vehicle can have got to: then the
// odometry told too little. The pose may move that far.
bool Localizer::Impl::let_it_slip(const ScanLandmarks& all, const PoseEstimate& prior,
                                  Observations& observations) {
  const ScanLandmarks landmarks = telling(all);
  Observations blurred = observations_of(landmarks);
  const std::size_t fitting =
      associate(prior, params_.base_T_laser, *telling_index_, blurred, params_.association)
          .pairs.size();
  if (fitting >= 3 || (fitting > 0 && 2 * fitting >= blurred.size())) {
    fitted_ = landmarks.instant;
    return false;
  }
  if (blurred.size() < 3) return false;
  const double time = std::clamp(to_seconds(landmarks.instant - fitted_), 0.05, kLongestSlip);
  PoseEstimate wider = prior;
  wider.covariance += pose_covariance(params_.max_speed * time, params_.max_turn_rate * time);
  for (std::size_t i = 0; i < blurred.size(); ++i) {
    const double way = params_.max_speed * to_seconds(landmarks.seen[i].moved);
    if (blurred[i].model != ObservationModel::kCartesian) continue;
    blurred[i].covariance += way * way * Eigen::Matrix2d::Identity();
  }
  const std::vector<LandmarkPair> pairs =
      associate(wider, params_.base_T_laser, *telling_index_, blurred, params_.association).pairs;
  if (pairs.size() < 3 || 10 * pairs.size() < 6 * blurred.size()) return false;
  if (!within_reach(prior.pose, correct(wider, pairs).map_T_base.pose, time)) return false;
  restart_at(landmarks.instant, wider);
  observations = std::move(blurred);
  monitor_.odometry_disagreed(landmarks.instant);
  fitted_ = landmarks.instant;
  return true;
}

// Those that decide where the vehicle is: corners only where the map has nothing else.
ScanLandmarks Localizer::Impl::telling(const ScanLandmarks& landmarks) const {
  ScanLandmarks result = landmarks;
  if (evidence_.corners_tell()) return result;
  const auto is_corner = [](const TimedObservation& seen) {
    return seen.observation.kind != LandmarkKind::kReflector;
  };
  result.seen.erase(std::remove_if(result.seen.begin(), result.seen.end(), is_corner),
                    result.seen.end());
  return result;
}

bool Localizer::Impl::within_reach(const Pose2& from, const Pose2& to, double time) const {
  const Pose2 way = from.inverse() * to;
  return way.translation().norm() <= params_.max_speed * time + kReachSlack &&
         std::abs(way.theta()) <= params_.max_turn_rate * time + kReachTurnSlack;
}

void Localizer::Impl::track_scan(const ScanLandmarks& landmarks, Observations observations,
                                 const ScanSight* sight) {
  PoseEstimate prior = prior_at(landmarks.instant);
  if (let_it_slip(landmarks, prior, observations)) prior = prior_at(landmarks.instant);
  FeatureObservations all{observations, landmarks.unmapped.lines};
  all.points.insert(all.points.end(), landmarks.unmapped.points.begin(),
                    landmarks.unmapped.points.end());
  const InputReport input = history_->add_observations(landmarks.instant, std::move(all));
  report_.input = input.verdict;
  if (!input.update) return report_seen(observations, nullptr);
  const PoseUpdate update = map_part_of(*input.update, observations.size());
  report_seen(observations, &update);
  ScanEvidence scan = evidence_.judge(prior, observations, update, sight);
  scan.agreement.in_state = used_of_state(*input.update);
  report_.agreement = scan.agreement;
  monitor_.add(landmarks.instant, scan);
}

void Localizer::Impl::search_scan(const ScanLandmarks& landmarks, const ScanSight* sight) {
  const Observations observations = observations_of(telling(landmarks));
  report_seen(observations, nullptr);
  if (landmarks.instant < searched_) return;  // late: left out
  if (searched_ >= track_.begin()) {
    const PoseEstimate motion = track_.between(searched_, landmarks.instant);
    hypotheses_.move(motion);
    if (with_corners_) with_corners_->move(motion);
  } else {
    forget_places();  // too long ago to know the way
  }
  searched_ = landmarks.instant;
  hypotheses_.add_scan(observations, sight);
  if (with_corners_) with_corners_->add_scan(observations_of(landmarks), sight);
  const auto found = decided();
  if (!found) return;
  restart_at(landmarks.instant, found->map_T_base);
  monitor_.begin(latest_, 0.0);
  fitted_ = landmarks.instant;
  searching_ = false;
  forget_places();
}

std::optional<PoseHypothesis> Localizer::Impl::decided() const {
  const auto found = hypotheses_.decided();
  return found || !with_corners_ ? found : with_corners_->decided_with_corners();
}

void Localizer::Impl::report_seen(const Observations& observations, const PoseUpdate* update) {
  for (std::size_t i = 0; i < observations.size(); ++i) {
    SeenLandmark seen{point_in_laser(observations[i]),
                      observations[i].covariance,
                      ObservationVerdict::kNoLandmark,
                      {}};
    if (update != nullptr) seen.verdict = update->association.verdicts[i];
    report_.seen.push_back(seen);
  }
  if (update == nullptr) return;
  for (const LandmarkPair& pair : update->association.pairs) {
    report_.seen[pair.observation].id = index_->landmarks()[pair.landmark].id;
  }
}

}  // namespace falko_slam
