// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ray_fan.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "beam_echo.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

constexpr double kCorner = 1e-9;    // faces that share a corner leave no gap [of their length]
constexpr double kRounding = 1e-4;  // of approximate_atan2 and of all else [rad]

double distance_to(const Face& face, const Eigen::Vector2d& point) {
  const Eigen::Vector2d along = face.to - face.from;
  const double length2 = along.squaredNorm();
  const double share = length2 > 0.0 ? (point - face.from).dot(along) / length2 : 0.0;
  return (face.from + std::clamp(share, 0.0, 1.0) * along - point).norm();
}

double bearing_of(const Eigen::Vector2d& direction) {
  return approximate_atan2(direction.y(), direction.x());
}

// Where in a fan the beams are that look into a range of bearings. They are nearly evenly spread:
// how nearly is found out once.
class BeamFinder {
 public:
  explicit BeamFinder(const RayFan& fan) : fan_(fan) {
    const std::size_t beams = fan.beams();
    if (beams < 2) return;
    const double span = fan.bearing.back() - fan.bearing.front();
    increment_ = span / static_cast<double>(beams - 1);
    for (std::size_t i = 0; i < beams; ++i) {
      const double even = fan.bearing.front() + static_cast<double>(i) * increment_;
      margin_ = std::max(margin_, std::abs(fan.bearing[i] - even));
    }
    margin_ += fan.bearing_margin + kRounding;
  }

  // Calls use(begin, end) with the rays of these beams, wherever a turn puts them, none twice.
  template <class Use>
  void for_rays_between(double from, double to, const Use& use) const {
    if (!(increment_ > 0.0)) return use(0, fan_.beams() * fan_.rays_per_beam);
    const double first = fan_.bearing.front() + margin_;
    const double last = fan_.bearing.back() + margin_;
    double done = 0.0;  // beams
    for (double shift = kTwoPi * std::ceil((first - 2.0 * margin_ - to) / kTwoPi);
         from + shift <= last; shift += kTwoPi) {
      const double begin = std::max(done, std::ceil((from + shift - first) / increment_));
      const double end = std::floor((to + shift + margin_ - fan_.bearing.front()) / increment_);
      done = std::clamp(end + 1.0, done, static_cast<double>(fan_.beams()));
      if (begin >= done) continue;
      use(static_cast<std::size_t>(begin) * fan_.rays_per_beam,
          static_cast<std::size_t>(done) * fan_.rays_per_beam);
    }
  }

 private:
  const RayFan& fan_;
  double increment_ = 0.0;  // [rad]
  double margin_ = 0.0;     // [rad]
};

// Not less than asin(reach / distance), for a reach below the distance.
double widest_turn(double reach, double distance) { return 0.5 * kPi * reach / distance; }

// Two rays at once; comparisons give masks, `mask ? a : b` chooses by lane. An extension of GCC and
// Clang.
using Lanes = double __attribute__((vector_size(2 * sizeof(double))));

Lanes load(const std::vector<double>& numbers, std::size_t i) {
  Lanes lanes;
  std::memcpy(&lanes, &numbers[i], sizeof lanes);
  return lanes;
}

void store(const Lanes& lanes, std::vector<double>& numbers, std::size_t i) {
  std::memcpy(&numbers[i], &lanes, sizeof lanes);
}

// May try a ray more on either side: the arrays have room for pairs.
void hit_face(const Face& face, double target, RayFan& fan, std::size_t begin, std::size_t end) {
  const double ax = face.from.x(), ay = face.from.y();
  const double vx = face.to.x() - ax, vy = face.to.y() - ay;
  for (std::size_t i = begin - begin % 2; i < end; i += 2) {
    const Lanes dx = load(fan.dx, i), dy = load(fan.dy, i);
    const Lanes to_x = ax - load(fan.x, i), to_y = ay - load(fan.y, i);
    const Lanes scale = 1.0 / (dx * vy - dy * vx);
    const Lanes distance = (to_x * vy - to_y * vx) * scale;
    const Lanes share = (to_x * dy - to_y * dx) * scale;
    const Lanes range = load(fan.range, i);
    const auto closer =
        (distance > 0.0) & (share >= -kCorner) & (share <= 1.0 + kCorner) & (distance < range);
    store(closer ? distance : range, fan.range, i);
    store(closer ? Lanes{target, target} : load(fan.target, i), fan.target, i);
  }
}

