// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "falko_slam/features/feature_extractor_fields.hpp"
#include "falko_slam/ros_bridge/calibration_node_params.hpp"

namespace falko_slam {

template <class Params, class Visitor>
void visit_plan_fields(Params& plan, Visitor& visitor) {
  visitor.field("arcs_per_phase", plan.arcs_per_phase);
  visitor.field("min_steering", plan.min_steering);
  visitor.field("max_steering", plan.max_steering);
  visitor.field("turn", plan.turn);
  visitor.field("wheel_speed", plan.wheel_speed);
  visitor.field("rest", plan.rest);
  visitor.field("max_distance", plan.max_distance);
}

template <class Params, class Visitor>
void visit_driver_fields(Params& session, Visitor& visitor) {
  visitor.field("encoder_timeout", session.driver.encoder_timeout);
  visitor.field("scan_timeout", session.driver.scan_timeout);
  visitor.field("steering_tolerance", session.driver.steering_tolerance);
  visitor.field("motion_timeout", session.driver.motion_timeout);
  visitor.field("braking", session.driver.braking);
  visitor.field("max_bad_arcs", session.max_bad_arcs);
}

template <class Params, class Visitor>
void visit_segment_fields(Params& recorder, Visitor& visitor) {
  visitor.field("scan_duration", recorder.scan_duration);
  visitor.field("settling", recorder.settling);
  visitor.field("min_way", recorder.min_way);
  visitor.field("max_steering_change", recorder.max_steering_change);
  visitor.field("gate_distance", recorder.reflectors.gate_distance);
  visitor.field("gate_share", recorder.reflectors.gate_share);
  visitor.field("detection_noise", recorder.reflectors.detection_noise);
  visitor.field("lasting_noise", recorder.reflectors.lasting_noise);
}

template <class Params, class Visitor>
void visit_noise_fields(Params& noise, Visitor& visitor) {
  visitor.field("slip", noise.slip);
  visitor.field("steer", noise.steer);
  visitor.field("common_slip", noise.common_slip);
  visitor.field("common_steer", noise.common_steer);
  visitor.field("common_position", noise.common_position);
  visitor.field("common_turn", noise.common_turn);
  visitor.field("unknown_factor", noise.unknown_factor);
}

template <class Params, class Visitor>
void visit_calibration_node_fields(Params& params, Visitor& visitor) {
  visitor.field("folder", params.folder);
  visitor.field("file", params.file);
  visitor.field("accept_weak", params.accept_weak);
  visitor.field("control_period", params.control_period);
  visitor.field("feedback_period", params.feedback_period);
  visitor.field("odom_frame", params.odom_frame);
  visitor.field("base_frame", params.base_frame);
  visitor.choice("egomotion", params.session.recorder.egomotion, egomotion_source_names());
  visitor.choice("model", params.session.calibrator.model, tricycle_model_names());
  visitor.field("free_wheelbase", params.session.calibrator.free_wheelbase);
  visitor.field("free_steer_gain", params.session.calibrator.free_steer_gain);
  const auto group = [&](const char* name, auto&& visit) {
    visitor.begin(name);
    visit();
    visitor.end();
  };
  auto& session = params.session;
  group("vehicle", [&] { visit_vehicle_fields(params.vehicle, visitor); });
  group("arcs", [&] { visit_plan_fields(session.plan, visitor); });
  group("driving", [&] { visit_driver_fields(session, visitor); });
  group("scan", [&] { visit_scan_fields(params.scan, visitor); });
  group("segments", [&] { visit_segment_fields(session.recorder, visitor); });
  group("noise", [&] { visit_noise_fields(session.calibrator.noise, visitor); });
}

}  // namespace falko_slam
