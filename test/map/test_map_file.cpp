// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/map/map_file.hpp"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <limits>
#include <locale>
#include <set>
#include <stdexcept>

#include "falko_slam/common/whole_file.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

const GridMap kMap{3, 2, 0.1, {-1.0 / 3.0, 12345.678, 0.25}, {0, -1, 100, 10, 50, 70}};

std::string description(const std::string& more = "", const std::string& negate = "0") {
  return "image: map.pgm\nresolution: 0.05\norigin: [1, 2, 0]\nnegate: " + negate +
         "\noccupied_thresh: 0.65\nfree_thresh: 0.196\n" + more;
}

class MapFile : public ::testing::Test {
 protected:
  GridMap read(const std::string& yaml, const std::string& pgm) const {
    folder_.write("map.pgm", pgm);
    return read_map(folder_.write("map.yaml", yaml));
  }
  std::string error_of(const std::string& yaml, const std::string& pgm) const {
    try {
      read(yaml, pgm);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "no error";
  }
  std::string error_of_yaml(const std::string& yaml) const {
    return error_of(yaml, "P5 1 1 255 x");
  }
  std::string error_of_pgm(const std::string& pgm) const { return error_of(description(), pgm); }

  test::TemporaryFolder folder_;
};

void expect_same_frame(const GridMap& a, const GridMap& b) {
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.height, b.height);
  EXPECT_EQ(a.resolution, b.resolution);
  EXPECT_EQ(a.map_T_origin.x(), b.map_T_origin.x());
  EXPECT_EQ(a.map_T_origin.y(), b.map_T_origin.y());
  EXPECT_EQ(a.map_T_origin.theta(), b.map_T_origin.theta());
}

TEST_F(MapFile, IsWhatMapSaverWrites) {
  const GridMap map{2, 2, 0.05, {-1.5, 2.25, 0.0}, {0, 100, -1, 50}};
  write_map(folder_.file("floor.yaml"), map);
  EXPECT_EQ(read_whole_file(folder_.file("floor.yaml")),
            "image: floor.pgm\nresolution: 0.05\norigin: [-1.5, 2.25, 0]\nnegate: 0\n"
            "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  EXPECT_EQ(read_whole_file(folder_.file("floor.pgm")),
            "P5\n# CREATOR: falko_slam 0.05 m/pix\n2 2\n255\n\xCD\xCD\xFE" + std::string(1, '\0'));
  EXPECT_EQ(folder_.names(), (std::set<std::string>{"floor.pgm", "floor.yaml"}));
}

TEST_F(MapFile, ComesBackTrinary) {
  write_map(folder_.file("it's a: #map.yaml"), kMap);
  const GridMap map = read_map(folder_.file("it's a: #map.yaml"));
  expect_same_frame(map, kMap);
  EXPECT_EQ(map.cells, trinary(kMap).cells);
  EXPECT_EQ(map.cells, (std::vector<std::int8_t>{0, -1, 100, 0, -1, 100}));
}

TEST_F(MapFile, ComesBackWithAllProbabilitiesInRawMode) {
  MapFileParams params;
  params.mode = MapMode::kRaw;
  write_map(folder_.file("map.yaml"), kMap, params);
  const GridMap map = read_map(folder_.file("map.yaml"));
  expect_same_frame(map, kMap);
  EXPECT_EQ(map.cells, kMap.cells);
}

// Numbers with a comma would be another file.
TEST_F(MapFile, SpeaksNoLanguage) {
  class Comma : public std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  write_map(folder_.file("map.yaml"), kMap);
  const GridMap map = read_map(folder_.file("map.yaml"));
  std::locale::global(before);
  expect_same_frame(map, kMap);
}

TEST_F(MapFile, ReadsGrayValuesAsMapServerDoes) {
  const std::string pgm = "P5 5 1 255\n" + std::string("\x00\xFE\xCD\x40\xF0", 5);
  using Cells = std::vector<std::int8_t>;
  EXPECT_EQ(read(description(), pgm).cells, (Cells{100, 0, -1, 100, 0}));
  EXPECT_EQ(read(description("", "1"), pgm).cells, (Cells{0, 100, 100, -1, 100}));
  EXPECT_EQ(read(description("mode: scale\n"), pgm).cells, (Cells{100, 0, 1, 100, 0}));
  const std::string raw = "P5 3 1 255\n" + std::string("\x00\x64\xFF", 3);
  EXPECT_EQ(read(description("mode: raw\n"), raw).cells, (Cells{0, 100, -1}));
}

TEST_F(MapFile, ReadsCommentsAndOtherMaximaInPgmHeaders) {
  const GridMap map =
      read(description(), "P5# one\n#two\r\n 2 # three\n\t1\n15\n" + std::string("\x0F\0", 2));
  EXPECT_EQ(map.cells, (std::vector<std::int8_t>{0, 100}));
}

