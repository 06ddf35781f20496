// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "falko_slam/place_recognition/loop_closure_fields.hpp"
#include "falko_slam/slam/slam_params.hpp"

namespace falko_slam {

// The names of SLAM's parameters in files and on the parameter server: their one home, beside those
// of the loop closure. For the visitors see feature_extractor_fields.hpp.

inline const EnumNames<Loss>& loss_names() {
  static const EnumNames<Loss> names = {
      {"none", Loss::kNone}, {"huber", Loss::kHuber}, {"cauchy", Loss::kCauchy}};
  return names;
}

template <class Params, class Visitor>
void visit_tracker_fields(Params& params, Visitor& visitor) {
  visitor.field("min_step", params.min_step);
  visitor.field("min_turn", params.min_turn);
  visitor.field("local_keyframes", params.local_keyframes);
  visitor.field("odometry_distance", params.odometry_distance);
  visitor.field("odometry_turn", params.odometry_turn);
  visitor.field("odometry_share", params.odometry_share);
  visitor.field("free_distance", params.free_distance);
  visitor.field("free_turn", params.free_turn);
  visitor.field("good_agreement", params.good_agreement);
  visitor.field("least_agreement", params.least_agreement);
  visitor.field("max_jump", params.max_jump);
}

template <class Params, class Visitor>
void visit_link_fields(Params& params, Visitor& visitor) {
  visitor.field("max_move", params.max_move);
  visitor.field("max_turn", params.max_turn);
  visitor.field("min_agreement", params.min_agreement);
  visitor.field("min_wall", params.min_wall);
  visitor.field("min_view", params.min_view);
}

template <class Params, class Visitor>
void visit_nearby_fields(Params& params, Visitor& visitor) {
  visitor.field("max_distance", params.max_distance);
  visitor.field("max_turn", params.max_turn);
  visitor.field("spacing", params.spacing);
  visitor.field("min_path", params.min_path);
  visitor.field("count", params.count);
  visitor.field("max_drift", params.max_drift);
}

template <class Params, class Visitor>
void visit_graph_fields(Params& params, Visitor& visitor) {
  visitor.field("neighbors", params.neighbors);
  visitor.field("step_distance", params.step_distance);
  visitor.field("step_turn", params.step_turn);
  visitor.field("urgent_distance", params.urgent_distance);
  visitor.field("urgent_turn", params.urgent_turn);
  visitor.field("optimize_every", params.optimize_every);
  visitor.field("anchor_distance", params.anchor_distance);
  visitor.field("anchor_turn", params.anchor_turn);
}

template <class Params, class Visitor>
void visit_consistency_fields(Params& params, Visitor& visitor) {
  visitor.field("gate_probability", params.gate_probability);
  visitor.field("trusted_chance", params.trusted_chance);
  visitor.field("confirmations", params.confirmations);
}

template <class Params, class Visitor>
void visit_optimizer_fields(Params& params, Visitor& visitor) {
  visitor.choice("closure_loss", params.closure_loss, loss_names());
  visitor.field("loss_scale", params.loss_scale);
  visitor.field("max_iterations", params.max_iterations);
}

template <class Params, class Visitor>
void visit_map_fields(Params& params, Visitor& visitor) {
  visitor.field("resolution", params.resolution);
  visitor.field("hit_probability", params.hit_probability);
  visitor.field("miss_probability", params.miss_probability);
  visitor.field("min_probability", params.min_probability);
  visitor.field("max_probability", params.max_probability);
  visitor.field("max_range", params.max_range);
  visitor.field("max_free_range", params.max_free_range);
  visitor.field("no_return_free_range", params.no_return_free_range);
}

template <class Params, class Visitor>
void visit_slam_fields(Params& params, Visitor& visitor) {
  const auto group = [&](const char* name, auto& members, const auto& visit) {
    visit_group(name, members, visitor, visit);
  };
  visitor.field("deskew", params.deskew);
  group("scan", params.scan, [](auto& p, auto& v) { visit_scan_fields(p, v); });
  group("tracker", params.tracker, [](auto& p, auto& v) { visit_tracker_fields(p, v); });
  group("link", params.link, [](auto& p, auto& v) { visit_link_fields(p, v); });
  group("nearby", params.nearby, [](auto& p, auto& v) { visit_nearby_fields(p, v); });
  group("loops", params.loops, [](auto& p, auto& v) { visit_loop_fields(p, v); });
  group("graph", params.graph, [](auto& p, auto& v) { visit_graph_fields(p, v); });
  group("consistency", params.consistency,
        [](auto& p, auto& v) { visit_consistency_fields(p, v); });
  group("optimizer", params.optimizer, [](auto& p, auto& v) { visit_optimizer_fields(p, v); });
  group("map", params.map, [](auto& p, auto& v) { visit_map_fields(p, v); });
  visit_detector_groups(params.loops, visitor);
}

}  // namespace falko_slam
