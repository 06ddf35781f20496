// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "falko_slam/simulation/layout.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

class LayoutFile : public ::testing::Test {
 protected:
  std::string written(const std::string& text) const {
    const std::string path = folder_.path() + "/layout.yaml";
    std::ofstream(path) << text;
    return path;
  }
  void expect_refused(const std::string& text, const std::string& words) const {
    try {
      read_layout(written(text));
      ADD_FAILURE() << words;
    } catch (const std::runtime_error& error) {
      const std::string what = error.what();
      EXPECT_NE(what.find("layout.yaml"), std::string::npos) << what;
      EXPECT_NE(what.find(words), std::string::npos) << what;
    }
  }
  test::TemporaryFolder folder_;
};

TEST_F(LayoutFile, HoldsPathsAndWaits) {
  const Layout layout = read_layout(
      written("name: hall\ndrive:\n- repeat: 2\n  steps:\n  - follow: {through: [[3, 0]], name: "
              "A}\n- wait: {seconds: 2}\n"));
  EXPECT_EQ(layout.name, "hall");
  ASSERT_EQ(layout.steps.size(), 3U);
  EXPECT_EQ(std::get<FollowStep>(layout.steps[1]).name, "A");
  EXPECT_EQ(std::get<WaitStep>(layout.steps[2]).seconds, 2.0);
}

TEST_F(LayoutFile, IsReadFromAScenarioToo) {
  const Layout layout = read_layout(FALKO_SLAM_SOURCE_DIR "/config/scenarios/warehouse.yaml");
  EXPECT_EQ(layout.steps.size(), 3U);
}

TEST_F(LayoutFile, ShipsAsMany) {
  std::size_t points = 0;
  for (const LayoutStep& step :
       read_layout(FALKO_SLAM_SOURCE_DIR "/config/layouts/warehouse.yaml").steps) {
    const auto* follow = std::get_if<FollowStep>(&step);
    if (follow != nullptr && !follow->name.empty()) ++points;
  }
  EXPECT_EQ(points, 12U);
}

TEST_F(LayoutFile, IsRefusedWithTheReason) {
  expect_refused("name: empty\n", "nothing to follow");
  expect_refused("drive:\n- arc: {wheel_speed: 1, steering: 0.5, turn: 1}\n", "has an arc");
  expect_refused("drive:\n- follow: {through: [[nan, 0]]}\n", "line 2");
  EXPECT_THROW(read_layout(folder_.path() + "/none.yaml"), std::runtime_error);
}

}  // namespace
}  // namespace falko_slam
