// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "console.hpp"
#include "falko_slam/calibration/calibration_file.hpp"
#include "falko_slam/common/whole_file.hpp"
#include "falko_slam/common/yaml_fields.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/geometry/trajectory_file.hpp"
#include "falko_slam/localization/localizer_fields.hpp"
#include "falko_slam/localization/map_format.hpp"
#include "falko_slam/ros_bridge/localization_recording.hpp"
#include "localize_run.hpp"
#include "output_files.hpp"

namespace falko_slam {
namespace cli {
namespace {

struct LocalizeOptions {
  std::string recording, map, out, json, calibration, parameters;
  std::vector<double> start;  ///< x, y [m], heading [rad]; empty: not known
  bool replace = false;
  bool no_deskew = false;
  bool stamp_at_end = false;
  LocalizationRecordingParams reading;
};

LocalizerParams read_parameters(const LocalizeOptions& options, const LandmarkMap& map) {
  LocalizerParams params;
  if (!options.parameters.empty()) {
    YamlFields file(options.parameters);
    visit_localizer_fields(params, file);
    file.check([&] { validate(params); });
  }
  const std::string remark = take_diameter_of(map, params.reflectors);
  if (!remark.empty()) std::cerr << remark << "\n";
  if (options.no_deskew) params.deskew = false;
  return params;
}

nlohmann::json json_of(const ErrorSummary& errors) {
  return {{"count", errors.count},
          {"rms", errors.rms},
          {"mean", errors.mean},
          {"max", errors.max},
          {"median", errors.median}};
}

nlohmann::json json_of(const LocalizeRun& run, const LocalizationRecording& recording) {
  nlohmann::json status;
  for (std::size_t i = 0; i < run.status().size(); ++i) {
    status[name_of(static_cast<LocalizationStatus>(i))] = run.status()[i];
  }
  nlohmann::json document = {{"read", recording.description},
                             {"scans", run.scans()},
                             {"unusable_scans", run.unusable()},
                             {"scans_by_status", status},
                             {"mean_seconds_per_scan", run.mean_seconds()},
                             {"max_seconds_per_scan", run.max_seconds()}};
  if (!run.errors().translation.empty()) {
    document["position_error"] = json_of(summarise(run.errors().translation));
    document["heading_error"] = json_of(summarise(run.errors().rotation));
  }
  return document;
}

void print(const LocalizeRun& run, const LocalizationRecording& recording,
           const LocalizeOptions& options) {
  std::printf("%s: %s\n%zu scans, %zu unusable;", options.recording.c_str(),
              recording.description.c_str(), run.scans(), run.unusable());
  for (std::size_t i = 0; i < run.status().size(); ++i) {
    std::printf(" %s %zu", name_of(static_cast<LocalizationStatus>(i)), run.status()[i]);
  }
  std::printf("\nraw scan to pose: mean %.3f ms, longest %.3f ms\n", 1e3 * run.mean_seconds(),
              1e3 * run.max_seconds());
  if (!run.errors().translation.empty()) {
    const ErrorSummary position = summarise(run.errors().translation);
    const ErrorSummary heading = summarise(run.errors().rotation);
    std::printf(
        "against the truth, %zu poses: RMSE %.2f mm, %.3f deg; greatest %.2f mm, %.3f deg\n",
        position.count, 1e3 * position.rms, radians_to_degrees(heading.rms), 1e3 * position.max,
        radians_to_degrees(heading.max));
  }
  std::printf("%s\n%s\n", options.out.c_str(), describe_resources().c_str());
}

void begin(LocalizeRun& run, const LocalizeOptions& options, const LocalizationRecording& from) {
  if (options.start.empty()) return run.localizer().globalize();
  run.localizer().set_pose(from.truth.front().stamp,
                           PoseEstimate{{options.start[0], options.start[1], options.start[2]},
                                        pose_covariance(0.1, 0.05)});
}

void localize(LocalizeOptions options) {
  make_output_folder(options.out, options.replace);
  if (!options.calibration.empty()) {
    options.reading.calibration = read_calibration(options.calibration).calibration;
  }
  const LandmarkMap map = read_map_of_any_format(options.map);
  const LocalizationRecording recording =
      open_localization_recording(options.recording, options.reading);
  if (!recording.laser_known) {
    std::cerr << "no transform from " << options.reading.base_frame
              << " to the laser: the laser is taken for " << options.reading.base_frame << "\n";
  }
  LocalizerParams params = read_parameters(options, map);
  params.base_T_laser = recording.base_T_laser;
  ScanNormalizerParams scanner;
  scanner.upside_down = recording.upside_down;
  if (options.stamp_at_end) scanner.stamp_at = ScanNormalizerParams::StampAt::kLastBeam;
  LocalizeRun run(params, map, scanner, recording.truth);
  begin(run, options, recording);
  {
    Progress progress("scans");
    LocalizationListener listener;
    listener.motion = [&](Time stamp, const PoseEstimate& motion) {
      run.localizer().add_motion(stamp, motion);
    };
    listener.scan = [&](const RawScan& raw) {
      run.add(raw);
      progress.step();
    };
    listener.reflectors = [&](Time stamp, const std::vector<LandmarkObservation>& seen) {
      run.add(stamp, seen);
      progress.step();
    };
    play_localization_recording(options.recording, options.reading, listener);
  }
  write_tum(options.out + "/trajectory.tum", run.trajectory());
  write_whole_file(options.out + "/status.csv", run.table());
  write_json(options.out + "/report.json", json_of(run, recording));
  print(run, recording, options);
  if (!options.json.empty()) write_json(options.json, json_of(run, recording));
}

void add_reading(CLI::App* verb, LocalizationRecordingParams& reading) {
  verb->add_option("--scans", reading.scans, "topic of the scans; default: the bag's only one");
  verb->add_option("--encoders", reading.encoders, "topic of the encoders; the same");
  verb->add_option("--odometry", reading.odometry, "topic of the odometry; the same");
  verb->add_option("--reflectors", reading.reflectors,
                   "topic of the device's reflectors; the same");
  verb->add_flag("--reported", reading.reported, "the device's reflectors in place of scans");
  verb->add_option("--truth", reading.truth, "topic of the true poses, default ground_truth");
  verb->add_option("--base-frame", reading.base_frame, "of the vehicle, default base_link");
  verb->add_option("--slip", reading.noise.slip, "of the wheel [m / sqrt(m)]")
      ->check(number_in(0.0, 1.0));
  verb->add_option("--steer", reading.noise.steer, "of the steering [rad sqrt(m)]")
      ->check(number_in(0.0, 1.0));
}

}  // namespace

void add_localize(CLI::App& app) {
  auto options = std::make_shared<LocalizeOptions>();
  CLI::App* verb =
      app.add_subcommand("localize", "poses of a recording on a map of landmarks, with status");
  verb->add_option("recording", options->recording, "ROS bag")->required();
  verb->add_option("--map", options->map, "landmarks: YAML, or .imk of SICK")->required();
  verb->add_option("--out", options->out,
                   "folder for trajectory.tum, status.csv and report.json; made if not there")
      ->required();
  verb->add_flag("--force", options->replace, "replace what an earlier run wrote to the folder");
  verb->add_option("--start", options->start, "x,y,heading [m, rad]; default: searched for")
      ->delimiter(',')
      ->expected(3);
  verb->add_option("--calibration", options->calibration,
                   "of `calibrate`: motions from the encoders and the laser's place; default: the "
                   "bag's odometry and tf");
  verb->add_option("--parameters", options->parameters, "YAML file of the localizer's parameters");
  verb->add_flag("--no-deskew", options->no_deskew, "scans are taken for instants");
  verb->add_flag("--stamp-at-end", options->stamp_at_end, "scans have the stamp of the last beam");
  add_reading(verb, options->reading);
  verb->add_option("--json", options->json, "write the report; -: to the console");
  verb->callback([options] { localize(*options); });
}

}  // namespace cli
}  // namespace falko_slam
