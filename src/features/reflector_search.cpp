// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "reflector_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "falko_slam/geometry/angles.hpp"
#include "reflector_center.hpp"
#include "reflector_face.hpp"

namespace falko_slam {
namespace {

constexpr double kRunEnd = 0.1;        // of the peak: darker beams at the ends are left out
constexpr double kValleyDepth = 1.4;   // of the lesser peak over what lies between
constexpr std::size_t kLongest = 256;  // beams that are searched for valleys
constexpr int kMayHide = 2;            // beams that are looked at for what hides a reflector

std::size_t wrapped(std::ptrdiff_t beam, std::size_t beams) {
  const auto count = static_cast<std::ptrdiff_t>(beams);
  return static_cast<std::size_t>((beam % count + count) % count);
}

Eigen::Matrix2d covariance_of(double bearing, double along, double across) {
  Eigen::Matrix2d turn;
  turn << std::cos(bearing), -std::sin(bearing), std::sin(bearing), std::cos(bearing);
  return turn * Eigen::Vector2d(along * along, across * across).asDiagonal() * turn.transpose();
}

}  // namespace

double reflector_step(const ReflectorDetectorParams& params) {
  return 0.5 * params.diameter + 6.0 * params.range_noise;
}

bool may_be_reflector(const LaserScan& scan, const BeamRun& run,
                      const ReflectorDetectorParams& params) {
  const double range = scan.ranges[run.first];
  const double spacing = range * scan.angle_increment;
  const double width = static_cast<double>(run.count) * spacing;
  return width <= params.diameter + 2.0 * footprint(params, range) + 2.0 * spacing;
}

void ReflectorSearch::judge(const BeamRun& run, const std::vector<float>& edge) {
  first_ = run.first;
  beams_.clear();
  for (std::size_t i = 0; i < run.count; ++i) {
    const std::size_t beam = (run.first + i) % scan_.size();
    const float above = scan_.intensities[beam] - edge[beam];
    beams_.push_back({scan_.valid(beam) ? std::max(0.0, static_cast<double>(above)) : 0.0,
                      scan_.valid(beam) ? scan_.ranges[beam] : std::nan(""), edge[beam]});
  }
  for (std::size_t i = 1; i + 1 < beams_.size(); ++i) {
    if (std::isnan(beams_[i].range)) {
      beams_[i].excess = 0.5 * (beams_[i - 1].excess + beams_[i + 1].excess);
    }
  }
  judge_part(0, beams_.size());
}

bool ReflectorSearch::split(std::size_t begin, std::size_t count) {
  if (count > kLongest) return false;
  const std::size_t valley = valley_of(&beams_[begin], count, kValleyDepth);
  if (valley == count) return false;
  judge_part(begin, valley + 1);
  judge_part(begin + valley, count - valley);
  return true;
}

void ReflectorSearch::judge_part(std::size_t begin, std::size_t count) {
  const double ratio = std::sqrt(params_.contrast);  // of the threshold to the edge
  double peak = 0.0;
  bool bright = false;
  for (std::size_t i = begin; i < begin + count; ++i) {
    const BrightBeam& beam = beams_[i];
    peak = std::max(peak, beam.excess);
    bright = bright || (!std::isnan(beam.range) && beam.excess > (ratio - 1.0) * beam.edge);
  }
  if (!bright) return;
  while (beams_[begin].excess < kRunEnd * peak) ++begin, --count;
  while (beams_[begin + count - 1].excess < kRunEnd * peak) --count;
  const BrightProfile profile = profile_of(&beams_[begin], count);
  const double spacing = profile.range * scan_.angle_increment;
  const double width = profile.half_width() * spacing;
  if (width > params_.diameter + footprint(params_, profile.range) + spacing) {
    if (!split(begin, count)) refuse(ReflectorRefusal::kTooWide);
    return;
  }
  if (width < params_.min_visible * params_.diameter - spacing) {
    return refuse(ReflectorRefusal::kTooNarrow);
  }
  add_reflector(begin, count, profile);
}

// Whether something nearer, or nothing at all, lies just beyond `beam`.
bool ReflectorSearch::hides(std::ptrdiff_t beam, std::ptrdiff_t direction, double range) const {
  const auto beams = static_cast<std::ptrdiff_t>(scan_.size());
  for (int i = 1; i <= kMayHide; ++i) {
    const std::ptrdiff_t beyond = beam + i * direction;
    if (!scan_.closed && (beyond < 0 || beyond >= beams)) return i == 1;
    const std::size_t index = wrapped(beyond, scan_.size());
    if (scan_.valid(index) && scan_.ranges[index] < range - reflector_step(params_)) return true;
  }
  return false;
}

void ReflectorSearch::add_reflector(std::size_t begin, std::size_t count,
                                    const BrightProfile& profile) {
  const auto first = static_cast<std::ptrdiff_t>(first_ + begin);
  const std::ptrdiff_t last = first + static_cast<std::ptrdiff_t>(count) - 1;
  const HiddenSides hidden = {hides(first, -1, profile.range), hides(last, 1, profile.range)};
  DetectedReflector found;
  for (std::size_t i = begin; i < begin + count; ++i) {
    if (std::isnan(beams_[i].range)) continue;
    const auto intensity = static_cast<double>(scan_.intensities[(first_ + i) % scan_.size()]);
    ++found.hits;
    found.mean_intensity += intensity;
    found.peak_intensity = std::max(found.peak_intensity, intensity);
  }
  if (found.hits < static_cast<std::size_t>(params_.min_hits)) {
    return refuse(ReflectorRefusal::kTooFewBeams);
  }
  found.mean_intensity /= static_cast<double>(found.hits);
  found.first_beam = wrapped(first, scan_.size());
  found.last_beam = wrapped(last, scan_.size());
  const ReflectorCenter center =
      center_of(params_, &beams_[begin], count, profile, hidden, scan_.angle_increment);
  found.partly_hidden = center.hidden;
  const double beam = static_cast<double>(first) + center.beam;
  const double bearing = scan_.angle_min + beam * scan_.angle_increment;
  found.center = center.range * Eigen::Vector2d(std::cos(bearing), std::sin(bearing));
  found.covariance = covariance_of(bearing, center.along, center.across);
  const auto beams = static_cast<double>(scan_.size());
  found.middle_beam = std::clamp(beam, 0.0, beams - 1.0);
  if (scan_.closed) found.middle_beam = beam < beams ? beam : beam - beams;
  found.time =
      scan_.first_beam_time +
      Duration(std::llround(found.middle_beam * static_cast<double>(scan_.time_increment.count())));
  found_.push_back(found);
}

}  // namespace falko_slam
