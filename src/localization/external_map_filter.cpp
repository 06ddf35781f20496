// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/external_map_filter.hpp"

#include <algorithm>
#include <cstdint>

#include "falko_slam/common/validation.hpp"

namespace falko_slam {

void validate(const ExternalMapParams& params) {
  validate(params.filter);
  require_in_range("update_rate", params.update_rate, 0.0, 1.0);
  require_in_range("max_landmarks", params.max_landmarks, 1, 10000);
}

ExternalMapFilter::ExternalMapFilter(const ExternalMapParams& params,
                                     const std::shared_ptr<const LandmarkIndex>& map,
                                     const PoseEstimate& map_T_base)
    : params_(params), map_T_base_(map_T_base) {
  validate(params_);
  if (map) fixed_ = map->landmarks();
  PoseFilter(params_.filter, both_maps(), map_T_base_);  // throws for what is no pose
}

// The fixed landmarks first, by numbers of their own: those of the map play no part here.
std::shared_ptr<const LandmarkIndex> ExternalMapFilter::both_maps() const {
  std::vector<Landmark> all = fixed_;
  for (const ExternalLandmark& landmark : landmarks_) {
    all.push_back({0, landmark.position, Eigen::Matrix2d::Zero(), LandmarkKind::kFeature});
  }
  for (std::size_t i = 0; i < all.size(); ++i) all[i].id = static_cast<std::uint32_t>(i);
  return std::make_shared<LandmarkIndex>(std::move(all));
}

bool ExternalMapFilter::predict(const PoseEstimate& motion) {
  PoseFilter filter(params_.filter, std::make_shared<LandmarkIndex>(fixed_), map_T_base_);
  if (!filter.predict(motion)) return false;
  map_T_base_ = filter.map_T_base();
  return true;
}

PoseUpdate ExternalMapFilter::update(const std::vector<LandmarkObservation>& observations) {
  std::vector<LandmarkObservation> nameless = observations;
  for (LandmarkObservation& observation : nameless) observation.id.reset();
  PoseFilter filter(params_.filter, both_maps(), map_T_base_);
  PoseUpdate update = filter.update(nameless);
  map_T_base_ = filter.map_T_base();
  update_map(observations, update);
  return update;
}

// Algorithm 1, line by line; what is associated but refused as ambiguous is not inserted either.
void ExternalMapFilter::update_map(const std::vector<LandmarkObservation>& observations,
                                   const PoseUpdate& update) {
  const Pose2 map_T_laser = map_T_base_.pose * params_.filter.base_T_laser;
  std::vector<bool> updated(landmarks_.size(), false);
  for (const LandmarkPair& pair : update.association.pairs) {
    if (pair.landmark < fixed_.size()) continue;
    ExternalLandmark& landmark = landmarks_[pair.landmark - fixed_.size()];
    const Eigen::Vector2d seen = map_T_laser * point_in_laser(observations[pair.observation]);
    landmark.position += params_.update_rate * (seen - landmark.position);
    ++landmark.hits;
    updated[pair.landmark - fixed_.size()] = true;
  }
  std::vector<ExternalLandmark> kept;
  for (std::size_t i = 0; i < landmarks_.size(); ++i) {
    ExternalLandmark landmark = landmarks_[i];
    if (landmark.hits == 0) continue;
    if (!updated[i]) --landmark.hits;
    kept.push_back(landmark);
  }
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const bool is_new = observations[i].kind == LandmarkKind::kFeature &&
                        update.association.verdicts[i] == ObservationVerdict::kNoLandmark;
    if (!is_new || kept.size() >= static_cast<std::size_t>(params_.max_landmarks)) continue;
    kept.push_back({map_T_laser * point_in_laser(observations[i]), 1});
  }
  landmarks_ = std::move(kept);
}

}  // namespace falko_slam
