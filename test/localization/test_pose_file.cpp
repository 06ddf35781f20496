// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/pose_file.hpp"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "falko_slam/common/whole_file.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

SavedPose a_pose() {
  SavedPose saved;
  saved.stamp = Time(std::chrono::nanoseconds(1690000000123456789));
  saved.map_T_base.pose = Pose2(12.25, -1.0 / 3.0, -3.1);
  saved.map_T_base.covariance << 4e-4, 1e-5, -2e-6, 1e-5, 9e-4, 3e-6, -2e-6, 3e-6, 1e-5;
  saved.map = "3 landmarks, 0012abcd";
  return saved;
}

LandmarkMap three_landmarks() {
  LandmarkMap map;
  map.landmarks.resize(2);
  map.landmarks[1].id = 5;
  map.landmarks[1].position = {1.0, 2.0};
  return map;
}

class PoseFile : public ::testing::Test {
 protected:
  std::string complaint_with(const std::string& from, const std::string& to) const {
    write_saved_pose(path_, a_pose());
    std::string text = read_whole_file(path_);
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    const std::string bad = folder_.write("bad.yaml", text.replace(place, from.size(), to));
    try {
      read_saved_pose(bad);
    } catch (const std::runtime_error& error) {
      const std::string what = error.what();
      EXPECT_EQ(what.find(bad + ": "), 0U) << what;
      return what.substr(bad.size() + 2);
    }
    return "no error";
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("pose.yaml");
};

TEST_F(PoseFile, ComesBackAsItWent) {
  const SavedPose written = a_pose();
  write_saved_pose(path_, written);

  const SavedPose read = read_saved_pose(path_);

  EXPECT_EQ(read.stamp, written.stamp);
  EXPECT_EQ(read.map, written.map);
  EXPECT_EQ(read.map_T_base.pose.translation(), written.map_T_base.pose.translation());
  EXPECT_EQ(read.map_T_base.pose.theta(), written.map_T_base.pose.theta());
  EXPECT_EQ(read.map_T_base.covariance, written.map_T_base.covariance);
  EXPECT_EQ(folder_.names(), (std::set<std::string>{"pose.yaml"}));
}

TEST_F(PoseFile, SaysWhichKeyIsWrong) {
  const std::vector<std::array<std::string, 3>> table = {
      {"saved_pose_version: 1", "saved_pose_version: 7",
       "line 2: saved_pose_version: must be a whole number in [1, 1]"},
      {"stamp: \"1690000000.123456789\"", "stamp: \"noon\"",
       "line 4: stamp: must be a time in seconds"},
      {"pose: [12.25, ", "pose: [.nan, ", "line 5: pose[0]: must be a number in [-100000, 100000]"},
      {"covariance: [0.0004", "covariance: [-1",
       "line 6: covariance: must be the upper half of a positive semidefinite matrix"},
      {"complete: true", "complete: false", "line 7: complete: must be true"},
  };
  for (const auto& [from, to, complaint] : table) EXPECT_EQ(complaint_with(from, to), complaint);
  EXPECT_NE(complaint_with("complete: true\n", ""), "no error");
}

TEST_F(PoseFile, IsNotTouchedByWhatIsNoPose) {
  write_saved_pose(path_, a_pose());
  const std::string before = read_whole_file(path_);
  SavedPose bad = a_pose();
  bad.map_T_base.covariance(1, 1) = std::numeric_limits<double>::quiet_NaN();

  EXPECT_THROW(write_saved_pose(path_, bad), std::invalid_argument);

  EXPECT_EQ(read_whole_file(path_), before);
}

TEST(MapIdentity, IsThatOfThePlaces) {
  const std::string identity = identity_of(three_landmarks());
  LandmarkMap same = three_landmarks();
  std::swap(same.landmarks[0], same.landmarks[1]);
  same.landmarks[0].name = "gate";
  same.landmarks[0].covariance.setIdentity();
  LandmarkMap moved = three_landmarks();
  moved.landmarks[1].position.x() += 0.001;

  EXPECT_EQ(identity.find("2 landmarks, "), 0U) << identity;
  EXPECT_EQ(identity_of(same), identity);
  EXPECT_NE(identity_of(moved), identity);
}

TEST(SavedPoses, AreObjectedToWhenOfAnotherMapOrTime) {
  const SavedPose saved = a_pose();
  const auto age = [&](double seconds) {
    return objection_to(saved, saved.map, saved.stamp + from_seconds(seconds), from_seconds(60.0));
  };

  EXPECT_EQ(age(0.0), "");
  EXPECT_EQ(age(60.0), "");
  EXPECT_EQ(age(61.5), "it is 61.5 s old, more than 60.0 s");
  EXPECT_EQ(age(-2.0), "it is from the future, by 2.0 s");
  EXPECT_EQ(objection_to(saved, "4 landmarks, 1", saved.stamp, from_seconds(60.0)),
            "it is of another map: 3 landmarks, 0012abcd, not 4 landmarks, 1");
}

}  // namespace
}  // namespace falko_slam
