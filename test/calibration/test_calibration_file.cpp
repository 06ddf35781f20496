// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/calibration_file.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "calibration/arc_drives.hpp"
#include "falko_slam/calibration/monte_carlo.hpp"
#include "falko_slam/common/whole_file.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

CalibrationResult a_result() {
  auto random = test::seeded_random();
  auto segments = simulate_calibration_drive(thesis_conditions()[0], MonteCarloParams(), random);
  CalibratorParams params;
  params.limits.laser_position = 1e-6;  // so that there are remarks
  return calibrate(segments, params);
}

StoredCalibration a_calibration() {
  return stored_calibration(a_result(), TricycleModel::kAsymmetric, "2024-05-31T12:00:00Z");
}

std::string complaint(const std::string& path) {
  try {
    read_calibration(path);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

class CalibrationFile : public ::testing::Test {
 protected:
  CalibrationFile() { write_calibration(path_, a_calibration()); }

  // The file with one text in the place of another, and what is said about it.
  std::string damaged(const std::string& from, const std::string& to) {
    std::string text = read_whole_file(path_);
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    text.replace(place, from.size(), to);
    return complaint(folder_.write("damaged.yaml", text));
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("agv.yaml");
};

TEST_F(CalibrationFile, ComesBackAsItWent) {
  const StoredCalibration written = a_calibration(), read = read_calibration(path_);

  EXPECT_EQ(read.date, written.date);
  EXPECT_EQ(read.model, written.model);
  EXPECT_EQ(read.verdict, CalibrationVerdict::kWeak);
  EXPECT_EQ(vector_of(read.calibration), vector_of(written.calibration));
  EXPECT_EQ(read.covariance, written.covariance);
  for (std::size_t i = 0; i < kCalibrationParameters; ++i) {
    EXPECT_EQ(read.intervals[i].low, written.intervals[i].low);
    EXPECT_EQ(read.intervals[i].high, written.intervals[i].high);
  }
  EXPECT_EQ(read.conditions.segments, 8);
  EXPECT_EQ(read.conditions.left_out, 0);
  EXPECT_EQ(read.conditions.chi2, written.conditions.chi2);
  EXPECT_EQ(read.conditions.degrees_of_freedom, 18);
  EXPECT_EQ(read.conditions.laser_condition, written.conditions.laser_condition);
  EXPECT_FALSE(read.remarks.empty());
  EXPECT_EQ(read.remarks, written.remarks);
}

TEST_F(CalibrationFile, KeepsTextsWithQuotesAndBackslashes) {
  StoredCalibration stored = a_calibration();
  stored.date = "\"yesterday\", c:\\no: # #";
  stored.remarks = {"one: two", "- three"};
  write_calibration(path_, stored);
  EXPECT_EQ(read_calibration(path_).date, stored.date);
  EXPECT_EQ(read_calibration(path_).remarks, stored.remarks);
}

TEST_F(CalibrationFile, KeepsThePreviousOne) {
  EXPECT_EQ(folder_.names(), (std::set<std::string>{"agv.yaml"}));
  StoredCalibration next = a_calibration();
  next.date = "tomorrow";

  write_calibration(path_, next);

  EXPECT_EQ(folder_.names(), (std::set<std::string>{"agv.yaml", "agv.previous.yaml"}));
  EXPECT_EQ(read_calibration(path_).date, "tomorrow");
  EXPECT_EQ(read_calibration(previous_calibration_path(path_)).date, "2024-05-31T12:00:00Z");
}

TEST_F(CalibrationFile, IsNotTouchedByWhatIsNoCalibration) {
  const std::string before = read_whole_file(path_);
  StoredCalibration wrong = a_calibration();
  wrong.calibration.tricycle.wheelbase = 0.0;
  EXPECT_THROW(write_calibration(path_, wrong), std::invalid_argument);
  wrong = a_calibration();
  wrong.covariance(0, 0) = -1.0;
  EXPECT_THROW(write_calibration(path_, wrong), std::invalid_argument);
  wrong = a_calibration();
  wrong.verdict = CalibrationVerdict::kUnobservable;
  EXPECT_THROW(write_calibration(path_, wrong), std::invalid_argument);
  EXPECT_THROW(stored_calibration(calibrate({}), TricycleModel::kStandard, ""),
               std::invalid_argument);
  EXPECT_EQ(read_whole_file(path_), before);
  EXPECT_EQ(folder_.names(), (std::set<std::string>{"agv.yaml"}));
}

TEST_F(CalibrationFile, SaysWhichFileLineAndKeyIsWrong) {
  EXPECT_NE(damaged("driving_scale: ", "driving_scale: x")
                .find("damaged.yaml: line 10: "
                      "parameters.driving_scale"),
            std::string::npos)
      << damaged("driving_scale: ", "driving_scale: x");
  EXPECT_NE(damaged("wheelbase: 1.358", "wheelbase: -1").find("parameters.wheelbase = -1"),
            std::string::npos);
  EXPECT_NE(damaged("verdict: WEAK", "verdict: UNOBSERVABLE").find("must be OK or WEAK"),
            std::string::npos);
  EXPECT_NE(damaged("calibration_version: 1", "calibration_version: 2").find("line 3"),
            std::string::npos);
  EXPECT_NE(damaged("laser_y", "laser_z").find("laser_y is missing"), std::string::npos);
  EXPECT_NE(damaged("model: ", "colour: red\nmodel: ").find("colour"), std::string::npos);
  EXPECT_NE(damaged("  - [", "  - [0, ").find("covariance"), std::string::npos);
  EXPECT_NE(damaged("  - [", "  - [-").find("covariance"), std::string::npos);
  EXPECT_NE(damaged("complete: true", "complete: false").find("must be true"), std::string::npos);
  EXPECT_NE(complaint(folder_.file("none.yaml")).find("none.yaml"), std::string::npos);
  EXPECT_NE(complaint(folder_.write("empty.yaml", "")).find("empty.yaml"), std::string::npos);
}

TEST_F(CalibrationFile, IsRefusedWhereverItIsCutOff) {
  const std::string text = read_whole_file(path_);
  const std::size_t end = text.find("complete: true") + std::string("complete: true").size();
  for (std::size_t length = 0; length < end; length += 7) {
    EXPECT_NE(complaint(folder_.write("cut.yaml", text.substr(0, length))), "") << length;
  }
  EXPECT_NE(complaint(folder_.write("cut.yaml", text.substr(0, end - 1))), "");
}

}  // namespace
}  // namespace falko_slam
