// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "support/carmen_lines.hpp"
#include "support/command.hpp"

namespace falko_slam {
namespace {

using nlohmann::json;
using test::falko;

// A hall with three reflectors; the laser is where the vehicle's axle is.
constexpr const char* kTwoReflectors = R"(
name: hall
start: [0, 0, 0]
vehicle:
  base_T_laser: {x: 0, y: 0, theta: 0}
  nominal_base_T_laser: {x: 0, y: 0, theta: 0}
world:
- wall: [[-8, -6], [9, -6], [9, 7], [-8, 7]]
  closed: true
- reflector: {at: [5, 1]}
- reflector: {at: [-3, 3]}
- reflector: {at: [2, -5]}
drive:
- wait: {seconds: 2}
)";

class DetectReflectors : public ::testing::Test {
 protected:
  std::string simulated(const std::string& scenario) const {
    const std::string bag = folder_.file("hall.bag");
    const auto result = falko({"simulate", folder_.write("hall.yaml", scenario), "--out", bag});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return bag;
  }

  test::TemporaryFolder folder_;
};

TEST_F(DetectReflectors, ListsThemForEveryScan) {
  const auto result = falko({"detect", simulated(kTwoReflectors), "--reflectors", "--json", "-"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const json list = json::parse(result.output);
  ASSERT_GT(list.size(), 10U);
  for (const json& scan : list) {
    ASSERT_EQ(scan.at("reflectors").size(), 3U);
    for (const json& reflector : scan.at("reflectors")) {
      const double x = reflector.at("x").get<double>(), y = reflector.at("y").get<double>();
      const double nearest = std::min({std::hypot(x - 5.0, y - 1.0), std::hypot(x + 3.0, y - 3.0),
                                       std::hypot(x - 2.0, y + 5.0)});
      EXPECT_LT(nearest, 0.04);
      EXPECT_NEAR(reflector.at("range").get<double>(), std::hypot(x, y), 1e-9);
      EXPECT_GT(reflector.at("time_offset").get<double>(), 0.0);
      EXPECT_LT(reflector.at("time_offset").get<double>(), 0.125);
      EXPECT_EQ(reflector.at("covariance").size(), 3U);
    }
  }
}

TEST_F(DetectReflectors, PrintsFigures) {
  const auto result = falko({"detect", simulated(kTwoReflectors), "--reflectors"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_TRUE(result.says("3.00 per scan")) << result.output;
  EXPECT_TRUE(result.says("threshold at the end: ")) << result.output;
}

TEST_F(DetectReflectors, AreEvaluatedInASimulatedDrive) {
  const std::string scenario = folder_.write("hall.yaml", kTwoReflectors);
  const std::string path = folder_.file("figures.json");
  const auto result = falko({"evaluate", "reflectors", scenario, "--every", "2", "--json", path});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_TRUE(result.says("24 reflectors found, 0 of them where there is none")) << result.output;
  const json figures = json::parse(test::whole_file(path));
  EXPECT_EQ(figures.at("found").get<int>(), 24);
  EXPECT_EQ(figures.at("missed").get<int>(), 0);
  EXPECT_EQ(figures.at("bands").at(1).at("found").at("count").get<int>(), 8);
}

TEST_F(DetectReflectors, RefusesARecordingWithoutIntensities) {
  const std::string log =
      folder_.write("plain.log", test::flaser_line({2.0F, 2.0F, 2.0F}, {}, {}, 1.0));
  const auto result = falko({"detect", log, "--reflectors"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.errors, "falko: " + log +
                               ": the scan has no intensities: without them no reflector is found; "
                               "let the driver of the scanner publish them\n");
}

TEST_F(DetectReflectors, RefusesWhatMakesNoSense) {
  const auto alone = falko({"detect", "some.bag", "--diameter", "0.1"});
  EXPECT_NE(alone.exit_code, 0);
  EXPECT_TRUE(alone.complains("--reflectors")) << alone.errors;
  const auto huge = falko({"detect", "some.bag", "--reflectors", "--diameter", "80"});
  EXPECT_NE(huge.exit_code, 0);
  EXPECT_TRUE(huge.complains("--diameter: 80: must be a number in [0.01, 1]")) << huge.errors;
}

}  // namespace
}  // namespace falko_slam
