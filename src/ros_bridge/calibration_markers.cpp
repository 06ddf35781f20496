// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/calibration_markers.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "falko_slam/geometry/angles.hpp"
#include "marker_list.hpp"

namespace falko_slam {
namespace {

using visualization_msgs::Marker;

// Between points of what has been driven.
constexpr double kStep = 0.1;   // [m]
constexpr double kTurn = 0.02;  // [rad]

bool far_from(const Pose2& a, const Pose2& b) {
  return (a.translation() - b.translation()).norm() > kStep ||
         std::abs(angle_between(a.theta(), b.theta())) > kTurn;
}

constexpr MarkerLook kPlanned{"planned", 0.85F, 0.85F, 0.75F, 1.0F, 0.03};
constexpr MarkerLook kDriven{"driven", 0.2F, 0.5F, 1.0F, 1.0F, 0.05};
constexpr MarkerLook kMeasuredReflectors{"reflectors", 0.8F, 0.2F, 0.9F, 1.0F, 0.25};
// By CalibrationMarkers::Arrow::Kind.
constexpr MarkerLook kResiduals[] = {{"residuals", 1.0F, 0.6F, 0.1F, 1.0F, 0.06},
                                     {"residuals", 0.1F, 0.8F, 0.2F, 1.0F, 0.06},
                                     {"residuals", 1.0F, 0.1F, 0.1F, 1.0F, 0.06}};

// Head and shaft of an arrow, as line segments.
void add_arrow(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Marker& lines) {
  const Eigen::Vector2d back = 0.2 * (from - to);
  const Eigen::Vector2d across(-0.5 * back.y(), 0.5 * back.x());
  for (const Eigen::Vector2d& end :
       {from, Eigen::Vector2d(to + back + across), Eigen::Vector2d(to + back - across)}) {
    add_point(lines, end);
    add_point(lines, to);
  }
}

}  // namespace

CalibrationMarkers::CalibrationMarkers(const CalibrationSessionParams& params,
                                       const Pose2& odom_T_start)
    : odom_T_start_(odom_T_start), base_T_laser_(params.recorder.base_T_laser) {
  for (const Pose2& pose : way_of(params.plan, params.driver.tricycle).poses) {
    planned_.push_back(odom_T_start * pose);
  }
}

void CalibrationMarkers::add_pose(Time stamp, const Pose2& start_T_base) {
  const Pose2 here = odom_T_start_ * start_T_base;
  // The last one is always the newest; while the vehicle stands, that is when it halted.
  const bool stands = !driven_.empty() &&
                      here.translation() == driven_.back().odom_T_base.translation() &&
                      here.theta() == driven_.back().odom_T_base.theta();
  if (stands) return;
  const bool keeps_last =
      driven_.size() < 2 || far_from(driven_[driven_.size() - 2].odom_T_base, here);
  if (keeps_last) driven_.emplace_back();
  driven_.back() = {stamp, here};
}

Pose2 CalibrationMarkers::place_at(Time stamp) const {
  const auto after =
      std::upper_bound(driven_.begin(), driven_.end(), stamp,
                       [](Time time, const Passed& passed) { return time < passed.stamp; });
  return after == driven_.begin() ? odom_T_start_ : std::prev(after)->odom_T_base;
}

void CalibrationMarkers::set_reflectors(const ReflectorObservation& observation) {
  reflectors_.clear();
  const Pose2 odom_T_laser = place_at(observation.first_beam) * base_T_laser_;
  for (const SightedReflector& seen : observation.reflectors) {
    reflectors_.push_back(odom_T_laser * seen.point);
  }
}

std::optional<CalibrationMarkers::Arrow> CalibrationMarkers::arrow_of(const SessionArc& arc) const {
  if (!arc.residual) return std::nullopt;
  return Arrow{place_at(arc.recorded.end) * base_T_laser_, arc.residual->head<2>(),
               arc.recorded.segment.turn, Arrow::Kind::kBelieved};
}

void CalibrationMarkers::set_arcs(const std::vector<SessionArc>& arcs) {
  for (std::size_t i = arrows_.size(); i < arcs.size(); ++i) arrows_.push_back(arrow_of(arcs[i]));
}

void CalibrationMarkers::set_result(const RecordedCalibration& calibration) {
  if (!calibration.result.estimate) return;
  for (std::size_t i = 0; i < calibration.recorded.size(); ++i) {
    std::optional<Arrow>& arrow = arrows_.at(calibration.recorded[i]);
    const SegmentReport& report = calibration.result.estimate->segments.at(i);
    if (!arrow) continue;
    arrow->residual = report.residual.head<2>();
    arrow->kind = report.used ? Arrow::Kind::kCalibrated : Arrow::Kind::kLeftOut;
  }
}

visualization_msgs::MarkerArray CalibrationMarkers::markers(const std_msgs::Header& header) const {
  Marker planned = marker_of(kPlanned, Marker::LINE_STRIP, header);
  for (const Pose2& pose : planned_) add_point(planned, pose.translation());
  Marker driven = marker_of(kDriven, Marker::LINE_STRIP, header);
  for (const Passed& passed : driven_) add_point(driven, passed.odom_T_base.translation());
  Marker reflectors = marker_of(kMeasuredReflectors, Marker::SPHERE_LIST, header);
  for (const Eigen::Vector2d& reflector : reflectors_) add_point(reflectors, reflector);
  std::vector<Marker> kinds;
  for (const MarkerLook& look : kResiduals) {
    kinds.push_back(marker_of(look, Marker::LINE_LIST, header));
  }
  for (const std::optional<Arrow>& arrow : arrows_) {
    if (!arrow) continue;
    const Pose2 end = arrow->odom_T_laser;
    const double heading = end.theta() - arrow->turn;  // of the frame that the residual is in
    const Eigen::Vector2d offset = Pose2(0.0, 0.0, heading) * arrow->residual;
    const double scale = arrow->kind == Arrow::Kind::kBelieved ? kBelievedScale : kResidualScale;
    add_arrow(end.translation(), end.translation() + scale * offset,
              kinds[static_cast<std::size_t>(arrow->kind)]);
  }
  visualization_msgs::MarkerArray array;
  for (Marker* marker : {&planned, &driven, &reflectors, &kinds[0], &kinds[1], &kinds[2]}) {
    marker->id = static_cast<std::int32_t>(array.markers.size());
    append(std::move(*marker), array);
  }
  return array;
}

}  // namespace falko_slam
