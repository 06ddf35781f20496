// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/pose_evidence.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "falko_slam/geometry/angles.hpp"
#include "joint_search.hpp"

namespace falko_slam {
namespace {

constexpr double kLeastChance = 0.02, kGreatestChance = 0.9;
constexpr double kHalfWidth = 0.15;  // of what must not stand in front of a landmark [m]

double density_of(const std::vector<Landmark>& landmarks) {
  if (landmarks.empty()) return 0.0;
  Eigen::Vector2d low = landmarks.front().position, high = low;
  for (const Landmark& landmark : landmarks) {
    low = low.cwiseMin(landmark.position);
    high = high.cwiseMax(landmark.position);
  }
  const Eigen::Vector2d size = (high - low).cwiseMax(1.0);
  return static_cast<double>(landmarks.size()) / (size.x() * size.y());
}

}  // namespace

PoseEvidence::PoseEvidence(const PoseEvidenceParams& params, const PoseFilterParams& filter,
                           const LandmarkMap& map, std::shared_ptr<const LandmarkIndex> index,
                           double gate_probability, TellingKinds kinds)
    : params_(params),
      base_T_laser_(filter.base_T_laser),
      index_(std::move(index)),
      least_corner_chance_(kLeastChance),
      gate_(pair_gate(gate_probability)),
      density_(density_of(index_->landmarks())) {
  validate(params_);
  for (const Landmark& landmark : index_->landmarks()) {
    const MapLandmark* origin = map.find(static_cast<int>(landmark.id));
    expected_kind_.push_back(origin == nullptr || origin->kind == LandmarkKind::kReflector);
    if (expected_kind_.back()) corners_tell_ = false;
  }
  if (kinds == TellingKinds::kAll) {
    corners_tell_ = true;
    least_corner_chance_ = std::max(kLeastChance, params_.corner_chance);
  }
}

// The gate is the ellipse of squared Mahalanobis distance gate_, of area pi gate_ sqrt(det S).
double PoseEvidence::chance_of(const PoseEstimate& prior,
                               const LandmarkObservation& observation) const {
  const Eigen::Vector2d in_laser = point_in_laser(observation);
  const ObservationPrediction seen = predict_observation(
      observation.model, prior.pose, base_T_laser_, prior.pose * (base_T_laser_ * in_laser));
  const auto& H = seen.dvalue_dpose;
  const double deviation = index_->largest_deviation();
  const Eigen::Matrix2d S =
      H * prior.covariance * H.transpose() + observation.covariance +
      deviation * deviation * seen.dvalue_dlandmark * seen.dvalue_dlandmark.transpose();
  double area = kPi * gate_ * std::sqrt(std::max(0.0, S.determinant()));
  if (observation.model == ObservationModel::kRangeBearing) area *= in_laser.norm();
  const bool corner = observation.kind != LandmarkKind::kReflector;
  return std::clamp(density_ * area, corner ? least_corner_chance_ : kLeastChance, kGreatestChance);
}

void PoseEvidence::count_expected(const PoseEstimate& pose, const PoseUpdate& update,
                                  const ScanSight& sight, MapAgreement& agreement) const {
  const Pose2 map_T_laser = pose.pose * base_T_laser_;
  const Pose2 laser_T_map = map_T_laser.inverse();
  const double place = std::sqrt(std::max(pose.covariance(0, 0), pose.covariance(1, 1)));
  const double turn = std::sqrt(pose.covariance(2, 2));
  std::vector<std::size_t> near;
  index_->find_near(map_T_laser.translation(), params_.expected_range, near);
  for (const std::size_t number : near) {
    if (!expected_kind_[number]) continue;
    const bool used =
        std::any_of(update.association.pairs.begin(), update.association.pairs.end(),
                    [number](const LandmarkPair& pair) { return pair.landmark == number; });
    const Eigen::Vector2d in_laser = laser_T_map * index_->landmarks()[number].position;
    const double half_width = kHalfWidth + 2.0 * (place + turn * in_laser.norm());
    if (!used && !sight.reaches(in_laser, half_width, params_.sight_margin)) continue;
    ++agreement.expected;
    if (!used) ++agreement.missed;
  }
}

ScanEvidence PoseEvidence::judge(const PoseEstimate& prior,
                                 const std::vector<LandmarkObservation>& observations,
                                 const PoseUpdate& update, const ScanSight* sight) const {
  ScanEvidence result;
  MapAgreement& agreement = result.agreement;
  agreement.nis = update.nis;
  agreement.degrees_of_freedom = update.degrees_of_freedom;
  const std::vector<ObservationVerdict>& verdicts = update.association.verdicts;
  const auto tells = [&](std::size_t i) {
    return corners_tell_ || observations[i].kind == LandmarkKind::kReflector;
  };
  double mean_chance = kLeastChance;
  const auto count = [&](double log_odds, bool of_reflectors) {
    result.log_odds += log_odds;
    if (of_reflectors) result.reflector_log_odds += log_odds;
  };
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    const double chance = chance_of(prior, observations[i]);
    const bool reflector = observations[i].kind == LandmarkKind::kReflector;
    mean_chance = std::max(mean_chance, chance);
    if (verdicts[i] == ObservationVerdict::kUsed) {
      ++agreement.used;
      if (tells(i)) count(std::log(params_.mapped / chance), reflector);
    } else if (fits_nothing(verdicts[i]) && tells(i)) {
      ++agreement.strangers;
      count(std::min(0.0, std::log((1.0 - params_.mapped) / (1.0 - chance))), reflector);
    }
  }
  if (sight != nullptr) count_expected(prior, update, *sight, agreement);
  const std::size_t counted = std::min(agreement.missed, agreement.used + agreement.strangers);
  count(static_cast<double>(counted) *
            std::min(0.0, std::log((1.0 - params_.detection) / (1.0 - mean_chance))),
        true);
  return result;
}

}  // namespace falko_slam
