// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/imk_file.hpp"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

#include "falko_slam/common/whole_file.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

class ImkFile : public ::testing::Test {
 protected:
  LandmarkMap read(const std::string& text) const {
    return read_imk(folder_.write("plant.imk", text));
  }
  std::string complaint(const std::string& text) const {
    const std::string path = folder_.write("bad.imk", text);
    try {
      read_imk(path);
    } catch (const std::runtime_error& error) {
      const std::string what = error.what();
      EXPECT_EQ(what.find(path + ": "), 0U) << what;
      return what.substr(path.size() + 2);
    }
    return "no error";
  }

  test::TemporaryFolder folder_;
};

TEST_F(ImkFile, IsReadInMetres) {
  const LandmarkMap map = read(
      "# a comment\r\n"
      "globID\tx_mm\ty_mm\ttype\tsubtype\tsize_mm\tlayer1\r\n"
      "\r\n"
      "1 14740 -4211 1 2 60 0\r\n"
      "  12\t-8977\t+11527\t1\t1\t80\t0\t7\n");
  ASSERT_EQ(map.landmarks.size(), 2U);
  const MapLandmark& first = map.landmarks[0];
  EXPECT_EQ(first.id, 1);
  EXPECT_EQ(first.kind, LandmarkKind::kReflector);
  EXPECT_TRUE(first.position.isApprox(Eigen::Vector2d(14.740, -4.211), 1e-12));
  EXPECT_TRUE(first.covariance.isApprox(1e-4 * Eigen::Matrix2d::Identity(), 1e-12));
  EXPECT_DOUBLE_EQ(first.layout.diameter, 0.060);
  EXPECT_EQ(first.layout.subtype, 2);
  const MapLandmark& second = map.landmarks[1];
  EXPECT_TRUE(second.position.isApprox(Eigen::Vector2d(-8.977, 11.527), 1e-12));
  EXPECT_EQ(second.layout.layers, (std::vector<int>{0, 7}));
}

TEST_F(ImkFile, ComesBackAsItWent) {
  const std::string text =
      "globID x_mm y_mm type subtype size_mm layer1\n"
      "1 14740 -4211 1 2 60 0\n"
      "65534 -100000000 100000000 255 65535 65535 65535 1 2\n"
      "0 0 0 0 0 0 0\n";
  const std::string path = folder_.file("out.imk");
  EXPECT_EQ(write_imk(path, read(text)), 0U);
  EXPECT_EQ(read_whole_file(path), text);
}

TEST_F(ImkFile, KeepsAllItHoldsOnTheWayThroughYaml) {
  const std::string text =
      "globID x_mm y_mm type subtype size_mm layer1\n"
      "1 14740 -4211 1 2 60 0\n"
      "3 2563 -3788 1 1 80 0 4\n";
  write_landmark_map(folder_.file("plant.yaml"), read(text));
  write_imk(folder_.file("out.imk"), read_landmark_map(folder_.file("plant.yaml")));
  EXPECT_EQ(read_whole_file(folder_.file("out.imk")), text);
}

TEST_F(ImkFile, SaysWhichLineAndColumnIsWrong) {
  const std::vector<std::array<std::string, 2>> table = {
      {"", "holds no reflector"},
      {"# nothing\nglobID x_mm\n", "holds no reflector"},
      {"1 2 3\n", "line 1: must be globID x_mm y_mm type subtype size_mm layer1 [layer2 ...]"},
      {"1 2 3 1 2 80\n",
       "line 1: must be globID x_mm y_mm type subtype size_mm layer1 [layer2 ...]"},
      {"\n65535 0 0 1 2 80 0\n", "line 2: globID: must be a whole number in [0, 65534]"},
      {"-1 0 0 1 2 80 0\n", "line 1: globID: must be a whole number in [0, 65534]"},
      {"1 0.5 0 1 2 80 0\n", "line 1: x_mm: must be a whole number in [-100000000, 100000000]"},
      {"1 0 99999999999 1 2 80 0\n",
       "line 1: y_mm: must be a whole number in [-100000000, 100000000]"},
      {"1 0 0 reflector 2 80 0\n", "line 1: type: must be a whole number in [0, 255]"},
      {"1 0 0 1 -2 80 0\n", "line 1: subtype: must be a whole number in [0, 65535]"},
      {"1 0 0 1 2 80mm 0\n", "line 1: size_mm: must be a whole number in [0, 65535]"},
      {"1 0 0 1 2 80 +\n", "line 1: layer1: must be a whole number in [0, 65535]"},
      {"1 0 0 1 2 80 0 x\n", "line 1: layer2: must be a whole number in [0, 65535]"},
      {"1 0 0 1 2 80 0\n\n1 5 5 1 2 80 0\n", "line 3: globID: 1 is that of line 1"},
  };
  for (const auto& [text, expected] : table) EXPECT_EQ(complaint(text), expected) << text;
  EXPECT_THROW(read_imk(folder_.file("none.imk")), std::runtime_error);
}

TEST_F(ImkFile, HoldsReflectorsOnly) {
  LandmarkMap map = read("1 14740 -4211 1 2 60 0\n");
  const std::string path = folder_.file("out.imk");
  map.landmarks.push_back(map.landmarks[0]);
  map.landmarks[1].id = 70000;
  map.landmarks[1].kind = LandmarkKind::kFeature;
  EXPECT_EQ(write_imk(path, map), 1U);
  EXPECT_EQ(read_imk(path).landmarks.size(), 1U);
  const std::string before = read_whole_file(path);
  const auto error_of = [&](const LandmarkMap& wrong) {
    try {
      write_imk(path, wrong);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  map.landmarks[1].kind = LandmarkKind::kReflector;
  EXPECT_EQ(error_of(map), "landmarks[1].id = 70000: must be in [0, 65534]");
  EXPECT_EQ(error_of({}), "landmarks: there is no reflector among them");
  EXPECT_EQ(read_whole_file(path), before);
}

}  // namespace
}  // namespace falko_slam
