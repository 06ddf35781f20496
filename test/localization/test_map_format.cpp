// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/map_format.hpp"

#include <gtest/gtest.h>

#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

TEST(MapFormat, IsToldByTheEnding) {
  EXPECT_TRUE(is_imk("plant.imk"));
  EXPECT_TRUE(is_imk("/maps/PLANT.IMK"));
  EXPECT_FALSE(is_imk("plant.yaml"));
  EXPECT_FALSE(is_imk("imk"));
  EXPECT_FALSE(is_imk(".imk"));
}

TEST(MapFormat, EitherIsWrittenAndRead) {
  const test::TemporaryFolder folder;
  LandmarkMap map;
  map.landmarks.resize(1);
  map.landmarks[0].id = 4;
  map.landmarks[0].position = {1.5, -2.0};

  for (const char* name : {"a.yaml", "a.imk"}) {
    EXPECT_EQ(write_map_of_any_format(folder.file(name), map), 0U);
    const LandmarkMap read = read_map_of_any_format(folder.file(name));
    ASSERT_NE(read.find(4), nullptr) << name;
    EXPECT_EQ(read.find(4)->position, map.landmarks[0].position) << name;
  }
}

TEST(MapFormat, TellsHowManyFeaturesALayoutCannotHold) {
  const test::TemporaryFolder folder;
  LandmarkMap map;
  map.landmarks.resize(3);
  for (std::size_t i = 0; i < 3; ++i) map.landmarks[i].id = static_cast<std::uint32_t>(i + 1);
  map.landmarks[2].kind = LandmarkKind::kFeature;
  EXPECT_EQ(write_map_of_any_format(folder.file("a.imk"), map), 1U);
  EXPECT_EQ(write_map_of_any_format(folder.file("a.yaml"), map), 0U);
}

}  // namespace
}  // namespace falko_slam
