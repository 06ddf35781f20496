// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "reflector_run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include "console.hpp"
#include "falko_slam/ros_bridge/scan_recording.hpp"

namespace falko_slam {
namespace cli {
namespace {

// What a run has seen so far.
struct ReflectorTally {
  std::size_t scans = 0;
  std::size_t unusable = 0;
  std::size_t faults = 0;
  IntensityFault fault = IntensityFault::kNone;  // the last one
  std::size_t nothing_to_compare = 0;            // scans
  std::size_t reflectors = 0;
  std::array<std::size_t, kReflectorRefusalCount> refused{};
  std::vector<double> microseconds;
  nlohmann::json list = nlohmann::json::array();
};

nlohmann::json json_of(const DetectedReflector& reflector, const LaserScan& scan, Time stamp) {
  const Eigen::Vector2d& center = reflector.center;
  const Eigen::Matrix2d& covariance = reflector.covariance;
  return {{"x", center.x()},
          {"y", center.y()},
          {"range", center.norm()},
          {"bearing", std::atan2(center.y(), center.x())},
          {"covariance", {covariance(0, 0), covariance(0, 1), covariance(1, 1)}},
          {"hits", reflector.hits},
          {"first_index", scan.message_index(reflector.first_beam)},
          {"last_index", scan.message_index(reflector.last_beam)},
          {"mean_intensity", reflector.mean_intensity},
          {"peak_intensity", reflector.peak_intensity},
          {"partly_hidden", reflector.partly_hidden},
          {"time_offset", to_seconds(reflector.time - stamp)}};
}

// Keeps its memory between scans.
class ReflectorRun {
 public:
  explicit ReflectorRun(const ReflectorRunOptions& options)
      : options_(options), detector_(options.detector) {}

  void take(const RawScan& raw) {
    const auto begin = std::chrono::steady_clock::now();
    const ScanReport usable = normalize(raw, options_.scan, scan_);
    const ReflectorReport report = detector_.detect(scan_, found_);
    const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - begin;
    ++tally.scans;
    tally.microseconds.push_back(time.count());
    if (!usable.usable()) ++tally.unusable;
    if (report.fault != IntensityFault::kNone) {
      ++tally.faults;
      tally.fault = report.fault;
    }
    if (report.nothing_to_compare) ++tally.nothing_to_compare;
    tally.reflectors += found_.size();
    for (std::size_t i = 0; i < kReflectorRefusalCount; ++i) tally.refused[i] += report.refused[i];
    if (!options_.json.empty()) add_json(raw.stamp);
  }

  const ReflectorDetector& detector() const { return detector_; }

  ReflectorTally tally;

 private:
  void add_json(Time stamp) {
    nlohmann::json reflectors = nlohmann::json::array();
    for (const DetectedReflector& reflector : found_) {
      reflectors.push_back(json_of(reflector, scan_, stamp));
    }
    tally.list.push_back(
        {{"stamp", to_seconds(stamp.time_since_epoch())}, {"reflectors", reflectors}});
  }

  const ReflectorRunOptions& options_;
  ReflectorDetector detector_;
  LaserScan scan_;
  std::vector<DetectedReflector> found_;
};

void print_times(std::vector<double> times) {
  double sum = 0.0;
  for (const double time : times) sum += time;
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  std::printf("normalise, detect: %.1f us per scan, median %.1f us\n",
              sum / static_cast<double>(times.size()), *middle);
}

void print(const ReflectorTally& tally, const ReflectorDetector& detector) {
  const auto refused = [&](ReflectorRefusal why) {
    return tally.refused[static_cast<std::size_t>(why)];
  };
  std::printf("%zu scans, %zu of them unusable\n", tally.scans, tally.unusable);
  if (tally.faults > 0) {
    std::printf("%zu scans: %s\n", tally.faults, describe(tally.fault).c_str());
  }
  std::printf("%zu reflectors, %.2f per scan\n", tally.reflectors,
              static_cast<double>(tally.reflectors) / static_cast<double>(tally.scans));
  std::printf("bright, but none: %zu too wide, %zu too narrow, %zu seen by too few beams\n",
              refused(ReflectorRefusal::kTooWide), refused(ReflectorRefusal::kTooNarrow),
              refused(ReflectorRefusal::kTooFewBeams));
  if (tally.nothing_to_compare > 0) {
    std::printf("%zu scans show no ordinary surface: all that is as wide as a reflector counts\n",
                tally.nothing_to_compare);
  }
  std::printf("threshold at the end:");
  for (const double range : {1.0, 2.0, 5.0, 10.0, 20.0}) {
    std::printf(" %.0f at %.0f m%s", detector.threshold(range), range, range < 20.0 ? "," : "\n");
  }
  print_times(tally.microseconds);
}

}  // namespace

void detect_reflectors(const ReflectorRunOptions& options) {
  ReflectorRun run(options);
  std::string read;
  {
    Progress progress("scans");
    read = read_scans(options.recording, options.topic, [&](const RawScan& raw) {
      run.take(raw);
      progress.step();
    });
  }
  const ReflectorTally& tally = run.tally;
  if (tally.faults > 0 && tally.faults + tally.unusable == tally.scans) {
    throw std::runtime_error(options.recording + ": " + describe(tally.fault));
  }
  if (options.json != "-") {
    std::printf("%s: %s\n", options.recording.c_str(), read.c_str());
    print(tally, run.detector());
    std::printf("%s\n", describe_resources().c_str());
  }
  if (!options.json.empty()) write_json(options.json, tally.list);
}

}  // namespace cli
}  // namespace falko_slam