TEST_F(MapFile, TheUpperImageRowIsTheLastOfTheMap) {
  const GridMap map = read(description(), "P5 1 2 255\n" + std::string("\xFE\x00", 2));
  EXPECT_EQ(map.cells, (std::vector<std::int8_t>{100, 0}));
}

TEST_F(MapFile, ErrorsNameTheYamlFileAndTheLine) {
  const auto says = [this](const std::string& yaml, const std::string& what) {
    const std::string error = error_of_yaml(yaml);
    EXPECT_EQ(error.find(folder_.file("map.yaml") + ": "), 0U) << error;
    EXPECT_NE(error.find(what), std::string::npos) << error;
  };
  says("", "is not a map's YAML file");
  says("image: map.pgm\n", "resolution is missing");
  says("image: [\n", "line 2");
  says("image: map.pgm\nresolution: five\n", "line 2: resolution must be a number in");
  says("image: map.pgm\nresolution: -1\n", "line 2: resolution must be a number in");
  says("image: map.pgm\nresolution: .nan\n", "line 2: resolution must be a number in");
  says("image: map.pgm\nresolution: 1\norigin: [1, 2]\n", "line 3: origin must be [x, y, yaw]");
  says("image: map.pgm\nresolution: 1\norigin: [1, 2, a]\n", "line 3: yaw of origin must be");
  says(description("mode: new\n"), "line 7: mode must be trinary, scale or raw");
  says(description("", "perhaps"), "line 4: negate must be 0 or 1");
  says(std::string(100000, '['), "is too long");
}

TEST_F(MapFile, ErrorsNameTheImageAndWhatIsWrong) {
  const auto says = [this](const std::string& pgm, const std::string& what) {
    const std::string error = error_of_pgm(pgm);
    EXPECT_EQ(error.find(folder_.file("map.pgm") + ": "), 0U) << error;
    EXPECT_NE(error.find(what), std::string::npos) << error;
  };
  says("", "is not a binary PGM image (P5)");
  says("P2 1 1 255 0", "is not a binary PGM image (P5)");
  says("P5", "is not a binary PGM image (P5)");
  says("P5 # no end", "PGM width is not a number");
  says("P5 0 1 255 x", "PGM width is 0");
  says("P5 -1 1 255 x", "PGM width is not a number");
  says("P5 99999999999999999999999 1 255 x", "PGM width must be at most");
  says("P5 100000 100000 255 x", "PGM height must be at most");
  says("P5 10000 10000 255 x", "PGM of 10000 x 10000 pixels holds 1");
  says("P5 1 1 65535 xx", "8 bits");
  says("P5 1 1 255", "PGM header ends too early");
  says("P5 1 1 15 x", "PGM holds a value above its maximum");
  const std::string missing = [this] {
    try {
      read_map(folder_.write("lost.yaml", "image: none.pgm" + description().substr(14)));
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  }();
  EXPECT_EQ(missing.find(folder_.file("none.pgm") + ": cannot be read"), 0U) << missing;
}

TEST_F(MapFile, ErrorsNameTheGrayValueThatIsNoPercentage) {
  const std::string error =
      error_of(description("mode: raw\n"), "P5 1 1 255\n" + std::string("\x65"));
  EXPECT_NE(error.find("holds the value 101 in raw mode"), std::string::npos) << error;
}

TEST_F(MapFile, RefusesWhatIsNoMapOrNoName) {
  GridMap wrong = kMap;
  wrong.width = 4;
  EXPECT_THROW(write_map(folder_.file("map.yaml"), wrong), std::invalid_argument);
  wrong.width = std::numeric_limits<std::size_t>::max() / 2;
  EXPECT_THROW(write_map(folder_.file("map.yaml"), wrong), std::invalid_argument);
  wrong = kMap;
  wrong.cells[0] = 101;
  EXPECT_THROW(write_map(folder_.file("map.yaml"), wrong), std::invalid_argument);
  wrong = kMap;
  wrong.map_T_origin = {std::nan(""), 0.0, 0.0};
  EXPECT_THROW(write_map(folder_.file("map.yaml"), wrong), std::invalid_argument);
  for (const char* name : {"map", "map.pgm", ".yaml", "a\nb.yaml"}) {
    EXPECT_THROW(write_map(folder_.file(name), kMap), std::invalid_argument) << name;
  }
  MapFileParams scale;
  scale.mode = MapMode::kScale;
  EXPECT_THROW(write_map(folder_.file("map.yaml"), kMap, scale), std::invalid_argument);
  EXPECT_TRUE(folder_.names().empty());
}

}  // namespace
}  // namespace falko_slam
