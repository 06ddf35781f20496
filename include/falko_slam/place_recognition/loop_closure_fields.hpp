// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "falko_slam/features/feature_extractor_fields.hpp"
#include "falko_slam/place_recognition/keyframe_memory.hpp"

namespace falko_slam {

// The names of the loop closure's parameters in files and on the parameter server: their one home.
// For the visitors see feature_extractor_fields.hpp.

template <class Params, class Visitor>
void visit_selector_fields(Params& params, Visitor& visitor) {
  visitor.field("min_step", params.min_step);
  visitor.field("min_turn", params.min_turn);
  visitor.field("max_jump", params.max_jump);
}

template <class Params, class Visitor>
void visit_odometry_fields(Params& params, Visitor& visitor) {
  visitor.field("max_move", params.max_move);
  visitor.field("max_turn", params.max_turn);
  visitor.field("min_agreement", params.min_agreement);
  visitor.field("min_constraint", params.min_constraint);
}

template <class Params, class Visitor>
void visit_loop_fields(Params& params, Visitor& visitor) {
  visitor.field("candidates", params.candidates);
  visitor.field("verified", params.verified);
  visitor.field("compared", params.compared);
  visitor.field("neighborhood", params.neighborhood);
  visitor.field("neighbor_spacing", params.neighbor_spacing);
  visitor.field("max_neighbors", params.max_neighbors);
  visitor.field("neighbor_tolerance", params.neighbor_tolerance);
  visitor.field("min_path", params.min_path);
  visitor.field("min_score", params.min_score);
  visitor.field("ambiguity", params.ambiguity);
  visitor.field("contradicting_distance", params.contradicting_distance);
  visitor.field("contradicting_turn", params.contradicting_turn);
  visitor.field("drift", params.drift);
  visitor.field("turn_drift", params.turn_drift);
}

template <class Params, class Visitor>
void visit_surface_fields(Params& params, Visitor& visitor) {
  visitor.field("max_step", params.max_step);
  visitor.field("step_ratio", params.step_ratio);
}

template <class Params, class Visitor>
void visit_wall_end_fields(Params& params, Visitor& visitor) {
  visitor.field("min_jump", params.min_jump);
  visitor.field("wall_steps", params.wall_steps);
  visit_surface_fields(params.surface, visitor);
}

/// Of KeyframeParams: its walls and GLARE.
template <class Params, class Visitor>
void visit_signature_fields(Params& params, Visitor& visitor) {
  visitor.field("direction_cells", params.glare.direction_cells);
  visitor.field("distance_cells", params.glare.distance_cells);
  visitor.field("distance_cell_size", params.glare.distance_cell_size);
  visitor.field("spread", params.glare.spread);
  visitor.field("wall_spacing", params.wall_spacing);
  visitor.field("wall_range", params.wall_range);
}

template <class Params, class Visitor>
void visit_view_fields(Params& params, Visitor& visitor) {
  visitor.field("point_spacing", params.point_spacing);
  visitor.field("max_range", params.max_range);
  visitor.field("normal_reach", params.normal_reach);
  visit_surface_fields(params.surface, visitor);
}

template <class Params, class Visitor>
void visit_matcher_fields(Params& params, Visitor& visitor) {
  visitor.field("distance_tolerance", params.distance_tolerance);
  visitor.field("inlier_distance", params.inlier_distance);
  visitor.field("min_segment", params.min_segment);
  visitor.field("max_query_segments", params.max_query_segments);
  visitor.field("orientation_gate", params.orientation_gate);
  visitor.field("max_matches", params.max_matches);
  visitor.field("min_pairs", params.min_pairs);
  visitor.field("separation", params.separation);
  visitor.field("heading_separation", params.heading_separation);
  visitor.field("residual_noise", params.residual_noise);
}

template <class Params, class Visitor>
void visit_agreement_fields(Params& params, Visitor& visitor) {
  visitor.field("tolerance", params.tolerance);
  visitor.field("see_through", params.see_through);
}

template <class Params, class Visitor>
void visit_registration_fields(Params& params, Visitor& visitor) {
  visitor.field("iterations", params.iterations);
  visitor.field("first_gate", params.first_gate);
  visitor.field("last_gate", params.last_gate);
}

/// A group of fields, its members visited by `visit(members, visitor)`.
template <class Params, class Visitor, class Visit>
void visit_group(const char* name, Params& members, Visitor& visitor, const Visit& visit) {
  visitor.begin(name);
  visit(members, visitor);
  visitor.end();
}

/// Of LoopDetectorParams: the groups of what it is made of.
template <class Params, class Visitor>
void visit_detector_groups(Params& params, Visitor& visitor) {
  auto& keyframe = params.keyframe;
  const auto group = [&](const char* name, auto& members, const auto& visit) {
    visit_group(name, members, visitor, visit);
  };
  group("falko", keyframe.falko, [](auto& p, auto& v) { visit_falko_fields(p, v); });
  group("wall_end", keyframe.wall_end, [](auto& p, auto& v) { visit_wall_end_fields(p, v); });
  group("signature", keyframe, [](auto& p, auto& v) { visit_signature_fields(p, v); });
  group("view", keyframe.view, [](auto& p, auto& v) { visit_view_fields(p, v); });
  group("matcher", params.matcher, [](auto& p, auto& v) { visit_matcher_fields(p, v); });
  group("agreement", params.agreement, [](auto& p, auto& v) { visit_agreement_fields(p, v); });
  group("registration", params.registration,
        [](auto& p, auto& v) { visit_registration_fields(p, v); });
}

template <class Params, class Visitor>
void visit_loop_closure_fields(Params& params, Visitor& visitor) {
  const auto group = [&](const char* name, auto& members, const auto& visit) {
    visit_group(name, members, visitor, visit);
  };
  auto& detector = params.detector;
  group("scan", params.scan, [](auto& p, auto& v) { visit_scan_fields(p, v); });
  group("keyframes", params.selector, [](auto& p, auto& v) { visit_selector_fields(p, v); });
  group("loops", detector, [](auto& p, auto& v) { visit_loop_fields(p, v); });
  group("odometry", detector.odometry, [](auto& p, auto& v) { visit_odometry_fields(p, v); });
  visit_detector_groups(detector, visitor);
}

}  // namespace falko_slam
