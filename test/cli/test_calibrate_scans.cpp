// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The calibration of a simulated drive that sees no reflectors.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "cli/calibration_area.hpp"
#include "falko_slam/calibration/calibration_file.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/simulation/scenario_file.hpp"
#include "support/command.hpp"

namespace falko_slam {
namespace {

using test::falko;

// The shipped one without its reflectors, and with two arcs a phase.
std::string bare_scenario() {
  std::ifstream file(test::kCalibrationArea);
  std::ostringstream text;
  bool skip_wait = false;
  for (std::string line; std::getline(file, line);) {
    const auto has = [&](const char* word) { return line.find(word) != std::string::npos; };
    const bool wait = has("- wait:");
    if (has("- reflector:") || (wait && skip_wait)) continue;
    const bool arc = has("- arc:");
    const bool wanted =
        has("deg(24.4)") || has("deg(43.6)") || has("deg(-24.4)") || has("deg(-43.6)");
    skip_wait = arc && !wanted;
    if (!skip_wait) text << line << "\n";
  }
  return text.str();
}

class CalibrateFromScans : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    recordings_ = std::make_unique<test::TemporaryFolder>();
    scenario_ = recordings_->write("bare.yaml", bare_scenario());
    bag_ = recordings_->file("drive.bag");
    ASSERT_EQ(falko({"simulate", scenario_, "--out", bag_}).exit_code, 0);
  }
  static void TearDownTestSuite() { recordings_.reset(); }

  static test::CommandResult calibrate(const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {
        "calibrate", bag_, "--driving-scale", "2.5e-4", "--laser", "0.39", "0", "0"};
    words.insert(words.end(), more.begin(), more.end());
    return falko(words);
  }

  static inline std::unique_ptr<test::TemporaryFolder> recordings_;
  static inline std::string scenario_, bag_;
};

TEST_F(CalibrateFromScans, FindsTheParametersOfTheVehicle) {
  const std::string file = recordings_->file("agv.yaml");
  const auto result = calibrate({"--out", file});
  ASSERT_EQ(result.exit_code, 0) << result.errors << result.output;
  EXPECT_TRUE(result.says("egomotion from scans")) << result.output;
  EXPECT_FALSE(result.says("reflectors")) << result.output;
  EXPECT_TRUE(result.says("verdict: OK")) << result.output;
  const VehicleModel truth = read_scenario(scenario_).vehicle;
  const StoredCalibration found = read_calibration(file);
  const VehicleCalibration expected{truth.tricycle, 1.0, truth.base_T_laser};
  const CalibrationVector error = vector_of(found.calibration) - vector_of(expected);

  EXPECT_LT(std::abs(radians_to_degrees(error(0))), 0.06);
  EXPECT_LT(std::abs(radians_to_degrees(error(1))), 0.06);
  EXPECT_LT(std::abs(error(2)) / truth.tricycle.driving_scale, 1e-3);
  EXPECT_LT(std::abs(error(3)), 0.0006);
  EXPECT_LT(std::abs(error(4)), 0.001);
  EXPECT_LT(std::abs(radians_to_degrees(error(5))), 0.008);
  for (Eigen::Index i = 0; i < 6; ++i) {
    EXPECT_LT(std::abs(error(i)), 4.0 * std::sqrt(found.covariance(i, i))) << i;
  }
}

TEST_F(CalibrateFromScans, DoesAsItIsTold) {
  EXPECT_EQ(calibrate().output, calibrate({"--egomotion", "scans"}).output);

  const auto blind = calibrate({"--egomotion", "reflectors"});
  EXPECT_EQ(blind.exit_code, 1);
  EXPECT_TRUE(blind.says("egomotion from reflectors")) << blind.output;
  EXPECT_TRUE(blind.says("only 0 reflectors seen at both ends")) << blind.output;

  EXPECT_NE(calibrate({"--egomotion", "wishes"}).exit_code, 0);
}

TEST_F(CalibrateFromScans, NamesWhatIsMissing) {
  const auto result = calibrate({"--egomotion", "scans", "--scans", "front/scan"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(result.complains("no sensor_msgs/LaserScan on front/scan: the bag has "))
      << result.errors;
  const auto neither = calibrate({"--scans", "front/scan", "--reflectors", "front/reflectors"});
  EXPECT_TRUE(neither.complains("neither falko_slam/ReflectorArray nor sensor_msgs/LaserScan"))
      << neither.errors;
}

}  // namespace
}  // namespace falko_slam
