// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/association.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "covariance_check.hpp"
#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "gate_radius.hpp"
#include "joint_search.hpp"

namespace falko_slam {
namespace {

constexpr double kNearest = 1e-3;  // [m]: nearer to the laser than this, a bearing says nothing

// The joint distance of a pose filter's pairs at constant cost for each, by the matrix inversion
// lemma. With P = L L^T, whitened H' = H L and W_i the inverse noise of pair i
//
//   sum_i nu_i^T W_i nu_i - b^T (I + A)^-1 b,   A = sum_i H'_i^T W_i H'_i,  b = sum_i H'_i^T W_i
//   nu_i
//
// is nu^T (H P H^T + N)^-1 nu, for the noises of different pairs are independent.
class PoseJointDistance : public JointDistance {
 public:
  PoseJointDistance(const Eigen::Matrix3d& L, const std::vector<LandmarkPair>& pairs) : sums_(1) {
    for (const LandmarkPair& pair : pairs) {
      const Eigen::Matrix<double, 2, 3> H = pair.dobservation_dpose * L;
      const Eigen::Matrix2d W = pair.noise.inverse();
      const Eigen::Matrix<double, 3, 2> HW = H.transpose() * W;
      terms_.push_back({HW * H, HW * pair.innovation, pair.innovation.dot(W * pair.innovation)});
    }
  }

  double with(std::size_t count, std::size_t pair) override {
    if (sums_.size() < count + 2) sums_.resize(count + 2);
    const Sum& before = sums_[count];
    Sum& sum = sums_[count + 1];
    sum.A = before.A + terms_[pair].A;
    sum.b = before.b + terms_[pair].b;
    sum.c = before.c + terms_[pair].c;
    const Eigen::Matrix3d information = Eigen::Matrix3d::Identity() + sum.A;
    return std::max(0.0, sum.c - sum.b.dot(information.inverse() * sum.b));
  }

 private:
  struct Sum {
    Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    double c = 0.0;
  };
  std::vector<Sum> terms_;  // of each pair
  std::vector<Sum> sums_;   // of the first n pairs
};

LandmarkPair predicted_pair(const PoseEstimate& map_T_base, const Pose2& base_T_laser,
                            const Landmark& landmark, const LandmarkObservation& observation) {
  const ObservationPrediction prediction =
      predict_observation(observation.model, map_T_base.pose, base_T_laser, landmark.position);
  const Eigen::Matrix2d& dp = prediction.dvalue_dlandmark;
  const auto& H = prediction.dvalue_dpose;
  LandmarkPair pair;
  pair.innovation = innovation_of(observation.model, observation.value, prediction.value);
  pair.dobservation_dpose = H;
  pair.noise = observation.covariance + dp * landmark.covariance * dp.transpose();
  const Eigen::Matrix2d S = H * map_T_base.covariance * H.transpose() + pair.noise;
  pair.distance = pair.innovation.dot(S.inverse() * pair.innovation);
  return pair;
}

// Appends the pairs of one observation that pass their gate.
class PairGate {
 public:
  PairGate(const PoseEstimate& map_T_base, const Pose2& base_T_laser, const LandmarkIndex& map,
           const AssociationParams& params)
      : map_T_base_(map_T_base),
        base_T_laser_(base_T_laser),
        map_(map),
        gate_(pair_gate(params.gate_probability)),
        radius_(map_T_base, base_T_laser, map.largest_deviation(), std::sqrt(gate_)) {}

  ObservationVerdict add(const LandmarkObservation& observation, std::size_t number,
                         std::vector<LandmarkPair>& pairs) {
    if (!is_usable(observation)) return ObservationVerdict::kInvalid;
    if (observation.id) {
      const auto place = map_.find(*observation.id);
      if (!place) return ObservationVerdict::kUnknownId;
      near_.assign(1, *place);
    } else {
      const Pose2 map_T_laser = map_T_base_.pose * base_T_laser_;
      map_.find_near(map_T_laser * point_in_laser(observation), radius_.of(observation), near_);
      std::sort(near_.begin(), near_.end());
    }
    const std::size_t before = pairs.size();
    for (const std::size_t place : near_) try_one(observation, number, place, pairs);
    return pairs.size() > before ? ObservationVerdict::kUsed : ObservationVerdict::kNoLandmark;
  }

