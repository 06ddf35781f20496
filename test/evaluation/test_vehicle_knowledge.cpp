// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/vehicle_knowledge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "support/seeds.hpp"

namespace falko_slam {
namespace {

TEST(VehicleKnowledge, IsTrueOrNominal) {
  const VehicleModel vehicle;
  EXPECT_EQ(true_calibration(vehicle).tricycle.driving_scale, vehicle.tricycle.driving_scale);
  EXPECT_EQ(true_calibration(vehicle).base_T_laser.x(), vehicle.base_T_laser.x());
  EXPECT_EQ(nominal_calibration(vehicle).tricycle.driving_scale, vehicle.nominal.driving_scale);
  EXPECT_EQ(nominal_calibration(vehicle).base_T_laser.x(), vehicle.nominal_base_T_laser.x());
}

TEST(VehicleKnowledge, IsDrawnAboutTheTruthAsFarOffAsItIsTold) {
  const VehicleModel vehicle;
  const CalibrationSpread spread;
  CalibrationVector deviation = CalibrationVector::Zero();
  for (const auto& [parameter, told] :
       {std::pair{CalibrationParameter::kSteerOffsetForward, spread.steer_offset},
        {CalibrationParameter::kSteerOffsetBackward, spread.steer_offset},
        {CalibrationParameter::kDrivingScale, spread.driving_scale},
        {CalibrationParameter::kLaserX, spread.laser_x},
        {CalibrationParameter::kLaserY, spread.laser_y},
        {CalibrationParameter::kLaserTheta, spread.laser_heading}}) {
    deviation[static_cast<Eigen::Index>(index_of(parameter))] = told;
  }
  constexpr int kDrawn = 4000;
  const CalibrationVector truth = vector_of(true_calibration(vehicle));
  auto random = test::seeded_random();
  CalibrationVector sum = CalibrationVector::Zero(), squares = CalibrationVector::Zero();
  for (int i = 0; i < kDrawn; ++i) {
    const CalibrationVector error = vector_of(drawn_calibration(vehicle, spread, random)) - truth;
    sum += error;
    squares += error.cwiseAbs2();
  }
  for (Eigen::Index i = 0; i < deviation.size(); ++i) {
    EXPECT_NEAR(sum[i] / kDrawn, 0.0, 0.06 * deviation[i]) << i;
    EXPECT_NEAR(std::sqrt(squares[i] / kDrawn), deviation[i], 0.05 * deviation[i]) << i;
  }
}

}  // namespace
}  // namespace falko_slam
