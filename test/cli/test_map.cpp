// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "falko_slam/localization/imk_file.hpp"
#include "falko_slam/localization/landmark_map.hpp"
#include "support/command.hpp"

namespace falko_slam {
namespace {

using test::falko;

// Two boxes with free corners in a hall.
constexpr char kHallWithDrive[] = R"(name: hall
start: [-4, 0, 0]
world:
- wall: [[-8, -5], [9, -5], [9, 6], [-8, 6]]
  closed: true
- {box: {at: [-1.0, 3.0], size: [1.2, 1.0]}}
- {box: {at: [2.5, -2.5], size: [1.0, 0.8]}}
- reflector: {at: [8.9, 2]}
vehicle:
  base_T_laser: {x: 0.39, y: 0, theta: 0}
drive:
- follow: {through: [[4, 0]], speed: 0.6}
)";

class MapCommand : public ::testing::Test {
 protected:
  MapCommand() {
    LandmarkMap map;
    map.landmarks.resize(1);
    map.landmarks[0].id = 41;
    map.landmarks[0].position = {8.9, 2.0};
    map.landmarks[0].name = "gate";
    write_landmark_map(reflectors_, map);
  }

  test::CommandResult build(const std::string& poses, const std::string& out) const {
    return falko({"map", "build", bag_, "--poses", poses, "--reflectors", reflectors_, "--out",
                  folder_.file(out)});
  }
  void simulate() const {
    ASSERT_EQ(falko({"simulate", folder_.write("hall.yaml", kHallWithDrive), "--out", bag_,
                     "--truth", truth_})
                  .exit_code,
              0);
  }

  test::TemporaryFolder folder_;
  std::string bag_ = folder_.file("drive.bag");
  std::string truth_ = folder_.file("truth.tum");
  std::string reflectors_ = folder_.file("reflectors.yaml");
};

TEST_F(MapCommand, BuildsTheCornersOfADriveBesideTheReflectors) {
  simulate();
  const auto result = build("ground_truth", "map.yaml");
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_TRUE(result.says("beside 1 landmarks that were known")) << result.output;

  const LandmarkMap map = read_landmark_map(folder_.file("map.yaml"));
  ASSERT_NE(map.find(41), nullptr);
  EXPECT_EQ(map.find(41)->name, "gate");
  const auto has_corner = [&](double x, double y) {
    for (const MapLandmark& landmark : map.landmarks) {
      if (landmark.kind == LandmarkKind::kFeature &&
          (landmark.position - Eigen::Vector2d(x, y)).norm() < 0.03) {
        return true;
      }
    }
    return false;
  };
  EXPECT_TRUE(has_corner(-1.6, 2.5));
  EXPECT_TRUE(has_corner(-0.4, 2.5));
  EXPECT_TRUE(has_corner(2.0, -2.1));
}

TEST_F(MapCommand, TakesPosesFromAFileAndIsRepeatable) {
  simulate();
  ASSERT_EQ(build(truth_, "a.yaml").exit_code, 0);
  ASSERT_EQ(build(truth_, "b.yaml").exit_code, 0);
  EXPECT_FALSE(read_landmark_map(folder_.file("a.yaml")).landmarks.size() < 4U);
  EXPECT_EQ(test::whole_file(folder_.file("a.yaml")), test::whole_file(folder_.file("b.yaml")));
}

TEST_F(MapCommand, SaysWhatIsMissing) {
  simulate();
  const auto no_topic = build("gps", "map.yaml");
  EXPECT_EQ(no_topic.exit_code, 1);
  EXPECT_TRUE(no_topic.complains("no geometry_msgs/PoseStamped on gps")) << no_topic.errors;
  const auto other_time = build(folder_.write("other.tum", "1e6 0 0 0 0 0 0 1\n"), "map.yaml");
  EXPECT_EQ(other_time.exit_code, 1);
  EXPECT_TRUE(other_time.complains("none of its scans has a pose in ")) << other_time.errors;
}

TEST_F(MapCommand, BuildsNoLayoutForItHoldsNoCorners) {
  const auto result = build("ground_truth", "map.imk");
  EXPECT_TRUE(result.complains("a layout holds no corners")) << result.errors;
}

TEST_F(MapCommand, InspectsAMap) {
  const auto result = falko({"map", "inspect", reflectors_});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(result.says("1 reflectors\n")) << result.output;
  EXPECT_TRUE(result.says("x from 8.900 to 8.900 m, y from 2.000 to 2.000 m")) << result.output;
  EXPECT_TRUE(result.says("1 of them claim no error at all")) << result.output;
  EXPECT_TRUE(result.says("0 features\n")) << result.output;
}

TEST_F(MapCommand, ConvertsAndSaysWhatIsLost) {
  const std::string imk = folder_.file("plant.imk"), yaml = folder_.file("plant.yaml");
  const auto there = falko({"map", "convert", reflectors_, imk});
  EXPECT_EQ(there.exit_code, 0) << there.errors;
  EXPECT_TRUE(there.says("lost: 0 features, 1 names")) << there.output;
  EXPECT_EQ(read_imk(imk).find(41)->position, Eigen::Vector2d(8.9, 2.0));
  const auto back = falko({"map", "convert", imk, yaml});
  EXPECT_TRUE(back.says("10 mm is taken for the standard deviation")) << back.output;
  EXPECT_EQ(read_landmark_map(yaml).find(41)->name, "");
  const auto again = falko({"map", "convert", imk, yaml});
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_TRUE(again.complains("exists already")) << again.errors;
  EXPECT_EQ(falko({"map", "convert", imk, yaml, "--force"}).exit_code, 0);
}

}  // namespace
}  // namespace falko_slam
