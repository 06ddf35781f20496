// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/thesis_calibration.hpp"

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

using Parameter = CalibrationParameter;

constexpr std::size_t kRows = 20;
constexpr double kCentidegree = degrees_to_radians(0.01);

// \cite kallasi2017, Table 5.1 as printed: mean and deviation of alpha_off [cdeg], s_w [mm/tick],
// l_x [mm], l_y [mm], l_theta [cdeg].
constexpr double kTable51[kRows][10] = {
    {-75.93, 0.39, 0.249685, 0.000036, 390.28, 0.13, 2.14, 0.14, 50.34, 0.32},
    {-75.89, 0.30, 0.249806, 0.000023, 389.09, 0.16, 1.63, 0.27, 43.03, 0.21},
    {-77.05, 0.72, 0.249576, 0.000043, 395.79, 0.34, 4.21, 0.63, 36.88, 1.18},
    {-75.36, 0.32, 0.249880, 0.000059, 386.68, 0.51, 6.17, 0.22, 37.83, 0.70},
    {-76.73, 0.59, 0.249652, 0.000111, 387.81, 0.60, 2.78, 0.18, 44.57, 0.28},
    {-76.27, 0.62, 0.249668, 0.000040, 387.10, 0.25, 2.48, 0.47, 44.64, 0.80},
    {-75.82, 0.35, 0.249690, 0.000007, 387.89, 0.66, 1.85, 0.22, 47.30, 1.12},
    {-75.57, 0.63, 0.249686, 0.000023, 388.04, 0.43, 1.81, 0.15, 48.19, 0.77},
    {-73.69, 0.44, 0.250081, 0.000004, 386.03, 0.22, 0.00, 0.26, 43.01, 1.80},
    {-76.01, 0.31, 0.249816, 0.000085, 389.03, 0.32, 1.82, 0.53, 43.35, 0.44},
    {-75.64, 0.11, 0.249750, 0.000015, 389.23, 0.09, 2.79, 0.28, 40.46, 0.59},
    {-75.03, 0.09, 0.249772, 0.000023, 388.94, 0.17, 3.23, 0.12, 42.65, 0.34},
    {-77.47, 0.48, 0.249716, 0.000122, 389.00, 0.03, 2.03, 0.48, 41.84, 1.73},
    {-77.74, 0.30, 0.249789, 0.000006, 388.91, 0.39, 1.73, 0.12, 42.10, 0.50},
    {-77.40, 0.65, 0.249736, 0.000039, 389.45, 0.37, 1.97, 0.56, 42.26, 0.54},
    {-75.48, 0.33, 0.249731, 0.000061, 389.48, 0.15, 2.47, 0.24, 41.24, 0.28},
    {-75.75, 0.29, 0.249753, 0.000027, 389.29, 0.45, 2.52, 0.41, 40.38, 0.79},
    {-74.74, 0.16, 0.249706, 0.000027, 389.76, 0.45, 2.50, 0.49, 41.84, 0.47},
    {-75.03, 0.11, 0.249807, 0.000007, 390.13, 0.15, 4.49, 0.38, 38.08, 0.35},
    {-75.49, 0.16, 0.249744, 0.000052, 390.14, 0.21, 6.77, 0.35, 39.58, 0.55}};

