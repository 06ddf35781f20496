// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <std_msgs/String.h>

#include <cmath>
#include <fstream>

#include "cli/calibration_area.hpp"
#include "falko_slam/calibration/calibration_file.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/ros_bridge/bag_file.hpp"
#include "falko_slam/simulation/scenario_file.hpp"
#include "support/command.hpp"

namespace falko_slam {
namespace {

using test::falko;

// What the controller of the simulated vehicle believes.
const std::vector<std::string> kNominal = {
    "--driving-scale", "2.5e-4", "--laser", "0.39", "0", "0"};

class CalibrateCommand : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    recordings_ = std::make_unique<test::TemporaryFolder>();
    bag_ = recordings_->file("drive.bag");
    ASSERT_EQ(falko({"simulate", test::kCalibrationArea, "--out", bag_}).exit_code, 0);
  }
  static void TearDownTestSuite() { recordings_.reset(); }

  static test::CommandResult calibrate(const std::string& recording,
                                       const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {"calibrate", recording};
    words.insert(words.end(), kNominal.begin(), kNominal.end());
    words.insert(words.end(), more.begin(), more.end());
    return falko(words);
  }

  static inline std::unique_ptr<test::TemporaryFolder> recordings_;
  static inline std::string bag_;
  test::TemporaryFolder folder_;
};

TEST_F(CalibrateCommand, FindsTheParametersOfTheVehicle) {
  const std::string file = folder_.file("agv.yaml");
  const auto result = calibrate(bag_, {"--out", file});
  ASSERT_EQ(result.exit_code, 0) << result.errors << result.output;
  const VehicleModel truth = read_scenario(test::kCalibrationArea).vehicle;
  const StoredCalibration found = read_calibration(file);
  const VehicleCalibration expected{truth.tricycle, 1.0, truth.base_T_laser};
  const CalibrationVector error = vector_of(found.calibration) - vector_of(expected);

  EXPECT_LT(std::abs(radians_to_degrees(error(0))), 0.06);
  EXPECT_LT(std::abs(radians_to_degrees(error(1))), 0.06);
  EXPECT_LT(std::abs(error(2)) / truth.tricycle.driving_scale, 1e-3);
  EXPECT_LT(std::abs(error(3)), 0.0015);
  EXPECT_LT(std::abs(error(4)), 0.003);
  EXPECT_LT(std::abs(radians_to_degrees(error(5))), 0.03);
  for (Eigen::Index i = 0; i < 6; ++i) {
    EXPECT_LT(std::abs(error(i)), 6.0 * std::sqrt(found.covariance(i, i))) << i;
  }
  EXPECT_TRUE(result.says("verdict: OK")) << result.output;
}

TEST_F(CalibrateCommand, RepeatsItself) {
  const auto once = calibrate(bag_);
  const auto again = calibrate(bag_);
  EXPECT_EQ(once.output, again.output);
}

TEST_F(CalibrateCommand, KeepsTheCalibrationThatWasThereAndStartsFromIt) {
  const std::string file = folder_.file("agv.yaml");
  ASSERT_EQ(calibrate(bag_, {"--out", file, "--date", "first"}).exit_code, 0);
  const auto second =
      falko({"calibrate", bag_, "--start", file, "--out", file, "--date", "second"});
  ASSERT_EQ(second.exit_code, 0) << second.errors;
  EXPECT_EQ(read_calibration(file).date, "second");
  EXPECT_EQ(read_calibration(previous_calibration_path(file)).date, "first");
}

TEST_F(CalibrateCommand, GivesNoNumberWhereTheDriveTellsNone) {
  const std::string scenario = folder_.write("straight.yaml", R"(world:
- wall: [[-20, -20], [20, -20], [20, 20], [-20, 20]]
  closed: true
- reflector: {at: [10, 8]}
- reflector: {at: [-9, 12]}
- reflector: {at: [4, -14]}
- reflector: {at: [-15, -6]}
drive:
- wait: {seconds: 2}
- arc: {wheel_speed: 0.5, steering: 0, way: 3}
- wait: {seconds: 2}
- arc: {wheel_speed: -0.5, steering: 0, way: 3}
- wait: {seconds: 2}
)");
  const std::string bag = folder_.file("straight.bag");
  ASSERT_EQ(falko({"simulate", scenario, "--out", bag}).exit_code, 0);
  const std::string file = folder_.file("agv.yaml");
  const auto result = calibrate(bag, {"--out", file});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(result.complains("the verdict is UNOBSERVABLE")) << result.errors;
  EXPECT_FALSE(result.says("mm/tick")) << result.output;
  EXPECT_FALSE(std::ifstream(file).is_open());
}

TEST_F(CalibrateCommand, SuspectsWhatIsBelievedWhereNoSegmentCanBeUsed) {
  const auto millimetres = falko({"calibrate", bag_, "--laser", "390", "0", "0"});
  EXPECT_NE(millimetres.exit_code, 0);
  EXPECT_NE(millimetres.output.find("segments can be used"), std::string::npos);
  EXPECT_NE(millimetres.output.find("check what is believed of the laser's place"),
            std::string::npos)
      << millimetres.output;
}

TEST_F(CalibrateCommand, NamesTheDefaultsItBelieves) {
  EXPECT_NE(calibrate(bag_).output.find("by default: --wheelbase\n"), std::string::npos);
  EXPECT_EQ(calibrate(bag_, {"--wheelbase", "1.358"}).output.find("by default"), std::string::npos);
}

TEST_F(CalibrateCommand, ListsTheTopicsOfABagThatHasNoDrive) {
  {
    BagFile bag(folder_.file("words.bag"), false);
    bag.write("words", Time(std::chrono::seconds(5)), std_msgs::String());
    bag.finish();
  }
  const auto result = calibrate(folder_.file("words.bag"));
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(result.complains("no falko_slam/TricycleEncoders: the bag has /words"))
      << result.errors;
}

TEST_F(CalibrateCommand, NamesARecordingThatIsNone) {
  const std::string text = folder_.write("notes.txt", "nothing\n");
  EXPECT_TRUE(calibrate(text).complains("notes.txt"));
  EXPECT_TRUE(calibrate(folder_.file("missing.bag")).complains("missing.bag"));
}

}  // namespace
}  // namespace falko_slam
