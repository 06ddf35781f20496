// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "falko_slam/features/feature_extractor_fields.hpp"
#include "falko_slam/features/reflector_detector_fields.hpp"
#include "falko_slam/localization/localizer_params.hpp"

namespace falko_slam {

// The names of the localizer's parameters in files and on the parameter server: their one home. For
// the visitors see feature_extractor_fields.hpp. base_T_laser is not among them: the vehicle's.

template <class Params, class Visitor>
void visit_evidence_fields(Params& params, Visitor& visitor) {
  visitor.field("detection", params.detection);
  visitor.field("mapped", params.mapped);
  visitor.field("expected_range", params.expected_range);
  visitor.field("sight_margin", params.sight_margin);
  visitor.field("corner_chance", params.corner_chance);
}

template <class Params, class Visitor>
void visit_monitor_fields(Params& params, Visitor& visitor) {
  visitor.field("bound", params.bound);
  visitor.field("ok_evidence", params.ok_evidence);
  visitor.field("lost_evidence", params.lost_evidence);
  visitor.field("confirmations", params.confirmations);
  visitor.field("window", params.window);
  visitor.field("min_share", params.min_share);
  visitor.field("min_landmarks", params.min_landmarks);
  visitor.field("misfit_tail", params.misfit_tail);
  visitor.field("ok_position", params.ok_position);
  visitor.field("ok_heading", params.ok_heading);
  visitor.field("lost_position", params.lost_position);
  visitor.field("lost_heading", params.lost_heading);
  visitor.field("min_scene", params.min_scene);
  visitor.field("carried_patience", params.carried_patience);
  visitor.field("scan_silence", params.scan_silence);
  visitor.field("motion_silence", params.motion_silence);
  visitor.field("lost_silence", params.lost_silence);
  visitor.begin("evidence");
  visit_evidence_fields(params.evidence, visitor);
  visitor.end();
}

template <class Params, class Visitor>
void visit_constellation_fields(Params& params, Visitor& visitor) {
  visitor.field("min_landmarks", params.min_landmarks);
  visitor.field("min_distance", params.min_distance);
  visitor.field("gate", params.gate);
  visitor.field("max_candidates", params.max_candidates);
  visitor.field("max_results", params.max_results);
}

template <class Params, class Visitor>
void visit_recovery_fields(Params& params, Visitor& visitor) {
  visitor.field("scans", params.scans);
  visitor.field("min_evidence", params.min_evidence);
  visitor.field("margin", params.margin);
  visitor.field("drop", params.drop);
  visitor.field("memory", params.memory);
  visitor.field("max_hypotheses", params.max_hypotheses);
  visitor.field("corners", params.corners);
  visitor.field("min_share", params.min_share);
  visitor.field("corner_candidates", params.corner_candidates);
}

template <class Params, class Visitor>
void visit_association_fields(Params& params, Visitor& visitor) {
  visitor.field("gate_probability", params.gate_probability);
  visitor.field("joint_probability", params.joint_probability);
  visitor.field("ambiguity", params.ambiguity);
  visitor.field("max_nodes", params.max_nodes);
}

template <class Params, class Visitor>
void visit_history_fields(Params& params, Visitor& visitor) {
  visitor.field("span", params.span);
  visitor.field("max_ahead", params.max_ahead);
  visitor.field("max_inputs", params.max_inputs);
}

template <class Params, class Visitor>
void visit_corner_noise_fields(Params& params, Visitor& visitor) {
  visitor.field("range_noise", params.range_noise);
  visitor.field("bearing_noise", params.bearing_noise);
  visitor.field("place_noise", params.place_noise);
}

template <class Params, class Visitor>
void visit_face_fields(Params& params, Visitor& visitor) {
  visitor.field("max_range", params.max_range);
  visitor.field("range_noise", params.range_noise);
  visitor.field("bearing_noise", params.bearing_noise);
  visitor.field("straightness", params.straightness);
  visitor.field("end_beams", params.end_beams);
  visitor.field("min_beams", params.min_beams);
  visitor.field("min_length", params.min_length);
}

/// All but base_T_laser and association, which are the localizer's.
template <class Params, class Visitor>
void visit_landmark_fields(Params& params, Visitor& visitor) {
  visitor.field("max_landmarks", params.max_landmarks);
  visitor.field("hits", params.hits);
  visitor.field("forget_after", params.forget_after);
  visitor.field("give_up_after", params.give_up_after);
  visitor.field("separation", params.separation);
  visitor.field("point_wander", params.point_wander);
  visitor.field("face_wander", params.face_wander);
  visitor.field("face_turn_wander", params.face_turn_wander);
}

/// All but the FALKO detector's own parameters (visit_falko_fields).
template <class Params, class Visitor>
void visit_localizer_fields(Params& params, Visitor& visitor) {
  const auto group = [&](const char* name, auto&& visit) {
    visitor.begin(name);
    visit();
    visitor.end();
  };
  visitor.field("deskew", params.deskew);
  visitor.field("mount_position", params.mount_position);
  visitor.field("mount_heading", params.mount_heading);
  visitor.field("max_speed", params.max_speed);
  visitor.field("max_turn_rate", params.max_turn_rate);
  visitor.field("search_alone", params.search_alone);
  group("reflectors", [&] { visit_reflector_detector_fields(params.reflectors, visitor); });
  group("features", [&] {
    visitor.field("unmapped", params.features.unmapped);
    visitor.field("max_range", params.features.max_range);
    group("corner_noise",
          [&] { visit_corner_noise_fields(params.features.corner_noise, visitor); });
    group("faces", [&] { visit_face_fields(params.features.faces, visitor); });
  });
  group("landmarks", [&] { visit_landmark_fields(params.landmarks, visitor); });
  group("association", [&] { visit_association_fields(params.association, visitor); });
  group("history", [&] { visit_history_fields(params.history, visitor); });
  group("monitor", [&] { visit_monitor_fields(params.monitor, visitor); });
  group("constellation", [&] { visit_constellation_fields(params.constellation, visitor); });
  group("recovery", [&] { visit_recovery_fields(params.recovery, visitor); });
}

}  // namespace falko_slam
