// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "falko_slam/simulation/scenario_file.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

class WorldVariationTest : public ::testing::Test {
 protected:
  Scenario read(const std::string& text, const WorldVariation& variation = {}) const {
    return read_scenario(folder_.write("yard.yaml", text), variation);
  }
  test::TemporaryFolder folder_;
};

constexpr const char* kRow =
    "world:\n- pallet: {at: [4, 0]}\n  repeat: {count: 3, step: [2, 0]}\n"
    "  scatter: [0.1, 0.1, 0.01]\n";

TEST_F(WorldVariationTest, ScattersSoManyTimesAsMuch) {
  const auto neat = read(kRow, {0.0, 1.0}).world.fixed.faces;
  const auto once = read(kRow).world.fixed.faces;
  const auto twice = read(kRow, {2.0, 1.0}).world.fixed.faces;
  ASSERT_EQ(neat.size(), 12U);
  for (std::size_t i = 0; i < neat.size(); i += 4) {  // the first corner of each
    const auto middle = [i](const std::vector<Face>& faces) -> Eigen::Vector2d {
      return 0.5 * (faces[i].from + faces[i + 2].from);
    };
    const Eigen::Vector2d way = middle(once) - middle(neat);
    EXPECT_GT(way.norm(), 1e-4);
    EXPECT_TRUE((middle(twice) - middle(neat)).isApprox(2.0 * way, 1e-9));
  }
}

TEST_F(WorldVariationTest, TakesAnotherSeed) {
  const auto own = read(kRow).world.fixed.faces;
  EXPECT_EQ(read(kRow, {1.0, 1.0, 1}).world.fixed.faces[0].from, own[0].from);
  EXPECT_NE(read(kRow, {1.0, 1.0, 2}).world.fixed.faces[0].from, own[0].from);
}

TEST_F(WorldVariationTest, SidesBulgeOutward) {
  const std::string text = "world:\n- box: {at: [0, 0], size: [2, 1], bulge: 0.02}\n";
  const auto faces = read(text).world.fixed.faces;
  ASSERT_EQ(faces.size(), 16U);
  double top = 0.0, right = 0.0;
  for (const Face& face : faces) {
    top = std::max(top, face.from.y());
    right = std::max(right, face.from.x());
  }
  EXPECT_NEAR(top, 0.52, 1e-12);
  EXPECT_NEAR(right, 1.02, 1e-12);
  EXPECT_EQ(read(text, {1.0, 0.0}).world.fixed.faces.size(), 4U);
}

TEST_F(WorldVariationTest, IsValidated) {
  EXPECT_THROW(read(kRow, {-1.0, 1.0}), std::invalid_argument);
  EXPECT_THROW(read(kRow, {1.0, std::nan("")}), std::invalid_argument);
}

TEST_F(WorldVariationTest, PathsHaveNamesAndAPartWithReflectors) {
  const Scenario scenario = read(
      "world: []\ndrive:\n- follow: {through: [[1, 0]], name: in, reflectors_until: 2.5}\n"
      "- follow: {through: [[0, 0]]}\n");
  const auto in = std::get<FollowStep>(scenario.drive[0]);
  EXPECT_EQ(in.name, "in");
  EXPECT_EQ(in.reflectors_until, 2.5);
  const auto back = std::get<FollowStep>(scenario.drive[1]);
  EXPECT_TRUE(back.name.empty());
  EXPECT_TRUE(std::isinf(back.reflectors_until));
}

}  // namespace
}  // namespace falko_slam
