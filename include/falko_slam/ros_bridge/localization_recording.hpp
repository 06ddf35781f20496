// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "falko_slam/calibration/vehicle_calibration.hpp"
#include "falko_slam/geometry/pose_estimate.hpp"
#include "falko_slam/geometry/trajectory.hpp"
#include "falko_slam/localization/landmark.hpp"
#include "falko_slam/sensor/scan_normalizer.hpp"
#include "falko_slam/vehicle/encoder_reading.hpp"
#include "falko_slam/vehicle/odometry_noise.hpp"

namespace falko_slam {

struct LocalizationRecordingParams {
  std::string scans;                   ///< topic of LaserScan; empty: the only one
  std::string encoders;                ///< topic of TricycleEncoders; the same
  std::string odometry;                ///< topic of Odometry; the same, or none
  std::string reflectors;              ///< topic of ReflectorArray; the same
  bool reported = false;               ///< the reflectors that the device reports, not scans
  std::string truth = "ground_truth";  ///< topic of PoseStamped; may be missing
  std::string base_frame = "base_link";
  /// With it motions are worked out from the encoders; without it they are the odometry's.
  std::optional<VehicleCalibration> calibration;
  EncoderParams counters;
  OdometryNoise noise;
};

/// Who takes what a bag holds, in its order.
struct LocalizationListener {
  std::function<void(Time, const PoseEstimate&)> motion;
  std::function<void(const RawScan&)> scan;  ///< valid during the call only
  std::function<void(Time, const std::vector<LandmarkObservation>&)> reflectors;
};

/// A bag of a drive that is to be localized.
struct LocalizationRecording {
  Pose2 base_T_laser;        ///< of the calibration, else of the bag's tf
  bool upside_down = false;  ///< the laser hangs with its z axis down
  bool laser_known = true;   ///< false: nothing tells, it is taken for base_link
  Time begin{};              ///< stamp of the first motion
  Trajectory truth;          ///< empty if there is none
  std::string description;   ///< one line: what is read
};

/// What is to be known before it is played. Throws std::runtime_error that names the file, and
/// lists its topics with their types if one is missing or not the only one.
LocalizationRecording open_localization_recording(const std::string& bag,
                                                  const LocalizationRecordingParams& params);

/// Hands over what it holds. Throws as above.
void play_localization_recording(const std::string& bag, const LocalizationRecordingParams& params,
                                 const LocalizationListener& listener);

}  // namespace falko_slam
