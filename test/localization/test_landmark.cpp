// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/landmark.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace falko_slam {
namespace {

LandmarkObservation observation(ObservationModel model, double first, double second) {
  return {model, {first, second}, 1e-4 * Eigen::Matrix2d::Identity(), {}};
}

TEST(LandmarkObservation, IsAPointWhateverItsModel) {
  const auto polar = observation(ObservationModel::kRangeBearing, 2.0, 0.5);
  const auto cartesian =
      observation(ObservationModel::kCartesian, 2.0 * std::cos(0.5), 2.0 * std::sin(0.5));
  EXPECT_LT((point_in_laser(polar) - point_in_laser(cartesian)).norm(), 1e-12);
}

TEST(LandmarkObservation, IsUsableOnlyWithNumbersAndACovariance) {
  const auto good = observation(ObservationModel::kCartesian, -1.0, 2.0);
  EXPECT_TRUE(is_usable(good));
  EXPECT_FALSE(is_usable(observation(ObservationModel::kRangeBearing, 0.0, 0.1)));
  EXPECT_FALSE(is_usable(observation(ObservationModel::kCartesian, std::nan(""), 0.1)));
  for (const double wrong : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
    LandmarkObservation bad = good;
    bad.covariance(1, 1) = wrong;
    EXPECT_FALSE(is_usable(bad)) << wrong;
  }
  LandmarkObservation skew = good;
  skew.covariance(0, 1) = 5e-5;
  EXPECT_FALSE(is_usable(skew));
}

}  // namespace
}  // namespace falko_slam
