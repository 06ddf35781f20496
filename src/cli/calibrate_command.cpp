// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <map>
#include <memory>

#include "calibration_print.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "falko_slam/calibration/calibration_file.hpp"
#include "falko_slam/calibration/recorded_calibration.hpp"
#include "falko_slam/ros_bridge/calibration_recording.hpp"
#include "falko_slam/sensor/log_kind.hpp"
#include "falko_slam/vehicle/tricycle_log.hpp"

namespace falko_slam {
namespace cli {
namespace {

struct CalibrateOptions {
  std::string recording, start, out, date;
  std::string egomotion = "auto";
  bool standard = false;
  CalibrationTopics topics;
  SegmentRecorderParams recorder;
  ScanNormalizerParams scanner;
  CalibratorParams calibrator;
  std::vector<double> laser;
  std::string defaults;  // of the vehicle: options that nobody has given
};

bool ends_in_bag(const std::string& path) {
  return path.size() > 4 && path.compare(path.size() - 4, 4, ".bag") == 0;
}

void finish(const CalibrateOptions& options, const StoredCalibration& stored) {
  if (options.out.empty()) return;
  write_calibration(options.out, stored);
  std::cout << "wrote " << options.out << "\n";
}

[[noreturn]] void refuse(CalibrationVerdict verdict) {
  throw std::runtime_error(std::string("no calibration: the verdict is ") + name_of(verdict));
}

// What the vehicle's controller believes: from a file of an earlier calibration, and from options.
void take_nominal(CalibrateOptions& options) {
  if (!options.start.empty()) {
    const VehicleCalibration start = read_calibration(options.start).calibration;
    options.recorder.tricycle = start.tricycle;
    options.recorder.base_T_laser = start.base_T_laser;
    options.calibrator.steer_gain = start.steer_gain;
  }
  if (options.laser.size() == 3) {
    options.recorder.base_T_laser = Pose2(options.laser[0], options.laser[1], options.laser[2]);
  }
  options.calibrator.wheelbase = options.recorder.tricycle.wheelbase;
}

// A wheelbase is not found unless asked for: whoever forgets it should see which one counts.
void print_nominal(const CalibrateOptions& options) {
  const SegmentRecorderParams& nominal = options.recorder;
  std::cout << "believed of the vehicle: wheelbase " << nominal.tricycle.wheelbase
            << " m, driving scale " << nominal.tricycle.driving_scale << " m a tick, laser "
            << nominal.base_T_laser;
  if (!options.defaults.empty()) std::cout << "; by default: " << options.defaults;
  std::cout << "\n";
}

void calibrate_bag(CalibrateOptions options) {
  take_nominal(options);
  print_nominal(options);
  if (options.egomotion == "auto") {
    options.recorder.egomotion =
        egomotion_in(options.recording, options.topics, options.recorder.reflectors.min_reflectors);
  } else if (options.egomotion == name_of(EgomotionSource::kScans)) {
    options.recorder.egomotion = EgomotionSource::kScans;
  }
  const CalibrationRecording recording =
      read_calibration_drive(options.recording, options.topics, options.recorder, options.scanner);
  std::cout << options.recording << ": " << recording.description << "\n";
  const RecordedCalibration calibration = calibrate_recorded(
      recording.segments, options.calibrator, options.recorder.reflectors.lasting_noise);
  print_segments(std::cout, recording.segments, calibration);
  print(std::cout, calibration.result);
  if (!calibration.result.estimate) refuse(calibration.result.verdict);
  finish(options, stored_calibration(calibration.result, options.calibrator.model, options.date));
}

void calibrate_log(const CalibrateOptions& options) {
  TricycleLogReader reader(options.recording);
  std::vector<DriveRecord> records;
  while (const auto record = reader.next()) {
    records.push_back({record->encoders, record->start_T_laser});
  }
  std::cout << options.recording << ": " << describe(reader.report()) << "\n";
  TrajectoryCalibratorParams params;
  params.model = options.calibrator.model;
  params.nominal.tricycle = tricycle_params_of(reader.header());
  params.nominal.base_T_laser = reader.header().base_T_laser;
  params.encoders = encoder_params_of(reader.header());
  params.free_wheelbase = options.calibrator.free_wheelbase;
  params.free_steer_gain = options.calibrator.free_steer_gain;
  const TrajectoryCalibrationResult result = calibrate_trajectory(records, params);
  print(std::cout, result);
  if (!result.estimate) refuse(result.verdict);
  finish(options, stored_calibration(result, params.model, options.date));
}

void run(CalibrateOptions options) {
  if (options.standard) options.calibrator.model = TricycleModel::kStandard;
  if (ends_in_bag(options.recording)) {
    calibrate_bag(std::move(options));
  } else if (recognize_log(options.recording) == LogKind::kTricycle) {
    calibrate_log(options);
  } else {
    throw std::runtime_error(options.recording + ": neither a bag nor a tricycle's log");
  }
}

std::string list_defaults(const CLI::App& verb) {
  std::string list;
  if (verb.count("--start") > 0) return list;
  for (const char* name : {"--wheelbase", "--driving-scale", "--laser"}) {
    if (verb.count(name) == 0) list += std::string(list.empty() ? "" : ", ") + name;
  }
  return list;
}

void add_nominal_options(CLI::App* verb, CalibrateOptions& options) {
  SegmentRecorderParams& recorder = options.recorder;
  verb->add_option("--start", options.start,
                   "file of an earlier calibration; the options below count before it");
  verb->add_option("--wheelbase", recorder.tricycle.wheelbase, "of the vehicle [m]")
      ->capture_default_str();
  verb->add_option("--driving-scale", recorder.tricycle.driving_scale,
                   "way of the driven wheel per tick, as it is believed to be [m]")
      ->capture_default_str();
  verb->add_option("--laser", options.laser,
                   "x y theta of the laser on the vehicle, as they are believed to be [m], [rad]")
      ->expected(3);
  verb->add_option("--steer-ticks-per-turn", recorder.encoders.steer_ticks_per_turn)
      ->capture_default_str();
  verb->add_option("--steer-zero", recorder.encoders.steer_zero,
                   "reading of a wheel that looks straight ahead")
      ->capture_default_str();
}

void add_egomotion_options(CLI::App* verb, CalibrateOptions& options) {
  verb->add_option("--egomotion", options.egomotion,
                   "what tells how the laser moved; auto: reflectors where the bag has enough")
      ->check(CLI::IsMember({"auto", "reflectors", "scans"}))
      ->capture_default_str();
  verb->add_option("--encoders", options.topics.encoders, "topic; default: the only one");
  verb->add_option("--reflectors", options.topics.reflectors, "topic; default: the only one");
  verb->add_option("--scans", options.topics.scans, "topic; default: the only one");
  verb->add_flag("--upside-down", options.scanner.upside_down,
                 "the laser of the scans hangs with its z axis down");
}

}  // namespace

void add_calibrate(CLI::App& app) {
  auto options = std::make_shared<CalibrateOptions>();
  CLI::App* verb = app.add_subcommand(
      "calibrate", "steer offsets, driving scale and pose of the laser of a tricycle");
  verb->add_option("recording", options->recording,
                   "bag with encoders and reflectors or scans of a calibration drive, or a "
                   "tricycle's log")
      ->required();
  verb->add_option("--out", options->out,
                   "YAML file to write; one that is there is kept as FILE.previous.yaml");
  verb->add_option("--date", options->date, "text for the file, default empty");
  add_nominal_options(verb, *options);
  add_egomotion_options(verb, *options);
  verb->add_flag("--standard", options->standard, "one steer offset for both directions");
  verb->add_flag("--free-wheelbase", options->calibrator.free_wheelbase, "find the wheelbase, too");
  verb->add_flag("--free-steer-gain", options->calibrator.free_steer_gain,
                 "find what the measured steering is to be multiplied with, too");
  verb->add_option("--slip", options->calibrator.noise.slip,
                   "standard deviation of a segment's slip, as a share of its way")
      ->capture_default_str();
  verb->add_option("--steer-noise", options->calibrator.noise.steer,
                   "standard deviation of a segment's steering error [rad]")
      ->capture_default_str();
  verb->callback([options, verb] {
    options->defaults = list_defaults(*verb);
    run(*options);
  });
}

}  // namespace cli
}  // namespace falko_slam
