// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ordinary_beams.hpp"

#include <algorithm>
#include <cmath>

#include "falko_slam/sensor/surface_step.hpp"
#include "reflector_search.hpp"

namespace falko_slam {
namespace {

constexpr float kTypical = 0.5F;  // quantiles of what ordinary surfaces send back
constexpr float kBrightest = 0.98F;
constexpr std::size_t kBeside = 2;  // beams at the rim of a reflector are not ordinary either

bool on_one_surface(const LaserScan& scan, std::size_t a, std::size_t b) {
  const double nearer = std::min(scan.ranges[a], scan.ranges[b]);
  return on_one_surface(std::abs(scan.ranges[a] - scan.ranges[b]), nearer, scan.angle_increment,
                        SurfaceStepParams());
}

}  // namespace

void OrdinaryBeams::count(std::size_t beam, bool as_ordinary) {
  if ((counted_[beam] != 0) == as_ordinary) return;
  counted_[beam] = as_ordinary ? 1 : 0;
  intensity_.add(cells_[beam], as_ordinary ? 1.0F : -1.0F);
}

// Of the runs those that are no wider than a reflector.
void OrdinaryBeams::leave_out(const LaserScan& scan, const ReflectorDetectorParams& params) {
  for (const BeamRun& run : runs_) {
    if (!may_be_reflector(scan, run, params)) continue;
    for (std::size_t i = 0; i < run.count; ++i) count((run.first + i) % scan.size(), false);
  }
}

// What is as narrow as a reflector may be one: narrow things first, then what stands out of its
// surroundings.
void OrdinaryBeams::learn(const LaserScan& scan, const ReflectorDetectorParams& params) {
  const auto keep = static_cast<float>(params.memory);
  intensity_.fade(params.memory > 0 ? keep / (keep + 1.0F) : 0.0F);
  cells_.resize(scan.size());
  counted_.assign(scan.size(), 0);
  for (std::size_t i = 0; i < scan.size(); ++i) {
    if (!scan.valid(i)) continue;
    cells_[i] = OrdinaryIntensity::cell_of(scan.ranges[i], scan.intensities[i]);
    count(i, true);
  }
  const auto joined = [&](std::size_t a, std::size_t b) { return on_one_surface(scan, a, b); };
  find_runs(
      scan, [&](std::size_t i) { return scan.valid(i); }, joined, runs_);
  leave_out(scan, params);
  intensity_.settle(kTypical);
  const auto contrast = static_cast<float>(params.contrast);
  const auto stands_out = [&](std::size_t i) {
    return scan.valid(i) && scan.intensities[i] > contrast * intensity_.level(cells_[i]);
  };
  find_runs(scan, stands_out, joined, runs_);
  leave_out(scan, params);
  intensity_.settle(kBrightest);
}

// From now on the rest is ordinary.
void OrdinaryBeams::learn_all_but(const LaserScan& scan,
                                  const std::vector<DetectedReflector>& reflectors) {
  for (std::size_t i = 0; i < scan.size(); ++i) {
    if (scan.valid(i)) count(i, true);
  }
  for (const DetectedReflector& reflector : reflectors) {
    const std::size_t beams = scan.size();
    const std::size_t span = (reflector.last_beam + beams - reflector.first_beam) % beams + 1;
    for (std::size_t i = 0; i < std::min(span + 2 * kBeside, beams); ++i) {
      const std::size_t beam = (reflector.first_beam + beams - kBeside % beams + i) % beams;
      if (scan.valid(beam)) count(beam, false);
    }
  }
}

}  // namespace falko_slam
