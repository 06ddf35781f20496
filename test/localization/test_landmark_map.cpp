// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/landmark_map.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "falko_slam/common/whole_file.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

LandmarkMap a_map() {
  LandmarkMap map;
  MapLandmark reflector;
  reflector.id = 7;
  reflector.position = {14.74, -1.0 / 3.0};
  reflector.covariance << 1e-4, -2e-5, -2e-5, 4e-4;
  reflector.hits = 12;
  reflector.name = "gate \"3\", c:\\left # one";
  reflector.layout = {0.06, 1, 2, {0, 3}};
  MapLandmark corner;
  corner.id = 0;
  corner.kind = LandmarkKind::kFeature;
  corner.position = {-2.0, 1e-7};
  map.landmarks = {reflector, corner};
  return map;
}

class LandmarkMapFile : public ::testing::Test {
 protected:
  LandmarkMapFile() { write_landmark_map(path_, a_map()); }

  std::string complaint(const std::string& text) const {
    const std::string path = folder_.write("bad.yaml", text);
    try {
      read_landmark_map(path);
    } catch (const std::runtime_error& error) {
      const std::string what = error.what();
      EXPECT_EQ(what.find(path + ": "), 0U) << what;
      return what.substr(path.size() + 2);
    }
    return "no error";
  }
  std::string with(const std::string& from, const std::string& to) const {
    std::string text = read_whole_file(path_);
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    return complaint(text.replace(place, from.size(), to));
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("plant.yaml");
};

TEST_F(LandmarkMapFile, ComesBackAsItWent) {
  const LandmarkMap written = a_map(), read = read_landmark_map(path_);
  ASSERT_EQ(read.landmarks.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read.landmarks[i].id, written.landmarks[i].id);
    EXPECT_EQ(read.landmarks[i].kind, written.landmarks[i].kind);
    EXPECT_EQ(read.landmarks[i].position, written.landmarks[i].position);
    EXPECT_EQ(read.landmarks[i].covariance, written.landmarks[i].covariance);
    EXPECT_EQ(read.landmarks[i].hits, written.landmarks[i].hits);
    EXPECT_EQ(read.landmarks[i].name, written.landmarks[i].name);
  }
  EXPECT_EQ(read.landmarks[0].layout.diameter, 0.06);
  EXPECT_EQ(read.landmarks[0].layout.layers, (std::vector<int>{0, 3}));
  const std::string once = read_whole_file(path_);
  write_landmark_map(path_, read);
  EXPECT_EQ(read_whole_file(path_), once);
}

TEST_F(LandmarkMapFile, MayBeEmptyOrShort) {
  write_landmark_map(path_, {});
  EXPECT_TRUE(read_landmark_map(path_).landmarks.empty());
  const std::string path = folder_.write("short.yaml",
                                         "landmark_map_version: 1\n"
                                         "landmarks:\n"
                                         "- {id: 3, kind: reflector, position: [1, 2], "
                                         "covariance: [0, 0, 0]}\n"
                                         "complete: true\n");
  const LandmarkMap map = read_landmark_map(path);
  ASSERT_NE(map.find(3), nullptr);
  EXPECT_EQ(map.find(3)->layout.diameter, 0.08);
  EXPECT_EQ(map.find(4), nullptr);
}

TEST_F(LandmarkMapFile, HoldsThousandsOfLandmarks) {
  LandmarkMap map;
  for (int i = 0; i < 5000; ++i) {
    map.landmarks.push_back(a_map().landmarks[1]);
    map.landmarks.back().id = i;
  }
  write_landmark_map(path_, map);
  EXPECT_EQ(read_landmark_map(path_).landmarks.size(), 5000U);
}

TEST_F(LandmarkMapFile, SaysWhichLineAndKeyIsWrong) {
  const std::vector<std::array<std::string, 3>> table = {
      {"landmark_map_version: 1", "landmark_map_version: 2",
       "line 2: landmark_map_version: must be a whole number in [1, 1]"},
      {"id: 7, ", "", "line 4: landmarks[0]: id is missing"},
      {"id: 7", "id: -7", "line 4: landmarks[0].id: must be a whole number in [0, 1000000000]"},
      {"id: 0", "id: 7", "line 5: landmarks[1]: id 7 is that of landmarks[0]"},
      {"kind: feature", "kind: corner", "line 5: landmarks[1].kind: must be reflector or feature"},
      {"position: [-2,", "position: [", "line 5: landmarks[1].position: must be two numbers"},
      {"position: [-2,", "position: [x,",
       "line 5: landmarks[1].position[0]: must be a number in [-100000, 100000]"},
      {"covariance: [0, 0, 0]", "covariance: [1, 2, 1]",
       "line 5: landmarks[1].covariance: must be [xx, xy, yy] of a positive semidefinite matrix"},
      {"covariance: [0, 0, 0]", "covariance: [-1, 0, 1]",
       "line 5: landmarks[1].covariance: must be [xx, xy, yy] of a positive semidefinite matrix"},
      {"hits: 12", "hits: -1", "line 4: landmarks[0].hits = -1: must be in [0, 1000000000]"},
      {"type: 1", "type: 256", "line 4: landmarks[0].type = 256: must be in [0, 255]"},
      {"layers: [0, 3]", "layers: []", "line 4: landmarks[0].layers: must have at least one"},
      {"hits: 0", "colour: red",
       "line 5: landmarks[1].colour: nobody knows this; known are id, kind, position, covariance, "
       "hits and name"},
      {"complete: true", "complete: false", "line 6: complete: must be true"},
      {"complete: true\n", "", "line 2: complete is missing"},
  };
  for (const auto& [from, to, complaint] : table) EXPECT_EQ(with(from, to), complaint);
  EXPECT_EQ(complaint(""), "is empty");
}

TEST_F(LandmarkMapFile, IsRefusedWhereverItIsCutOff) {
  const std::string text = read_whole_file(path_);
  for (std::size_t length = 0; length + 1 < text.size(); length += 5) {
    EXPECT_NE(complaint(text.substr(0, length)), "no error") << length;
  }
}

TEST_F(LandmarkMapFile, IsNotTouchedByWhatIsNoMap) {
  const std::string before = read_whole_file(path_);
  const auto error_of = [&](auto&& change) {
    LandmarkMap map = a_map();
    change(map.landmarks);
    try {
      write_landmark_map(path_, map);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_EQ(error_of([](auto& all) { all[1].id = 7; }),
            "landmarks[1].id = 7: landmarks[0] has it already");
  EXPECT_EQ(error_of([](auto& all) { all[1].hits = -1; }),
            "landmarks[1].hits = -1: must be in [0, 1000000000]");
  EXPECT_EQ(error_of([](auto& all) { all[0].position.x() = std::nan(""); }),
            "landmarks[0].position.x = nan: must be in [-100000, 100000]");
  EXPECT_EQ(error_of([](auto& all) { all[0].covariance(0, 0) = -1.0; }),
            "landmarks[0].covariance: must be symmetric and positive semidefinite");
  EXPECT_EQ(error_of([](auto& all) { all[0].layout.layers.clear(); }),
            "landmarks[0].layers: must have at least one");
  EXPECT_EQ(error_of([](auto& all) { all[0].name.assign(std::size_t{1} << 20U, 'x'); }),
            "landmarks: 2 are too many for a file of 1 MiB");
  EXPECT_EQ(read_whole_file(path_), before);
  EXPECT_EQ(folder_.names(), (std::set<std::string>{"plant.yaml"}));
}

}  // namespace
}  // namespace falko_slam
