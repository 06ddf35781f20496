// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/features/neighborhood_params.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace falko_slam {
namespace {

TEST(NeighborhoodParams, NameTheFieldThatIsOutOfItsRange) {
  EXPECT_NO_THROW(validate(NeighborhoodParams{}));
  NeighborhoodParams params;
  for (double* const field :
       {&params.radius_scale, &params.radius_growth, &params.max_radius, &params.sample_spacing,
        &params.smoothing_window, &params.min_incidence}) {
    const double good = *field;
    for (const double bad : {-1.0, std::nan("")}) {
      *field = bad;
      EXPECT_THROW(validate(params), std::invalid_argument) << field - &params.radius_scale;
    }
    *field = good;
  }
  params.min_points_per_side = 1;
  try {
    validate(params);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("min_points_per_side = 1"), std::string::npos);
  }
}

}  // namespace
}  // namespace falko_slam
