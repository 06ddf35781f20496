// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/sensor/deskew.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "uniform_scan.hpp"

namespace falko_slam {
namespace {

using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

// b turned by the angle of a, both of length 1.
Vector2d turned(const Vector2d& a, const Vector2d& b) {
  return {a.x() * b.x() - a.y() * b.y(), a.y() * b.x() + a.x() * b.y()};
}

Vector2d direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

// Angle of a vector whose direction is near the x axis.
double small_angle(double along, double across) {
  constexpr double kSeriesEnd = 0.25;
  if (!(std::abs(across) < kSeriesEnd * along)) return std::atan2(across, along);
  const double slope = across / along, square = slope * slope;
  return slope * (1.0 + square * (-1.0 / 3.0 +
                                  square * (0.2 + square * (-1.0 / 7.0 + square * (1.0 / 9.0)))));
}

// std::floor, which plain x86-64 does not have.
std::ptrdiff_t whole_below(double place) {
  const auto whole = static_cast<std::ptrdiff_t>(place);
  return static_cast<double>(whole) > place ? whole - 1 : whole;
}
std::ptrdiff_t nearest_whole(double place) { return whole_below(place + 0.5); }

// A beam, seen from where the laser was at the instant.
struct MovedBeam {
  Vector2d point;  // if valid [m]
  double place;    // its direction as a beam's number
};

// Pose and directions go on from beam to beam by the same motion: no sine of them is worked out.
std::vector<MovedBeam> moved_beams(const LaserScan& scan, const Eigen::Vector3d& twist,
                                   Time instant) {
  const double increment = to_seconds(scan.time_increment);
  const Pose2 first = Pose2::exp(twist * to_seconds(scan.first_beam_time - instant));
  const Vector2d step = Pose2::exp(twist * increment).translation();
  const Vector2d step_turn = direction(twist.z() * increment);
  const Vector2d beam_turn = direction(scan.angle_increment);
  const double first_turn = twist.z() * to_seconds(scan.first_beam_time - instant);
  const double beams_per_radian = 1.0 / scan.angle_increment;
  const double turn_per_beam = twist.z() * increment;
  Vector2d position = first.translation(), heading = direction(first_turn);
  Vector2d bearing = direction(scan.angle_min);
  std::vector<MovedBeam> beams(scan.size());
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const auto beam = static_cast<double>(i);
    if (scan.valid(i)) {
      const Vector2d point = position + scan.ranges[i] * turned(heading, bearing);
      const double turn = small_angle(bearing.dot(point), cross(bearing, point));
      beams[i] = {point, beam + turn * beams_per_radian};
    } else {
      const double turn = first_turn + beam * turn_per_beam;
      beams[i] = {Vector2d::Zero(), beam + turn * beams_per_radian};
    }
    position += turned(heading, step);
    heading = turned(heading, step_turn);
    bearing = turned(bearing, beam_turn);
  }
  return beams;
}

class Resampling {
 public:
  Resampling(const LaserScan& scan, std::vector<MovedBeam> beams, const SurfaceStepParams& surface)
      : scan_(scan), beams_(std::move(beams)), surface_(surface), result_(scan) {}

  LaserScan run(Time instant) {
    const std::size_t count = scan_.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (!scan_.valid(i)) keep_status(i);
    }
    bool joined = scan_.closed && joins(count - 1);
    for (std::size_t i = 0; i < count; ++i) {
      const bool joins_next = joins(i);
      if (scan_.valid(i)) add_point(i, joined, joins_next);
      if (joins_next) add_surface(i);
      joined = joins_next;
    }
    return result_.take(instant);
  }

 private:
  std::size_t next(std::size_t beam) const { return beam + 1 < beams_.size() ? beam + 1 : 0; }
  // Of the next beam, beyond this one also on the seam.
  double next_place(std::size_t beam) const {
    const bool seam = next(beam) == 0;
    return beams_[next(beam)].place + (seam ? static_cast<double>(beams_.size()) : 0.0);
  }

  // Whether this beam and the next one have hit the same surface, seen from the same side.
  bool joins(std::size_t beam) const {
    const std::size_t other = next(beam);
    if ((other == 0 && !scan_.closed) || !scan_.valid(beam) || !scan_.valid(other)) return false;
    if (next_place(beam) <= beams_[beam].place) return false;
    const double step = (beams_[other].point - beams_[beam].point).norm();
    return on_one_surface(step, std::min(scan_.ranges[beam], scan_.ranges[other]),
                          scan_.angle_increment, surface_);
  }

  // A surface ends half a beam beyond its last point.
  void add_point(std::size_t beam, bool joined, bool joins_next) {
    const double place = beams_[beam].place;
    const std::ptrdiff_t nearest = nearest_whole(place);
    const double beyond = static_cast<double>(nearest) - place;
    if ((beyond > 0.0 && joins_next) || (beyond < 0.0 && joined)) return;
    result_.offer(nearest, beams_[beam].point.norm(), beam);
  }

  // Where the beams meet the straight line between both points.
  void add_surface(std::size_t beam) {
    const MovedBeam &from = beams_[beam], &to = beams_[next(beam)];
    const double end = next_place(beam);
    const Vector2d way = to.point - from.point;
    const double distance = cross(from.point, way);
    const double middle = 0.5 * (from.place + end);
    for (std::ptrdiff_t at = whole_below(from.place) + 1; static_cast<double>(at) < end; ++at) {
      const double range = distance / cross(result_.bearing(at), way);
      result_.offer(at, range, static_cast<double>(at) < middle ? beam : next(beam));
    }
  }

  // Beams of one status side by side leave no gap.
  void keep_status(std::size_t beam) {
    const BeamStatus status = scan_.status[beam];
    const std::ptrdiff_t begin = nearest_whole(beams_[beam].place);
    const bool seam = next(beam) == 0;
    const bool goes_on = !seam && scan_.status[next(beam)] == status;
    const std::ptrdiff_t end = goes_on ? nearest_whole(next_place(beam)) : begin + 1;
    result_.mark(begin, status);
    for (std::ptrdiff_t at = begin + 1; at < end; ++at) result_.mark(at, status);
  }

  const LaserScan& scan_;
  std::vector<MovedBeam> beams_;
  const SurfaceStepParams& surface_;
  UniformScan result_;
};

}  // namespace

LaserScan deskew(const LaserScan& scan, const LaserMotion& motion, Time instant,
                 const SurfaceStepParams& surface) {
  const Eigen::Vector3d way = motion.begin_T_end.log();
  const bool at_rest = way.isZero(0.0) || motion.duration <= Duration::zero();
  if (at_rest || scan.time_increment == Duration::zero() || scan.size() < 2 ||
      !(scan.angle_increment > 0.0) || !way.allFinite()) {
    return scan;
  }
  const Eigen::Vector3d twist = way / to_seconds(motion.duration);
  return Resampling(scan, moved_beams(scan, twist, instant), surface).run(instant);
}

}  // namespace falko_slam