 private:
  void try_one(const LandmarkObservation& observation, std::size_t number, std::size_t place,
               std::vector<LandmarkPair>& pairs) const {
    const Landmark& landmark = map_.landmarks()[place];
    if (landmark.kind != observation.kind) return;
    const Eigen::Vector2d laser = map_T_base_.pose * base_T_laser_.translation();
    if ((landmark.position - laser).norm() < kNearest) return;
    LandmarkPair pair = predicted_pair(map_T_base_, base_T_laser_, landmark, observation);
    if (!(pair.distance <= gate_)) return;
    pair.observation = number;
    pair.landmark = place;
    pairs.push_back(pair);
  }

  const PoseEstimate& map_T_base_;
  const Pose2& base_T_laser_;
  const LandmarkIndex& map_;
  double gate_;
  GateRadius radius_;
  std::vector<std::size_t> near_;
};

// The landmarks of the pairs by small numbers: the search marks those that are taken.
JointPairs joint_pairs(const std::vector<LandmarkPair>& pairs) {
  std::vector<std::size_t> landmarks;
  landmarks.reserve(pairs.size());
  for (const LandmarkPair& pair : pairs) landmarks.push_back(pair.landmark);
  std::sort(landmarks.begin(), landmarks.end());
  landmarks.erase(std::unique(landmarks.begin(), landmarks.end()), landmarks.end());
  JointPairs joint;
  joint.landmarks = landmarks.size();
  for (const LandmarkPair& pair : pairs) {
    const auto place = std::lower_bound(landmarks.begin(), landmarks.end(), pair.landmark);
    joint.pairs.push_back(
        {pair.observation, static_cast<std::size_t>(place - landmarks.begin()), pair.distance});
  }
  return joint;
}

}  // namespace

void validate(const AssociationParams& params) {
  require_in_range("gate_probability", params.gate_probability, 0.5, 0.999999);
  require_in_range("joint_probability", params.joint_probability, 0.5, 0.999999);
  require_in_range("ambiguity", params.ambiguity, 0.0, 1000.0);
  require_in_range("max_nodes", params.max_nodes, 1, 1000000);
}

bool fits_nothing(ObservationVerdict verdict) {
  return verdict == ObservationVerdict::kNoLandmark ||
         verdict == ObservationVerdict::kIncompatible || verdict == ObservationVerdict::kUnknownId;
}

const char* name_of(ObservationVerdict verdict) {
  switch (verdict) {
    case ObservationVerdict::kUsed:
      return "used";
    case ObservationVerdict::kInvalid:
      return "invalid";
    case ObservationVerdict::kUnknownId:
      return "unknown id";
    case ObservationVerdict::kNoLandmark:
      return "no landmark";
    case ObservationVerdict::kIncompatible:
      return "incompatible";
    case ObservationVerdict::kAmbiguous:
      return "ambiguous";
    case ObservationVerdict::kTentative:
      return "tentative";
    case ObservationVerdict::kAdded:
      return "added";
    case ObservationVerdict::kTooNear:
      return "too near";
  }
  return "?";
}

Association gate_pairs(const PoseEstimate& map_T_base, const Pose2& base_T_laser,
                       const LandmarkIndex& map,
                       const std::vector<LandmarkObservation>& observations,
                       const AssociationParams& params) {
  PairGate gate(map_T_base, base_T_laser, map, params);
  Association result;
  for (std::size_t i = 0; i < observations.size(); ++i) {
    result.verdicts.push_back(gate.add(observations[i], i, result.pairs));
  }
  return result;
}

Association associate(const PoseEstimate& map_T_base, const Pose2& base_T_laser,
                      const LandmarkIndex& map,
                      const std::vector<LandmarkObservation>& observations,
                      const AssociationParams& params) {
  Association gated = gate_pairs(map_T_base, base_T_laser, map, observations, params);
  Eigen::Matrix3d L;
  if (!factorise<3>(map_T_base.covariance, L)) L.setZero();
  PoseJointDistance distance(L, gated.pairs);
  const JointSelection selection =
      search_jointly(joint_pairs(gated.pairs), distance,
                     {params.joint_probability, pair_gate(params.gate_probability),
                      params.ambiguity, params.max_nodes});

  Association result;
  result.verdicts = std::move(gated.verdicts);
  result.proven = selection.proven;
  for (const LandmarkPair& pair : gated.pairs) {
    result.verdicts[pair.observation] = ObservationVerdict::kIncompatible;
  }
  for (const std::size_t observation : selection.ambiguous) {
    result.verdicts[observation] = ObservationVerdict::kAmbiguous;
  }
  for (const std::size_t place : selection.pairs) {
    result.pairs.push_back(gated.pairs[place]);
    result.verdicts[gated.pairs[place].observation] = ObservationVerdict::kUsed;
  }
  return result;
}

}  // namespace falko_slam
