// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/scan_perturbation.hpp"

#include <algorithm>
#include <limits>

namespace falko_slam {
namespace {

constexpr double kMinRange = 1e-3;

// As `scan` without beams, intensities and beam times.
LaserScan empty_copy(const LaserScan& scan) {
  LaserScan copy;
  copy.first_beam_time = scan.first_beam_time;
  copy.angle_min = scan.angle_min;
  copy.angle_increment = scan.angle_increment;
  copy.range_max = scan.range_max;
  copy.closed = scan.closed;
  return copy;
}

void append(LaserScan& scan, double range, BeamStatus status) {
  scan.ranges.push_back(range);
  scan.status.push_back(status);
}

}  // namespace

LaserScan with_noise(const LaserScan& scan, double standard_deviation, std::mt19937_64& random) {
  LaserScan noisy = scan;
  std::normal_distribution<double> noise;
  for (std::size_t i = 0; i < noisy.size(); ++i) {
    if (noisy.valid(i)) {
      noisy.ranges[i] = std::max(kMinRange, noisy.ranges[i] + standard_deviation * noise(random));
    }
  }
  return noisy;
}

LaserScan subsampled(const LaserScan& scan, std::size_t removed) {
  LaserScan sparse = empty_copy(scan);
  sparse.angle_increment *= static_cast<double>(removed + 1);
  sparse.closed = scan.closed && scan.size() % (removed + 1) == 0;
  for (std::size_t i = 0; i < scan.size(); i += removed + 1) {
    append(sparse, scan.ranges[i], scan.status[i]);
  }
  return sparse;
}

LaserScan oversampled(const LaserScan& scan, std::size_t added) {
  LaserScan dense = empty_copy(scan);
  dense.angle_increment /= static_cast<double>(added + 1);
  for (std::size_t i = 0; i < scan.size(); ++i) {
    append(dense, scan.ranges[i], scan.status[i]);
    const std::size_t next = (i + 1) % scan.size();
    if (next == 0 && !scan.closed) break;
    const bool valid = scan.valid(i) && scan.valid(next);
    for (std::size_t k = 1; k <= added; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(added + 1);
      append(dense, (1.0 - share) * scan.ranges[i] + share * scan.ranges[next],
             valid ? BeamStatus::kValid : BeamStatus::kErroneous);
    }
  }
  return dense;
}

LaserScan with_start_angle_turned(const LaserScan& scan, double angle) {
  LaserScan turned = scan;
  turned.angle_min += angle;
  return turned;
}

LaserScan with_beams_rotated(const LaserScan& scan, std::size_t beams) {
  LaserScan rotated = scan;
  const auto rotate = [&](auto& values) {
    if (values.empty()) return;
    const auto by = static_cast<std::ptrdiff_t>(beams % values.size());
    std::rotate(values.begin(), values.begin() + by, values.end());
  };
  rotate(rotated.ranges);
  rotate(rotated.status);
  rotate(rotated.intensities);
  return rotated;
}

}  // namespace falko_slam
