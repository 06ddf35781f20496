// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "falko_slam/localization/association.hpp"
#include "falko_slam/localization/landmark_map.hpp"
#include "falko_slam/localization/localizer_params.hpp"
#include "falko_slam/localization/localizer_report.hpp"
#include "falko_slam/localization/pose_filter.hpp"
#include "falko_slam/localization/scan_sight.hpp"

namespace falko_slam {

/// What a scan says about a pose.
struct ScanEvidence {
  MapAgreement agreement;
  double log_odds = 0.0;            ///< that the pose is right against that it is somewhere else
  double reflector_log_odds = 0.0;  ///< the part of it that reflectors have
};

/// What is counted of a map that has corners and reflectors.
enum class TellingKinds { kReflectors, kAll };

/// How much a scan speaks for a pose: the score of a track, \cite blackman2004, of the pose that is
/// right against one somewhere else. With p_c the probability that somewhere else an observation
/// finds a landmark in its gate by chance (landmarks per area times the gate's area):
///
///     used observation              log(mapped / p_c)
///     observation that fits nothing log((1 - mapped) / (1 - p_c))
///     landmark expected, not seen   log((1 - detection) / (1 - p_c))
///
/// p_c is taken to be 0.02 at least: maps are regular, and errors of one scan come again in the
/// next. Not more landmarks count as missed than there are observations: a scanner that sees none
/// at all is as blind elsewhere. Of a map that has reflectors, too, corners tell nothing unless
/// they are asked for (TellingKinds::kAll); then with the p_c of PoseEvidenceParams::corner_chance
/// at least: they come at even distances.
class PoseEvidence {
 public:
  PoseEvidence(const PoseEvidenceParams& params, const PoseFilterParams& filter,
               const LandmarkMap& map, std::shared_ptr<const LandmarkIndex> index,
               double gate_probability, TellingKinds kinds = TellingKinds::kReflectors);

  /// `prior` is the pose before the update. Without a sight nothing counts as missed.
  ScanEvidence judge(const PoseEstimate& prior,
                     const std::vector<LandmarkObservation>& observations, const PoseUpdate& update,
                     const ScanSight* sight) const;

  /// They count: the map has no reflectors, or they were asked for.
  bool corners_tell() const { return corners_tell_; }

 private:
  double chance_of(const PoseEstimate& prior, const LandmarkObservation& observation) const;
  void count_expected(const PoseEstimate& pose, const PoseUpdate& update, const ScanSight& sight,
                      MapAgreement& agreement) const;

  PoseEvidenceParams params_;
  Pose2 base_T_laser_;
  std::shared_ptr<const LandmarkIndex> index_;
  bool corners_tell_ = true;
  double least_corner_chance_;
  std::vector<bool> expected_kind_;  // of each landmark: found wherever it is in sight
  double gate_;
  double density_;  // landmarks per square metre
};

}  // namespace falko_slam
