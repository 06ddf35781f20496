// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "console.hpp"
#include "falko_slam/features/feature_extractor.hpp"
#include "falko_slam/ros_bridge/scan_recording.hpp"
#include "reflector_run.hpp"

namespace falko_slam {
namespace cli {
namespace {

struct DetectOptions {
  std::string recording;
  std::string topic;
  std::string json;
  FeatureExtractorParams params;
  bool reflectors = false;
  bool flat = false;
  ReflectorDetectorParams detector;
};

// What a run has seen so far.
struct KeypointTally {
  std::size_t scans = 0;
  std::size_t unusable = 0;
  std::size_t keypoints = 0;
  std::array<std::size_t, kBeamStatusCount> beams{};
  std::vector<double> microseconds;
  nlohmann::json list = nlohmann::json::array();
};

nlohmann::json json_of(const FeatureExtractor& extractor, const RawScan& raw) {
  nlohmann::json keypoints = nlohmann::json::array();
  for (const DescribedKeypoint& feature : extractor.features()) {
    const Keypoint& k = feature.keypoint;
    keypoints.push_back({{"x", k.position.x()},
                         {"y", k.position.y()},
                         {"orientation", k.orientation},
                         {"radius", k.radius},
                         {"score", k.score},
                         {"roughness", k.roughness},
                         {"index", extractor.scan().message_index(k.beam)}});
  }
  return {{"stamp", to_seconds(raw.stamp.time_since_epoch())}, {"keypoints", keypoints}};
}

void detect_in(FeatureExtractor& extractor, const RawScan& raw, bool list, KeypointTally& tally) {
  const auto begin = std::chrono::steady_clock::now();
  const ScanReport report = extractor.extract(raw);
  const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - begin;
  ++tally.scans;
  if (!report.usable()) ++tally.unusable;
  for (std::size_t i = 0; i < kBeamStatusCount; ++i) tally.beams[i] += report.status_count[i];
  tally.keypoints += extractor.features().size();
  tally.microseconds.push_back(time.count());
  if (list) tally.list.push_back(json_of(extractor, raw));
}

void print(const KeypointTally& tally) {
  ScanReport all;
  all.status_count = tally.beams;
  for (const std::size_t count : tally.beams) all.beam_count += count;
  std::vector<double> times = tally.microseconds;
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  double sum = 0.0;
  for (const double time : times) sum += time;
  const auto scans = static_cast<double>(tally.scans);
  std::printf("%zu scans, %zu of them unusable\n", tally.scans, tally.unusable);
  std::printf("%s\n", describe(all).c_str());
  std::printf("%zu keypoints, %.2f per scan\n", tally.keypoints,
              static_cast<double>(tally.keypoints) / scans);
  std::printf("normalise, detect, describe: %.1f us per scan, median %.1f us\n", sum / scans,
              *middle);
}

void detect(const DetectOptions& options) {
  FeatureExtractor extractor(options.params);
  KeypointTally tally;
  std::string read;
  {
    Progress progress("scans");
    read = read_scans(options.recording, options.topic, [&](const RawScan& raw) {
      detect_in(extractor, raw, !options.json.empty(), tally);
      progress.step();
    });
  }
  if (options.json != "-") {
    std::printf("%s: %s\n", options.recording.c_str(), read.c_str());
    if (tally.scans > 0) print(tally);
    std::printf("%s\n", describe_resources().c_str());
  }
  if (!options.json.empty()) write_json(options.json, tally.list);
}

void detect_reflectors_of(const DetectOptions& options) {
  ReflectorRunOptions run{options.recording, options.topic, options.json, options.params.scan,
                          options.detector};
  if (options.flat) run.detector.shape = ReflectorDetectorParams::Shape::kFlat;
  detect_reflectors(run);
}

void add_reflector_options(CLI::App& verb, DetectOptions& options) {
  CLI::Option* reflectors = verb.add_flag("--reflectors", options.reflectors,
                                          "reflectors instead, from the intensities of the scans");
  verb.add_option("--diameter", options.detector.diameter,
                  "of the cylinders, or width of the strips [m], default 0.08")
      ->check(number_in(0.01, 1.0))
      ->needs(reflectors);
  verb.add_flag("--flat", options.flat, "the reflectors are flat strips")->needs(reflectors);
  verb.add_option("--threshold", options.detector.threshold,
                  "intensity that a reflector exceeds; default: learnt from the scans")
      ->check(number_in(0.0, 1e9))
      ->needs(reflectors);
  verb.add_option("--memory", options.detector.memory,
                  "scans over which is learnt, 0: each by itself, default 100")
      ->check(CLI::Range(0, 1000000))
      ->needs(reflectors);
}

}  // namespace

void add_detect(CLI::App& app) {
  auto options = std::make_shared<DetectOptions>();
  CLI::App* verb =
      app.add_subcommand("detect", "FALKO keypoints, or reflectors, of all scans of a recording");
  verb->add_option("recording", options->recording, "CARMEN log or ROS bag (.gz, .bz2)")
      ->required();
  verb->add_option("--topic", options->topic, "LaserScan topic of the bag; default: its only one");
  verb->add_option("--json", options->json, "write what is found in every scan; - for the console");
  verb->add_flag("--upside-down", options->params.scan.upside_down, "the laser hangs upside down");
  add_reflector_options(*verb, *options);
  verb->callback(
      [options] { options->reflectors ? detect_reflectors_of(*options) : detect(*options); });
}

}  // namespace cli
}  // namespace falko_slam
