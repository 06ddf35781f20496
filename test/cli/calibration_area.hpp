// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace falko_slam {
namespace test {

/// The shipped scenario of a vehicle that drives for its calibration.
constexpr char kCalibrationArea[] = FALKO_SLAM_SOURCE_DIR "/config/scenarios/calibration_area.yaml";

}  // namespace test
}  // namespace falko_slam
