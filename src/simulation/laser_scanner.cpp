// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/simulation/laser_scanner.hpp"

#include <algorithm>
#include <cmath>

#include "beam_echo.hpp"
#include "ray_fan.hpp"

namespace falko_slam {
namespace {

// A direction is off by no more than this many standard deviations: the fan must know its width.
constexpr double kMostNoise = 4.0;

}  // namespace

struct LaserScanner::Impl {
  LaserModel laser;
  Pose2 base_T_laser;
  const World& world;
  Time world_begin;
  BeamProfile profile = gaussian_beam();
  RayFan fan;
  std::vector<double> seconds;  // of the beams, since the world's begin
  SimulatedScan result;

  void place_beams(Time first_beam, const MotionTrack& track, std::mt19937_64& random);
  void place_rays(std::size_t beam, const Pose2& world_T_laser, double bearing);
  RayEcho echo_of(std::size_t beam) const;
  float range_of(const RayEcho& echo, std::mt19937_64& random) const;
};

// The rays leave side by side over the beam's diameter and spread by its divergence.
void LaserScanner::Impl::place_rays(std::size_t beam, const Pose2& world_T_laser, double bearing) {
  const double heading = world_T_laser.theta() + bearing;
  const Eigen::Vector2d along(std::cos(heading), std::sin(heading));
  const Eigen::Vector2d left(-along.y(), along.x());
  for (std::size_t k = 0; k < BeamProfile::kRays; ++k) {
    const std::size_t ray = beam * BeamProfile::kRays + k;
    const double aside = 0.5 * laser.beam_diameter * profile.offset[k];
    const double spread = 0.5 * laser.beam_divergence * profile.offset[k];
    const Eigen::Vector2d direction = (along + spread * left).normalized();
    fan.x[ray] = world_T_laser.x() + aside * left.x();
    fan.y[ray] = world_T_laser.y() + aside * left.y();
    fan.dx[ray] = direction.x();
    fan.dy[ray] = direction.y();
  }
}

void LaserScanner::Impl::place_beams(Time first_beam, const MotionTrack& track,
                                     std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const auto time_of = [&](double nth) {
    return first_beam + from_seconds(nth * laser.time_increment);
  };
  const double half = 0.5 * static_cast<double>(laser.beams - 1);
  fan.center = (track.at(time_of(half)) * base_T_laser).translation();
  fan.reach = 0.0;
  double heading = track.at(first_beam).theta();  // of the vehicle, not wrapped
  for (std::size_t beam = 0; beam < laser.beams; ++beam) {
    const auto nth = static_cast<double>(beam);
    const Pose2 world_T_base = track.at(time_of(nth));
    const Pose2 world_T_laser = world_T_base * base_T_laser;
    heading += angle_between(heading, world_T_base.theta());
    const double bearing = laser.angle_min + nth * laser.angle_increment;
    const double noise = std::clamp(normal(random), -kMostNoise, kMostNoise);
    seconds[beam] = to_seconds(time_of(nth) - world_begin);
    fan.bearing[beam] = heading + base_T_laser.theta() + bearing;
    fan.reach = std::max(fan.reach, (world_T_laser.translation() - fan.center).norm());
    place_rays(beam, world_T_laser, bearing + laser.bearing_noise * noise);
  }
  const double edge = profile.offset.back();
  fan.reach += 0.5 * laser.beam_diameter * edge;
  fan.bearing_margin = kMostNoise * laser.bearing_noise + 0.5 * laser.beam_divergence * edge;
}

RayEcho LaserScanner::Impl::echo_of(std::size_t beam) const {
  std::array<RayEcho, BeamProfile::kRays> bundle;
  for (std::size_t k = 0; k < BeamProfile::kRays; ++k) {
    const std::size_t ray = beam * BeamProfile::kRays + k;
    const double range = fan.range[ray];
    const bool hit = range <= laser.farthest;
    bundle[k] = {range, hit ? profile.weight[k] * fan.light[ray] / (range * range) : 0.0};
  }
  return strongest_echo(bundle, laser.echo_separation);
}

float LaserScanner::Impl::range_of(const RayEcho& echo, std::mt19937_64& random) const {
  const double noise = std::normal_distribution<double>()(random);
  const bool dropped = std::uniform_real_distribution<double>()(random) < laser.drop_out;
  const double weakest = weakest_power(laser);
  if (dropped || echo.power < weakest || echo.range < laser.nearest) return 0.0F;
  double range = echo.range + laser.range_noise * std::sqrt(1.0 + weakest / echo.power) * noise;
  if (laser.range_step > 0.0) range = laser.range_step * std::round(range / laser.range_step);
  return range > 0.0 && range <= laser.farthest ? static_cast<float>(range) : 0.0F;
}

LaserScanner::LaserScanner(const LaserModel& laser, const Pose2& base_T_laser, const World& world,
                           Time world_begin)
    : impl_(new Impl{laser, base_T_laser, world, world_begin, gaussian_beam(), {}, {}, {}}) {
  validate(laser);
  impl_->fan.rays_per_beam = BeamProfile::kRays;
  impl_->seconds.resize(laser.beams);
}
LaserScanner::~LaserScanner() = default;
LaserScanner::LaserScanner(LaserScanner&&) noexcept = default;
LaserScanner& LaserScanner::operator=(LaserScanner&&) noexcept = default;

const LaserModel& LaserScanner::laser() const { return impl_->laser; }

const SimulatedScan& LaserScanner::scan(Time first_beam, const MotionTrack& track,
                                        std::mt19937_64& random) {
  Impl& impl = *impl_;
  SimulatedScan& result = impl.result;
  impl.fan.resize(impl.laser.beams);
  impl.place_beams(first_beam, track, random);
  cast(impl.world.fixed, impl.world.surfaces, impl.fan);
  for (const Body& body : impl.world.bodies) {
    cast(body, impl.world.surfaces, impl.seconds, impl.fan);
  }
  result.first_beam = first_beam;
  result.ranges.resize(impl.laser.beams);
  result.intensities.resize(impl.laser.intensities ? impl.laser.beams : 0);
  for (std::size_t beam = 0; beam < impl.laser.beams; ++beam) {
    const RayEcho echo = impl.echo_of(beam);
    const float range = impl.range_of(echo, random);
    result.ranges[beam] = range;
    if (impl.laser.intensities) {
      result.intensities[beam] = range > 0.0F ? intensity_of(impl.laser, echo.power) : 0.0F;
    }
  }
  return result;
}

RawScan as_raw_scan(const LaserModel& laser, const SimulatedScan& scan) {
  RawScan raw;
  raw.stamp = scan.first_beam;
  raw.angle_min = laser.angle_min;
  raw.angle_increment = laser.angle_increment;
  raw.angle_max = laser.angle_min + static_cast<double>(laser.beams) * laser.angle_increment;
  raw.time_increment = laser.time_increment;
  raw.scan_time = laser.scan_period;
  raw.range_min = laser.stated_range_min;
  raw.range_max = laser.stated_range_max;
  raw.ranges = scan.ranges.data();
  raw.range_count = scan.ranges.size();
  raw.intensities = scan.intensities.data();
  raw.intensity_count = scan.intensities.size();
  return raw;
}

std::vector<Cylinder> reflectors_of(const World& world) {
  std::vector<Cylinder> reflectors;
  for (const Cylinder& cylinder : world.fixed.cylinders) {
    if (world.surfaces[cylinder.surface].retro_gain > 0.0) reflectors.push_back(cylinder);
  }
  return reflectors;
}

double diameter_of_reflectors(const World& world) {
  const std::vector<Cylinder> reflectors = reflectors_of(world);
  return reflectors.empty() ? 0.08 : 2.0 * reflectors.front().radius;
}

}  // namespace falko_slam
