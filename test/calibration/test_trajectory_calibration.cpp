// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/trajectory_calibration.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "calibration/arc_drives.hpp"
#include "falko_slam/vehicle/tricycle_log.hpp"
#include "support/recordings.hpp"

namespace falko_slam {
namespace {

TrajectoryCalibratorParams nominal_params() {
  TrajectoryCalibratorParams params;
  params.nominal = test::cb16();
  params.nominal.tricycle.steer_offset_forward = params.nominal.tricycle.steer_offset_backward = 0;
  params.encoders.steer_ticks_per_turn = 1U << 20U;
  params.nominal.tricycle.driving_scale = 2.5e-5;
  return params;
}

// A vehicle that is not the nominal one, its steering never at rest; forwards, then backwards.
VehicleCalibration driven_vehicle() {
  VehicleCalibration vehicle = nominal_params().nominal;
  vehicle.tricycle.wheelbase *= 1.03;
  vehicle.tricycle.driving_scale *= 0.98;
  vehicle.tricycle.steer_offset_forward = vehicle.tricycle.steer_offset_backward = 0.02;
  vehicle.steer_gain = 1.05;
  vehicle.base_T_laser = {0.45, -0.03, 0.03};
  return vehicle;
}

struct Drive {
  double sway = 0.6;  // amplitude of the steering [rad]
  double mean = 0.0;  // [rad]
};

std::vector<DriveRecord> drive(const VehicleCalibration& vehicle, const Drive& way) {
  const EncoderParams encoders = nominal_params().encoders;
  std::vector<DriveRecord> records;
  Pose2 base(3.0, -2.0, 1.0);
  std::uint32_t ticks = 4294960000U;  // soon to overflow
  for (int i = 0; i <= 3000; ++i) {
    const double steering = way.mean + way.sway * std::sin(0.01 * i);
    const auto steer_ticks = steer_ticks_of(encoders, steering);
    if (i > 0) {
      const int step = i < 2000 ? 400 : -400;
      const double before = steering_of(encoders, records.back().encoders.steer_ticks);
      const double between =
          before +
          0.5 * steering_between(encoders, records.back().encoders.steer_ticks, steer_ticks);
      base = base * drive_arc(vehicle.tricycle, step, vehicle.steer_gain * between);
      ticks += static_cast<std::uint32_t>(step);
    }
    records.push_back({{Time(std::chrono::milliseconds(40 * i)), ticks, steer_ticks},
                       base * vehicle.base_T_laser});
  }
  return records;
}

TEST(TrajectoryCalibration, FindsTheVehicleThatDrove) {
  const VehicleCalibration truth = driven_vehicle();
  for (const auto model : {TricycleModel::kStandard, TricycleModel::kAsymmetric}) {
    TrajectoryCalibratorParams params = nominal_params();
    params.model = model;

    const auto result = calibrate_trajectory(drive(truth, {}), params);

    ASSERT_TRUE(result.estimate);
    EXPECT_GT(result.nominal_error.mean, 0.5);
    EXPECT_LT(result.error.greatest, 1e-6);
    EXPECT_EQ(result.windows.size(), 30U);
    const CalibrationVector found = vector_of(result.estimate->calibration);
    for (Eigen::Index i = 0; i < found.size(); ++i) {
      EXPECT_NEAR(found[i], vector_of(truth)[i], 1e-6) << i;
    }
  }
}

TEST(TrajectoryCalibration, HoldsWhatItIsToldToHold) {
  TrajectoryCalibratorParams params = nominal_params();
  params.nominal.tricycle.wheelbase = driven_vehicle().tricycle.wheelbase;
  params.nominal.steer_gain = 1.05;
  params.free_wheelbase = params.free_steer_gain = false;

  const auto result = calibrate_trajectory(drive(driven_vehicle(), {}), params);

  ASSERT_TRUE(result.estimate);
  EXPECT_EQ(result.estimate->calibration.steer_gain, 1.05);
  EXPECT_EQ(result.estimate->covariance(6, 6), 0.0);
  EXPECT_LT(result.error.greatest, 1e-6);
}

TEST(TrajectoryCalibration, GivesNoNumberForDrivesThatTellTooLittle) {
  const TrajectoryCalibratorParams params = nominal_params();
  const auto refused = [&params](const std::vector<DriveRecord>& records) {
    const auto result = calibrate_trajectory(records, params);
    EXPECT_FALSE(result.remarks.empty());
    return result.verdict == CalibrationVerdict::kUnobservable && !result.estimate;
  };
  VehicleCalibration straight = params.nominal;
  EXPECT_TRUE(refused({}));
  EXPECT_TRUE(refused({DriveRecord()}));
  EXPECT_TRUE(refused(drive(straight, {0.0, 0.0})));
  EXPECT_TRUE(refused(drive(straight, {0.0, 0.4})));  // one centre of rotation
}

TEST(TrajectoryCalibration, GivesNoNumberForReversedTicks) {
  auto records = drive(driven_vehicle(), {});
  for (DriveRecord& record : records) {
    record.encoders.drive_ticks = 0U - record.encoders.drive_ticks;
  }

  const auto result = calibrate_trajectory(records, nominal_params());

  EXPECT_EQ(result.verdict, CalibrationVerdict::kContradictory);
  EXPECT_FALSE(result.estimate);
}

TEST(TrajectoryCalibration, RefusesPosesThatAreNotFinite) {
  auto records = drive(driven_vehicle(), {});
  records[7].world_T_laser = Pose2(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  EXPECT_THROW(calibrate_trajectory(records, nominal_params()), std::invalid_argument);
  TrajectoryCalibratorParams params = nominal_params();
  params.window = 0.0;
  EXPECT_THROW(calibrate_trajectory({}, params), std::invalid_argument);
}

// A real vehicle whose nominal steer gain is off by a factor of five and a half.
TEST(TrajectoryCalibration, BringsARecordedDriveFromMetresToDecimetres) {
  const std::string path = test::tricycle_recording();
  if (!std::ifstream(path)) {
    GTEST_SKIP() << path << " is not there: set FALKO_SLAM_DATA to the folder that holds "
                 << "tricycle/dataset.txt";
  }
  TricycleLogReader reader(path);
  std::vector<DriveRecord> records;
  while (const auto record = reader.next()) {
    records.push_back({record->encoders, record->start_T_laser});
  }
  TrajectoryCalibratorParams params;
  params.nominal = {tricycle_params_of(reader.header()), 1.0, reader.header().base_T_laser};
  params.encoders = encoder_params_of(reader.header());

  const auto result = calibrate_trajectory(records, params);

  EXPECT_NEAR(result.nominal_error.mean, 14.04, 0.01);
  ASSERT_TRUE(result.estimate);
  EXPECT_TRUE(result.estimate->converged);
  EXPECT_LT(result.error.mean, 0.25);
  EXPECT_EQ(result.verdict, CalibrationVerdict::kWeak);
  const std::vector<CalibrationParameter> trio = {CalibrationParameter::kDrivingScale,
                                                  CalibrationParameter::kWheelbase,
                                                  CalibrationParameter::kSteerGain};
  EXPECT_EQ(result.tied, trio);
}

}  // namespace
}  // namespace falko_slam
