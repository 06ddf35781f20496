// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/sensor/mrclam_log.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

class MrclamLog : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_.write("Barcodes.dat", "# Subject # Barcode #\n  1  5\n  6  72\n");
    folder_.write("Landmark_Groundtruth.dat.gz", "# comment\n 6 1.5 -2.5 0.01 0.02\n");
    folder_.write("Robot2_Odometry.dat", "0 0.1 -0.2\n0.02 0 0\n");
    folder_.write("Robot2_Groundtruth.dat", "0 1 2 3\n");
    folder_.write("Robot2_Measurement.dat", "-1.5 72 2.5 0.3\n0.5 5 1 0\n0.6 99 1 0\n");
  }

  void expect_failure(const std::string& file, const std::string& text, const std::string& what) {
    folder_.write(file, text);
    try {
      read_mrclam(folder_.path(), 2);
      FAIL() << what;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find(file + what), std::string::npos) << error.what();
    }
  }

  test::TemporaryFolder folder_;
};

TEST_F(MrclamLog, IsReadWithLandmarksByTheirBarcodes) {
  const MrclamRun run = read_mrclam(folder_.path(), 2);
  ASSERT_EQ(run.odometry.size(), 2U);
  EXPECT_EQ(run.odometry[1].stamp, Time(std::chrono::milliseconds(20)));
  EXPECT_EQ(run.odometry[0].turn_rate, -0.2);
  ASSERT_EQ(run.measurements.size(), 1U);
  EXPECT_EQ(run.measurements[0].stamp, Time(std::chrono::milliseconds(-1500)));
  EXPECT_EQ(run.measurements[0].landmark, 6U);
  EXPECT_EQ(run.measurements[0].range, 2.5);
  EXPECT_EQ(run.other_measurements, 2U);
  ASSERT_EQ(run.landmarks.size(), 1U);
  EXPECT_NEAR(run.landmarks[0].position.covariance(1, 1), 4e-4, 1e-15);
  EXPECT_EQ(run.truth.at(0).map_T_base.y(), 2.0);
}

TEST_F(MrclamLog, NamesFileAndLineOfWhatIsWrong) {
  expect_failure("Robot2_Odometry.dat", "0 0 0\n1 x 0\n", ": line 2: \"x\" is no number");
  expect_failure("Robot2_Odometry.dat", "0 0\n", ": line 1: 2 numbers, not 3");
  expect_failure("Robot2_Odometry.dat", "1e300 0 0\n", ": line 1: no time");
  expect_failure("Robot2_Odometry.dat", "nan 0 0\n", ": line 1: \"nan\" is no number");
  folder_.write("Robot2_Odometry.dat", "0 0 0\n");
  expect_failure("Robot2_Measurement.dat", "0 72 -1 0\n", ": line 1: a range");
  expect_failure("Robot2_Measurement.dat", "0 72.5 1 0\n", ": line 1: no subject");
}

TEST_F(MrclamLog, NamesTheFileThatIsMissing) {
  try {
    read_mrclam(folder_.path(), 3);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("Robot3_Odometry.dat"), std::string::npos);
  }
}

}  // namespace
}  // namespace falko_slam
