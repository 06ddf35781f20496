// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/mean_scan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace falko_slam {
namespace {

struct BeamSum {
  double count = 0.0, mean = 0.0, squares = 0.0;

  void add(double range) {
    ++count;
    const double before = range - mean;
    mean += before / count;
    squares += before * (range - mean);
  }
  double variance() const { return squares / (count - 1.0); }
};

double median_variance(const std::vector<BeamSum>& beams) {
  std::vector<double> variances;
  for (const BeamSum& beam : beams) {
    if (beam.count >= 2.0) variances.push_back(beam.variance());
  }
  if (variances.empty()) return 0.0;
  const auto middle = variances.begin() + static_cast<std::ptrdiff_t>(variances.size() / 2);
  std::nth_element(variances.begin(), middle, variances.end());
  return *middle;
}

void forget(LaserScan& scan, std::size_t beam) {
  scan.ranges[beam] = std::numeric_limits<double>::quiet_NaN();
  if (scan.valid(beam)) scan.status[beam] = BeamStatus::kErroneous;
}

}  // namespace

MeanScan mean_of(const std::vector<LaserScan>& scans) {
  constexpr double kWild = 25.0;  // of a variance
  MeanScan mean;
  if (scans.empty()) return mean;
  mean.scan = scans.front();
  std::vector<BeamSum> beams(mean.scan.size());
  for (const LaserScan& scan : scans) {
    if (scan.size() != beams.size()) continue;
    ++mean.scans;
    for (std::size_t i = 0; i < beams.size(); ++i) {
      if (scan.valid(i)) beams[i].add(scan.ranges[i]);
    }
  }
  const double usual = median_variance(beams);
  double squares = 0.0, freedom = 0.0;
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const BeamSum& beam = beams[i];
    const bool wild = beam.count >= 2.0 && usual > 0.0 && beam.variance() > kWild * usual;
    if (beam.count == 0.0 || 2.0 * beam.count < static_cast<double>(mean.scans) || wild) {
      forget(mean.scan, i);
      continue;
    }
    mean.scan.ranges[i] = beam.mean;
    mean.scan.status[i] = BeamStatus::kValid;
    squares += beam.squares;
    freedom += beam.count - 1.0;
  }
  mean.range_noise = freedom > 0.0 ? std::sqrt(squares / freedom) : 0.0;
  return mean;
}

}  // namespace falko_slam