void hit_cylinder(const Cylinder& cylinder, double target, RayFan& fan, std::size_t begin,
                  std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    const double to_x = cylinder.center.x() - fan.x[i], to_y = cylinder.center.y() - fan.y[i];
    const double along = to_x * fan.dx[i] + to_y * fan.dy[i];
    const double beside = to_x * fan.dy[i] - to_y * fan.dx[i];
    const double half_chord2 = cylinder.radius * cylinder.radius - beside * beside;
    if (half_chord2 < 0.0) continue;
    const double distance = along - std::sqrt(half_chord2);
    if (distance <= 0.0 || distance >= fan.range[i]) continue;
    fan.range[i] = distance;
    fan.target[i] = target;
  }
}

void cast_face(const Face& face, double target, const BeamFinder& beams, RayFan& fan) {
  const auto hit = [&](std::size_t begin, std::size_t end) {
    hit_face(face, target, fan, begin, end);
  };
  // From a begin that may lie on its other side it may be seen anywhere.
  if (distance_to(face, fan.center) <= fan.reach) return hit(0, fan.x.size());
  const Eigen::Vector2d from = face.from - fan.center;
  const Eigen::Vector2d to = face.to - fan.center;
  const double from_bearing = bearing_of(from);
  const double turn = angle_between(from_bearing, bearing_of(to));
  const double from_margin = widest_turn(fan.reach, from.norm());
  const double to_margin = widest_turn(fan.reach, to.norm());
  beams.for_rays_between(std::min(from_bearing - from_margin, from_bearing + turn - to_margin),
                         std::max(from_bearing + from_margin, from_bearing + turn + to_margin),
                         hit);
}

void cast_cylinder(const Cylinder& cylinder, double target, const BeamFinder& beams, RayFan& fan) {
  const auto hit = [&](std::size_t begin, std::size_t end) {
    hit_cylinder(cylinder, target, fan, begin, end);
  };
  const Eigen::Vector2d to = cylinder.center - fan.center;
  const double width = cylinder.radius + fan.reach;
  if (to.norm() <= width) return hit(0, fan.x.size());
  const double half = widest_turn(width, to.norm());
  const double middle = bearing_of(to);
  beams.for_rays_between(middle - half, middle + half, hit);
}

double cosine_at(const Face& face, const RayFan& fan, std::size_t ray) {
  const Eigen::Vector2d along = face.to - face.from;
  return std::abs(fan.dx[ray] * along.y() - fan.dy[ray] * along.x()) / along.norm();
}

double cosine_at(const Cylinder& cylinder, const RayFan& fan, std::size_t ray) {
  const Eigen::Vector2d direction(fan.dx[ray], fan.dy[ray]);
  const Eigen::Vector2d point =
      Eigen::Vector2d(fan.x[ray], fan.y[ray]) + fan.range[ray] * direction;
  return std::abs(direction.dot(point - cylinder.center)) / cylinder.radius;
}

// The light of the rays that met the shape, which are not marked any longer then.
void light_up(const Shape& shape, const std::vector<Surface>& surfaces, RayFan& fan) {
  const std::size_t faces = shape.faces.size();
  for (std::size_t ray = 0; ray < fan.target.size(); ++ray) {
    if (fan.target[ray] == RayFan::kNone) continue;
    const auto target = static_cast<std::size_t>(fan.target[ray]);
    const auto light = [&](const auto& thing) {
      return returned_light(surfaces[thing.surface], cosine_at(thing, fan, ray));
    };
    fan.light[ray] =
        target < faces ? light(shape.faces[target]) : light(shape.cylinders[target - faces]);
    fan.target[ray] = RayFan::kNone;
  }
}

}  // namespace

void RayFan::resize(std::size_t beams) {
  const std::size_t rays = beams * rays_per_beam;
  const std::size_t pairs = rays + rays % 2;
  bearing.resize(beams);
  for (std::vector<double>* of_rays : {&x, &y, &dx, &dy}) of_rays->resize(pairs);
  range.assign(pairs, std::numeric_limits<double>::infinity());
  light.assign(pairs, 0.0);
  target.assign(pairs, kNone);
}

void cast(const Shape& shape, const std::vector<Surface>& surfaces, RayFan& fan) {
  const BeamFinder beams(fan);
  double target = 0.0;
  for (const Face& face : shape.faces) cast_face(face, target++, beams, fan);
  for (const Cylinder& cylinder : shape.cylinders) cast_cylinder(cylinder, target++, beams, fan);
  light_up(shape, surfaces, fan);
}

}  // namespace falko_slam
