// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/features/reflector_detector.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "ordinary_beams.hpp"
#include "reflector_search.hpp"

namespace falko_slam {
namespace {

constexpr std::size_t kEnoughBeams = 20;  // a few may be equal by chance

IntensityFault fault_of(const LaserScan& scan) {
  if (scan.size() > 0 && scan.intensities.empty()) return IntensityFault::kMissing;
  float least = std::numeric_limits<float>::infinity(), most = -least;
  std::size_t valid = 0;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    if (!scan.valid(i)) continue;
    ++valid;
    if (std::isnan(scan.intensities[i])) continue;
    least = std::min(least, scan.intensities[i]);
    most = std::max(most, scan.intensities[i]);
  }
  if (valid == 0) return IntensityFault::kNone;
  if (least > most) return IntensityFault::kMissing;
  if (most <= 0.0F) return IntensityFault::kAllZero;
  const bool same = least == most && valid >= kEnoughBeams;
  return same ? IntensityFault::kAllTheSame : IntensityFault::kNone;
}

}  // namespace

struct ReflectorDetector::Workspace {
  OrdinaryBeams ordinary;
  std::vector<float> edge;
  std::vector<char> bright;
  std::vector<BeamRun> runs;
  std::vector<BrightBeam> run_beams;

  void set_edge(const LaserScan& scan, const ReflectorDetector& detector);
  void mark_bright(const LaserScan& scan, const ReflectorDetectorParams& params);
  void find_bright_runs(const LaserScan& scan, double step);
};

// Halfway between ordinary and threshold, as factors go.
void ReflectorDetector::Workspace::set_edge(const LaserScan& scan,
                                            const ReflectorDetector& detector) {
  const double share = 1.0 / std::sqrt(detector.params().contrast);
  edge.assign(scan.size(), 0.0F);
  for (std::size_t i = 0; i < scan.size(); ++i) {
    if (scan.valid(i)) edge[i] = static_cast<float>(share * detector.threshold(scan.ranges[i]));
  }
}

// A single beam without an echo between two bright ones counts as bright.
void ReflectorDetector::Workspace::mark_bright(const LaserScan& scan,
                                               const ReflectorDetectorParams& params) {
  const std::size_t beams = scan.size();
  bright.assign(beams, 0);
  for (std::size_t i = 0; i < beams; ++i) {
    bright[i] =
        scan.valid(i) && scan.ranges[i] <= params.max_range && scan.intensities[i] > edge[i];
  }
  for (std::size_t i = 0; i < beams; ++i) {
    if (scan.valid(i) || (!scan.closed && (i == 0 || i + 1 == beams))) continue;
    const std::size_t before = i == 0 ? beams - 1 : i - 1, after = i + 1 == beams ? 0 : i + 1;
    const bool between = bright[before] && bright[after] && scan.valid(before) && scan.valid(after);
    bright[i] =
        between && std::abs(scan.ranges[before] - scan.ranges[after]) <= reflector_step(params);
  }
}

void ReflectorDetector::Workspace::find_bright_runs(const LaserScan& scan, double step) {
  find_runs(
      scan, [&](std::size_t i) { return bright[i] != 0; },
      [&](std::size_t a, std::size_t b) {  // also where one of them has no echo
        return !(std::abs(scan.ranges[a] - scan.ranges[b]) > step);
      },
      runs);
}

ReflectorDetector::ReflectorDetector(const ReflectorDetectorParams& params) : params_(params) {
  validate(params);
  workspace_ = std::make_unique<Workspace>();
}
ReflectorDetector::~ReflectorDetector() = default;
ReflectorDetector::ReflectorDetector(ReflectorDetector&&) noexcept = default;
ReflectorDetector& ReflectorDetector::operator=(ReflectorDetector&&) noexcept = default;

double ReflectorDetector::threshold(double range) const {
  if (params_.threshold > 0.0) {
    return params_.threshold * std::pow(range, -params_.threshold_falloff);
  }
  return params_.contrast * static_cast<double>(workspace_->ordinary.brightest(range));
}

ReflectorReport ReflectorDetector::detect(const LaserScan& scan,
                                          std::vector<DetectedReflector>& reflectors) {
  reflectors.clear();
  ReflectorReport report;
  report.fault = fault_of(scan);
  if (report.fault != IntensityFault::kNone || scan.size() == 0) return report;
  Workspace& work = *workspace_;
  const bool given = params_.threshold > 0.0;
  if (!given) work.ordinary.learn(scan, params_);
  report.nothing_to_compare = !given && !work.ordinary.known();
  work.set_edge(scan, *this);
  work.mark_bright(scan, params_);
  work.find_bright_runs(scan, reflector_step(params_));
  ReflectorSearch search(scan, params_, work.run_beams, report, reflectors);
  for (const BeamRun& run : work.runs) search.judge(run, work.edge);
  if (!given) work.ordinary.learn_all_but(scan, reflectors);
  return report;
}

std::vector<DetectedReflector> ReflectorDetector::detect(const LaserScan& scan) {
  std::vector<DetectedReflector> reflectors;
  const ReflectorReport report = detect(scan, reflectors);
  if (report.fault != IntensityFault::kNone) throw std::runtime_error(describe(report.fault));
  return reflectors;
}

}  // namespace falko_slam
