// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/localizer_params.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "falko_slam/common/number_text.hpp"
#include "falko_slam/common/validation.hpp"
#include "falko_slam/localization/landmark_map.hpp"
#include "falko_slam/localization/pose_filter.hpp"

namespace falko_slam {
namespace {

constexpr double kTiny = 1e-6;  // for intervals that are open at zero

// "monitor.window = ...": the field with the group that it stands in.
template <class Params>
void validate_group(const char* group, const Params& params) {
  try {
    validate(params);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string(group) + "." + error.what());
  }
}

}  // namespace

void validate(const PoseEvidenceParams& params) {
  require_in_range("detection", params.detection, kTiny, 1.0 - kTiny);
  require_in_range("mapped", params.mapped, kTiny, 1.0 - kTiny);
  require_in_range("expected_range", params.expected_range, 0.0, 1000.0);
  require_in_range("sight_margin", params.sight_margin, 0.01, 10.0);
  require_in_range("corner_chance", params.corner_chance, kTiny, params.mapped);
}

void validate(const PoseMonitorParams& params) {
  validate_group("evidence", params.evidence);
  require_in_range("bound", params.bound, 1.0, 1000.0);
  require_in_range("ok_evidence", params.ok_evidence, 0.0, params.bound);
  require_in_range("lost_evidence", params.lost_evidence, -params.bound, 0.0);
  require_in_range("confirmations", params.confirmations, 1, 1000);
  require_in_range("window", params.window, 0.1, 60.0);
  require_in_range("min_share", params.min_share, 0.0, 1.0);
  require_in_range("min_landmarks", params.min_landmarks, 0.0, 100.0);
  require_in_range("misfit_tail", params.misfit_tail, 1e-12, 0.1);
  require_in_range("ok_position", params.ok_position, kTiny, 100.0);
  require_in_range("ok_heading", params.ok_heading, kTiny, 4.0);
  require_in_range("lost_position", params.lost_position, params.ok_position, 1000.0);
  require_in_range("lost_heading", params.lost_heading, params.ok_heading, 4.0);
  require_in_range("min_scene", params.min_scene, 0.0, 1.0);
  require_in_range("carried_patience", params.carried_patience, 0.0, 60.0);
  require_in_range("scan_silence", params.scan_silence, 0.01, 60.0);
  require_in_range("motion_silence", params.motion_silence, 0.01, 60.0);
  require_in_range("lost_silence", params.lost_silence, 0.1, 3600.0);
}

void validate(const ConstellationParams& params) {
  require_in_range("min_landmarks", params.min_landmarks, 3, 100);
  require_in_range("min_distance", params.min_distance, 0.1, 100.0);
  require_in_range("gate", params.gate, 1.0, 10.0);
  require_in_range("max_candidates", params.max_candidates, 10, 10000000);
  require_in_range("max_results", params.max_results, 1, 1000);
}

void validate(const RecoveryParams& params) {
  require_in_range("scans", params.scans, 1, 1000);
  require_in_range("min_evidence", params.min_evidence, 0.0, 1000.0);
  require_in_range("margin", params.margin, 0.0, 1000.0);
  require_in_range("drop", params.drop, params.margin, 1000.0);
  require_in_range("memory", params.memory, 0, 10000);
  require_in_range("max_hypotheses", params.max_hypotheses, 1, 1000);
  require_in_range("min_share", params.min_share, 0.0, 1.0);
  require_in_range("corner_candidates", params.corner_candidates, 10, 10000000);
}

void validate(const NaturalFeatureParams& params) {
  require_in_range("max_range", params.max_range, 0.5, 1000.0);
  validate_group("falko", params.falko);
  validate_group("corner_noise", params.corner_noise);
  validate_group("faces", params.faces);
}

void validate(const LocalizerParams& params) {
  validate(PoseFilterParams{params.base_T_laser, params.association});
  validate_group("reflectors", params.reflectors);
  validate_group("features", params.features);
  validate_group("landmarks", params.landmarks);
  validate_group("history", params.history);
  validate_group("monitor", params.monitor);
  validate_group("constellation", params.constellation);
  validate_group("recovery", params.recovery);
  require_in_range("mount_position", params.mount_position, 0.0, 1.0);
  require_in_range("mount_heading", params.mount_heading, 0.0, 1.0);
  require_in_range("max_speed", params.max_speed, 0.0, 100.0);
  require_in_range("max_turn_rate", params.max_turn_rate, 0.0, 100.0);
}

std::string take_diameter_of(const LandmarkMap& map, ReflectorDetectorParams& reflectors) {
  const auto first = std::find_if(
      map.landmarks.begin(), map.landmarks.end(),
      [](const MapLandmark& landmark) { return landmark.kind == LandmarkKind::kReflector; });
  if (first == map.landmarks.end() || first->layout.diameter == reflectors.diameter) return "";
  const std::string before = exact_text(reflectors.diameter);
  reflectors.diameter = first->layout.diameter;
  return "reflectors have a diameter of " + exact_text(reflectors.diameter) +
         " m, as the map says, not of " + before + " m, as the parameters say";
}

}  // namespace falko_slam
