// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/features/wall_end.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "falko_slam/common/validation.hpp"

namespace falko_slam {
namespace {

class WallEndSearch {
 public:
  WallEndSearch(const LaserScan& scan, const WallEndParams& params)
      : scan_(scan), params_(params), beams_(static_cast<std::ptrdiff_t>(scan.size())) {}

  // Does the wall end at `beam`, its other beams lying in the given direction (1 or -1)?
  std::optional<Keypoint> end_at(std::ptrdiff_t beam, std::ptrdiff_t direction) const {
    const auto here = valid_beam(beam);
    const auto beyond = valid_beam(beam - direction);
    if (!here || !beyond || !(scan_.ranges[*beyond] - scan_.ranges[*here] > params_.min_jump)) {
      return std::nullopt;
    }
    std::size_t last = *here;
    for (int step = 1; step <= params_.wall_steps; ++step) {
      const auto next = valid_beam(beam + direction * step);
      if (!next || !on_one_wall(last, *next)) return std::nullopt;
      last = *next;
    }
    const Eigen::Vector2d along = scan_.point(last) - scan_.point(*here);
    Keypoint end;
    end.position = scan_.point(*here);
    end.orientation = std::atan2(along.y(), along.x());
    end.radius = along.norm();
    end.beam = *here;
    return end;
  }

 private:
  std::optional<std::size_t> valid_beam(std::ptrdiff_t beam) const {
    if (scan_.closed) beam = (beam % beams_ + beams_) % beams_;
    if (beam < 0 || beam >= beams_) return std::nullopt;
    const auto index = static_cast<std::size_t>(beam);
    return scan_.valid(index) ? std::optional<std::size_t>(index) : std::nullopt;
  }

  bool on_one_wall(std::size_t a, std::size_t b) const {
    return on_one_surface((scan_.point(a) - scan_.point(b)).norm(),
                          std::min(scan_.ranges[a], scan_.ranges[b]), scan_.angle_increment,
                          params_.surface);
  }

  const LaserScan& scan_;
  const WallEndParams& params_;
  std::ptrdiff_t beams_;
};

}  // namespace

void validate(const WallEndParams& params) {
  require_in_range("min_jump", params.min_jump, 0.05, 100.0);
  require_in_range("wall_steps", params.wall_steps, 1, 100);
  validate(params.surface);
}

std::vector<Keypoint> find_wall_ends(const LaserScan& scan, const WallEndParams& params) {
  validate(params);
  const WallEndSearch search(scan, params);
  std::vector<Keypoint> ends;
  for (std::ptrdiff_t beam = 0; beam < static_cast<std::ptrdiff_t>(scan.size()); ++beam) {
    for (const std::ptrdiff_t direction : {-1, 1}) {
      if (const auto end = search.end_at(beam, direction)) ends.push_back(*end);
    }
  }
  return ends;
}

}  // namespace falko_slam