// Table 5.2: alpha_F [cdeg], alpha_B [cdeg], then as in Table 5.1.
// Deviation: its means of s_w are printed with a digit too many, 0.2249746 for 0.249746, as those
// of Table 5.1 show.
constexpr double kTable52[kRows][12] = {
    {-74.84, 0.81, -77.13, 0.33, 0.249746, 0.000038, 390.27, 0.16, 2.21, 0.10, 50.32, 0.40},
    {-72.30, 0.43, -79.22, 0.47, 0.249888, 0.000008, 389.09, 0.20, 1.43, 0.36, 42.98, 0.26},
    {-71.59, 0.76, -82.81, 0.52, 0.249664, 0.000029, 395.79, 0.42, 4.34, 0.50, 36.82, 1.46},
    {-73.24, 0.07, -76.00, 0.62, 0.249978, 0.000040, 386.68, 0.63, 5.33, 0.19, 37.81, 0.85},
    {-75.71, 0.61, -76.76, 0.82, 0.249717, 0.000129, 387.80, 0.73, 2.23, 0.49, 44.56, 0.34},
    {-75.07, 1.04, -76.69, 0.36, 0.249762, 0.000047, 387.10, 0.30, 2.04, 0.48, 44.63, 0.98},
    {-75.09, 0.41, -76.28, 0.55, 0.249790, 0.000030, 387.89, 0.81, 1.71, 0.68, 47.29, 1.37},
    {-74.97, 0.99, -75.87, 0.39, 0.249810, 0.000040, 388.04, 0.52, 1.64, 0.40, 48.18, 0.94},
    {-71.15, 0.63, -75.93, 0.26, 0.250092, 0.000005, 386.03, 0.27, -0.09, 0.30, 42.96, 2.20},
    {-72.02, 0.37, -78.76, 0.37, 0.249882, 0.000105, 389.03, 0.39, 1.16, 0.66, 43.29, 0.53},
    {-72.70, 0.34, -77.47, 0.46, 0.249823, 0.000027, 389.23, 0.11, 2.22, 0.39, 40.43, 0.72},
    {-71.25, 0.44, -77.87, 0.39, 0.249842, 0.000025, 388.94, 0.21, 2.76, 0.23, 42.60, 0.40},
    {-74.79, 0.72, -79.68, 0.34, 0.249776, 0.000163, 389.00, 0.04, 1.69, 0.66, 41.81, 2.12},
    {-74.41, 0.39, -80.38, 0.34, 0.249869, 0.000028, 388.91, 0.48, 1.23, 0.30, 42.06, 0.62},
    {-74.65, 0.99, -79.94, 0.64, 0.249831, 0.000034, 389.45, 0.46, 1.82, 0.83, 42.22, 0.66},
    {-72.07, 0.48, -78.67, 0.34, 0.249800, 0.000069, 389.47, 0.18, 2.31, 0.42, 41.19, 0.33},
    {-72.21, 0.32, -79.13, 0.27, 0.249821, 0.000028, 389.29, 0.56, 2.40, 0.55, 40.32, 0.96},
    {-71.42, 0.07, -78.05, 0.19, 0.249788, 0.000030, 389.77, 0.55, 2.49, 0.56, 41.79, 0.57},
    {-72.41, 0.23, -78.05, 0.34, 0.249854, 0.000013, 390.14, 0.18, 4.78, 0.39, 38.04, 0.42},
    {-71.74, 0.33, -78.40, 0.16, 0.249791, 0.000059, 390.14, 0.26, 6.33, 0.51, 39.54, 0.67}};

void put(PublishedCalibration& published, Parameter parameter, const double* printed, double unit) {
  const auto row = static_cast<Eigen::Index>(index_of(parameter));
  published.mean[row] = unit * printed[0];
  published.deviation[row] = unit * printed[1];
}

PublishedCalibration read_row(const double* forward, const double* backward, const double* others) {
  PublishedCalibration published;
  put(published, Parameter::kSteerOffsetForward, forward, kCentidegree);
  put(published, Parameter::kSteerOffsetBackward, backward, kCentidegree);
  put(published, Parameter::kDrivingScale, others, 1e-3);
  put(published, Parameter::kLaserX, others + 2, 1e-3);
  put(published, Parameter::kLaserY, others + 4, 1e-3);
  put(published, Parameter::kLaserTheta, others + 6, kCentidegree);
  return published;
}

}  // namespace

std::vector<ThesisCalibration> thesis_calibrations() {
  std::vector<ThesisCalibration> rows;
  for (std::size_t i = 0; i < kRows; ++i) {
    const double *standard = kTable51[i], *asymmetric = kTable52[i];
    rows.push_back({read_row(standard, standard, standard + 2),
                    read_row(asymmetric, asymmetric + 2, asymmetric + 4)});
  }
  return rows;
}

double thesis_unit(CalibrationParameter parameter) {
  switch (parameter) {
    case Parameter::kSteerOffsetForward:
    case Parameter::kSteerOffsetBackward:
    case Parameter::kLaserTheta:
      return 1.0 / kCentidegree;
    case Parameter::kDrivingScale:
      return 1e8;
    case Parameter::kLaserX:
    case Parameter::kLaserY:
    case Parameter::kWheelbase:
      return 1e3;
    case Parameter::kSteerGain:
      return 1.0;
  }
  return 1.0;
}

}  // namespace falko_slam
