// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "falko_slam/geometry/trajectory_file.hpp"
#include "support/command.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

using test::falko;

constexpr char kHall[] = R"(name: hall
start: [0, 0, 0.3]
vehicle:
  nominal: {driving_scale: 2.4975e-4, steer_offset_forward: -0.012566370614359173, steer_offset_backward: -0.013613568165555770}
world:
- wall: [[-15, -10], [15, -10], [15, 10], [-15, 10]]
  closed: true
- reflector: {at: [8, 2]}
- reflector: {at: [-6, 7]}
- reflector: {at: [2, -8]}
- reflector: {at: [-9, -3]}
- reflector: {at: [11, 8]}
drive:
- arc: {wheel_speed: 0.5, steering: 0.2, way: 2.0}
- wait: {seconds: 0.5}
)";

class LocalizeCommand : public ::testing::Test {
 protected:
  LocalizeCommand() {
    const test::CommandResult made =
        falko({"simulate", folder_.write("hall.yaml", kHall), "--out", folder_.file("hall.bag"),
               "--map-out", folder_.file("map.yaml")});
    EXPECT_EQ(made.exit_code, 0) << made.errors;
  }
  test::CommandResult localize(std::vector<std::string> more = {}) const {
    std::vector<std::string> words = {"localize", folder_.file("hall.bag"),
                                      "--map",    folder_.file("map.yaml"),
                                      "--out",    folder_.file("out")};
    words.insert(words.end(), more.begin(), more.end());
    return falko(words);
  }

  test::TemporaryFolder folder_;
};

TEST_F(LocalizeCommand, FindsItselfAndWritesPosesStatusAndReport) {
  const test::CommandResult result = localize();

  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_GT(read_tum(folder_.file("out/trajectory.tum")).size(), 20U);
  EXPECT_NE(test::whole_file(folder_.file("out/status.csv")).find(",ok,"), std::string::npos);
  EXPECT_NE(test::whole_file(folder_.file("out/report.json")).find("position_error"),
            std::string::npos);
  EXPECT_TRUE(localize().complains("report.json: exists already; --force replaces it"));
}

TEST_F(LocalizeCommand, TakesReportedReflectorsAndAStart) {
  const test::CommandResult result = localize({"--reported", "--start", "0,0,0.3"});

  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_GT(read_tum(folder_.file("out/trajectory.tum")).size(), 20U);
}

TEST_F(LocalizeCommand, NamesATopicThatIsMissing) {
  const test::CommandResult result = localize({"--odometry", "nowhere"});

  EXPECT_NE(result.exit_code, 0);
  EXPECT_TRUE(result.complains("nav_msgs/Odometry")) << result.errors;
}

TEST_F(LocalizeCommand, TakesTheLayoutThatSimulateWrites) {
  const std::string layout = folder_.file("map.imk");
  ASSERT_EQ(falko({"simulate", folder_.file("hall.yaml"), "--out", folder_.file("hall.bag"),
                   "--force", "--map-out", layout})
                .exit_code,
            0);
  const auto result =
      falko({"localize", folder_.file("hall.bag"), "--map", layout, "--out", folder_.file("out")});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
}

}  // namespace
}  // namespace falko_slam
