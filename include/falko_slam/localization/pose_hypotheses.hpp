// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "falko_slam/localization/constellation_search.hpp"
#include "falko_slam/localization/pose_evidence.hpp"
#include "falko_slam/localization/pose_filter.hpp"

namespace falko_slam {

/// A place that may be the pose.
struct PoseHypothesis {
  PoseEstimate map_T_base;
  double log_odds = 0.0;                ///< sum of PoseEvidence less half of the excess of the NIS
  int scans = 0;                        ///< that agreed
  double reflector_log_odds = 0.0;      ///< the part of it that reflectors have
  std::size_t used = 0, strangers = 0;  ///< observations of all scans that fit, and that do not
};

/// Several places at once, until scans decide: each is moved by the odometry and corrected by every
/// scan like a pose of its own (\cite blackman2004); every scan may bring new ones, by
/// ConstellationSearch among all that was seen in the last seconds: where one scan shows too few
/// landmarks, those on the way may do. Not thread-safe.
class PoseHypotheses {
 public:
  PoseHypotheses(const LocalizerParams& params, std::shared_ptr<const LandmarkIndex> map,
                 const PoseEvidence& evidence);

  void clear();

  /// All places by the motion of base_link since the last scan.
  void move(const PoseEstimate& motion);
  void add_scan(const std::vector<LandmarkObservation>& observations, const ScanSight* sight);

  /// The one that is better than all others by as much as RecoveryParams asks for.
  std::optional<PoseHypothesis> decided() const;
  /// The same of places that corners have a part in: reflectors must not speak against it, and
  /// RecoveryParams::min_share of what was seen must be in the map.
  std::optional<PoseHypothesis> decided_with_corners() const;

  const std::vector<PoseHypothesis>& places() const { return places_; }  ///< the best one first

 private:
  void correct(PoseHypothesis& place, const std::vector<LandmarkObservation>& observations,
               const ScanSight* sight) const;
  std::optional<PoseHypothesis> hypothesis_of(const PlaceCandidate& candidate,
                                              const std::vector<LandmarkObservation>& observations,
                                              const ScanSight* sight) const;
  void add_new(const std::vector<LandmarkObservation>& observations, const ScanSight* sight);
  bool is_remembered(LandmarkKind kind) const;
  void remember(const std::vector<LandmarkObservation>& observations);
  void sort_and_drop();

  // A landmark that was seen, and how many scans ago.
  struct Sighting {
    PointEstimate in_base;
    LandmarkKind kind = LandmarkKind::kReflector;
    int age = 0;
  };

  RecoveryParams params_;
  PoseFilterParams filter_params_;
  std::shared_ptr<const LandmarkIndex> map_;
  const PoseEvidence& evidence_;
  ConstellationSearch search_;
  bool has_reflectors_ = false;
  std::vector<PoseHypothesis> places_;
  std::vector<Sighting> sightings_;
};

}  // namespace falko_slam
