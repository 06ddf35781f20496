// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/map_format.hpp"

#include <gtest/gtest.h>

#include "falko_slam/localization/imk_file.hpp"
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

TEST(MapFormat, EitherIsRead) {
  const test::TemporaryFolder folder;
  LandmarkMap map;
  map.landmarks.resize(1);
  map.landmarks[0].id = 4;
  map.landmarks[0].position = {1.5, -2.0};
  write_landmark_map(folder.file("a.yaml"), map);
  write_imk(folder.file("a.imk"), map);

  for (const char* name : {"a.yaml", "a.imk"}) {
    const LandmarkMap read = read_map_of_any_format(folder.file(name));
    ASSERT_NE(read.find(4), nullptr) << name;
    EXPECT_EQ(read.find(4)->position, map.landmarks[0].position) << name;
  }
}

}  // namespace
}  // namespace falko_slam
