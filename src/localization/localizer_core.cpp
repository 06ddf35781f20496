// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "localizer_core.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "covariance_check.hpp"

namespace falko_slam {
namespace {

constexpr int kSetBack = 3;  // motions in a row from before the track: the clock, not one of them
constexpr double kLongestSlip = 0.5;  // without any scan that agrees [s]

constexpr double kReachSlack = 0.05, kReachTurnSlack = 0.02;  // of what was measured [m], [rad]

// The reflectors, or all where there are none.
LandmarkMap telling_part_of(const LandmarkMap& map) {
  LandmarkMap result;
  for (const MapLandmark& landmark : map.landmarks) {
    if (landmark.kind == LandmarkKind::kReflector) result.landmarks.push_back(landmark);
  }
  return result.landmarks.empty() ? map : result;
}

bool is_usable(const PoseEstimate& motion) {
  return motion.pose.translation().allFinite() && std::isfinite(motion.pose.theta()) &&
         is_positive_semidefinite<3>(motion.covariance);
}

const LocalizerParams& validated(const LocalizerParams& params) {
  validate(params);
  return params;
}

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

LandmarkFilterParams Localizer::Impl::landmark_params() const {
  LandmarkFilterParams params = params_.landmarks;
  params.base_T_laser = params_.base_T_laser;
  const int max_nodes = params.association.max_nodes;
  params.association = params_.association;
  params.association.max_nodes = std::min(max_nodes, params_.association.max_nodes);
  return params;
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

void Localizer::Impl::forget_places() {
  hypotheses_.clear();
  if (with_corners_) with_corners_->clear();
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
