// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "reflector_face.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace falko_slam {
namespace {

TEST(ReflectorFace, OfAThinBeamIsThePointItHits) {
  const ReflectorDetectorParams params;
  for (const double aside : {0.0, 0.01, -0.025}) {
    const FaceInBeam face = face_in_beam(params, aside, 1e-6, 1e6);
    EXPECT_NEAR(face.depth, std::sqrt(0.04 * 0.04 - aside * aside), 1e-6);
    EXPECT_NEAR(face.light, 1.0, 1e-3);
  }
  EXPECT_EQ(face_in_beam(params, 0.041, 1e-6, 10.0).light, 0.0);
}

TEST(ReflectorFace, IsShallowerForAWideBeamAndDarkerAside) {
  const ReflectorDetectorParams params;
  const FaceInBeam wide = face_in_beam(params, 0.0, 0.06, 20.0);
  EXPECT_LT(wide.depth, 0.04);
  EXPECT_GT(wide.depth, 0.03);
  EXPECT_LT(face_in_beam(params, 0.05, 0.06, 20.0).light, wide.light);
  EXPECT_EQ(face_in_beam(params, 0.05, 0.06, 20.0).light,
            face_in_beam(params, -0.05, 0.06, 20.0).light);
}

}  // namespace
}  // namespace falko_slam
