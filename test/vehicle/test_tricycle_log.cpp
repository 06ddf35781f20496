// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/vehicle/tricycle_log.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "falko_slam/geometry/angles.hpp"
#include "support/temporary_folder.hpp"
#include "support/tricycle_lines.hpp"

namespace falko_slam {
namespace {

using test::tricycle_header;
using test::tricycle_line;

class TricycleLog : public ::testing::Test {
 protected:
  std::vector<TricycleRecord> read(const std::string& text, const std::string& name = "test.log") {
    TricycleLogReader reader(folder_.write(name, text));
    std::vector<TricycleRecord> records;
    while (const auto record = reader.next()) records.push_back(*record);
    report_ = reader.report();
    header_ = reader.header();
    return records;
  }
  std::string error_of(const std::string& text) {
    try {
      read(text);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "no error";
  }

  test::TemporaryFolder folder_;
  TricycleLogReport report_;
  TricycleLogHeader header_;
};

TEST_F(TricycleLog, ReadsItsHeader) {
  read(test::small_tricycle_log());
  EXPECT_EQ(header_.kinematic_model, "traction_drive_wheel");
  EXPECT_EQ(header_.steer_gain, 0.1);
  EXPECT_EQ(header_.traction_gain, 1.0);
  EXPECT_EQ(header_.axis_length, 1.4);
  EXPECT_EQ(header_.steer_offset, 0.02);
  EXPECT_EQ(header_.steer_ticks_per_turn, 8192U);
  EXPECT_EQ(header_.traction_ticks_per_turn, 5000U);
  EXPECT_EQ(header_.base_T_laser.x(), 1.5);
  EXPECT_EQ(header_.base_T_laser.y(), 0.25);
  EXPECT_NEAR(header_.base_T_laser.theta(), kPi / 2.0, 1e-12);
}

TEST_F(TricycleLog, TheHeaderDescribesAVehicle) {
  read(tricycle_header());
  const TricycleParams tricycle = tricycle_params_of(header_);
  EXPECT_EQ(tricycle.wheelbase, 1.4);
  EXPECT_EQ(tricycle.driving_scale, 2e-4);
  EXPECT_EQ(tricycle.steer_offset_forward, 0.02);
  EXPECT_EQ(tricycle.steer_offset_backward, 0.02);
  const EncoderParams encoders = encoder_params_of(header_);
  EXPECT_EQ(encoders.steer_ticks_per_turn, 8192U);
  EXPECT_EQ(encoders.steer_zero, 0U);
  EXPECT_EQ(encoders.steer_gain, 0.1);
  // Above half a turn of the encoder: clockwise, a tenth of it.
  EXPECT_NEAR(steering_of(encoders, 8192 - 512), -0.1 * kTwoPi / 16.0, 1e-15);
}

TEST_F(TricycleLog, AHeaderOfNoVehicleIsRefused) {
  read(tricycle_header());
  header_.axis_length = 0.0;
  header_.steer_gain = 0.0;
  EXPECT_THROW(tricycle_params_of(header_), std::invalid_argument);
  EXPECT_THROW(encoder_params_of(header_), std::invalid_argument);
}

TEST_F(TricycleLog, ReadsCountersPosesAndTimesToTheNanosecond) {
  const auto records = read(test::small_tricycle_log());
  ASSERT_EQ(records.size(), 3U);
  EXPECT_EQ(records[0].encoders.stamp, Time(std::chrono::nanoseconds(1668091584821040869)));
  EXPECT_EQ(records[0].encoders.steer_ticks, 290U);
  EXPECT_EQ(records[0].encoders.drive_ticks, 4294967290U);
  EXPECT_EQ(ticks_between(records[0].encoders.drive_ticks, records[1].encoders.drive_ticks), 10);
  EXPECT_EQ(records[0].start_T_laser.x(), 1e-05);
  EXPECT_EQ(records[0].start_T_laser.y(), -0.5);
  EXPECT_EQ(records[0].start_T_laser.theta(), 0.25);
  EXPECT_EQ(records[1].odom_T_base.x(), 0.002);
  EXPECT_EQ(records[1].odom_T_base.y(), -1e-8);
  EXPECT_EQ(records[1].odom_T_base.theta(), 0.1);
  EXPECT_EQ(describe(report_), "11 lines: 3 encoder readings with poses, 8 others");
}

TEST_F(TricycleLog, ReadsTimesOfAnyNumberOfDigits) {
  const auto time_of = [&](const std::string& text) {
    return read(tricycle_header() + tricycle_line(text, "1 1", "0 0 0", "0 0 0"))
        .at(0)
        .encoders.stamp;
  };
  EXPECT_EQ(time_of("12"), Time(std::chrono::seconds(12)));
  EXPECT_EQ(time_of("12.5"), Time(std::chrono::milliseconds(12500)));
  EXPECT_EQ(time_of("0.000000001"), Time(std::chrono::nanoseconds(1)));
  EXPECT_EQ(time_of("0.0000000019"), Time(std::chrono::nanoseconds(1)));
}

TEST_F(TricycleLog, ReadsPackedFilesAndThoseOfOtherSystems) {
  EXPECT_EQ(read(test::small_tricycle_log(), "test.log.gz").size(), 3U);
  EXPECT_EQ(read(test::small_tricycle_log(), "test.log.bz2").size(), 3U);
  std::string text;
  for (const char letter : test::small_tricycle_log()) {
    text += letter == '\n' ? "\r\n" : std::string(1, letter);
  }
  EXPECT_EQ(read(text).size(), 3U);
  EXPECT_EQ(header_.axis_length, 1.4);
}

TEST_F(TricycleLog, KeepsFileOrderAndCountsBackwardStamps) {
  std::string text = tricycle_header();
  for (const char* time : {"2", "1", "1", "3"})
    text += tricycle_line(time, "1 1", "0 0 0", "0 0 0");
  const auto records = read(text);
  ASSERT_EQ(records.size(), 4U);
  EXPECT_EQ(records[1].encoders.stamp, Time(std::chrono::seconds(1)));
  EXPECT_EQ(report_.backward_stamps, 1U);
}

TEST_F(TricycleLog, LeavesOutMalformedLinesAndNamesThem) {
  const auto records =
      read(tricycle_header() + tricycle_line("1", "1 1", "0 0 0", "0 0 0") +  // line 9
           "time: 1 ticks: 1 1 model_pose: 0 0 0\n" +                         // cut short
           tricycle_line("1", "1 1", "0 0 0", "0 0 0 0") +                    // too long
           tricycle_line("1", "-1 1", "0 0 0", "0 0 0") +                     // no counter
           tricycle_line("1", "1 4294967296", "0 0 0", "0 0 0") +             // beyond it
           tricycle_line("1", "1 1.5", "0 0 0", "0 0 0") +                    // half a tick
           tricycle_line("-1", "1 1", "0 0 0", "0 0 0") +                     // no such time
           tricycle_line("99999999999", "1 1", "0 0 0", "0 0 0") +            // nor this
           tricycle_line("9999999999", "1 1", "0 0 0", "0 0 0") +             // nor this
           tricycle_line("1", "1 1", "0 nan 0", "0 0 0") +                    // not finite
           tricycle_line("1", "1 1", "0 0 0", "x 0 0") +                      // not a number
           "ODOM 1 2 0 0 0 0 1.0 h 1\n\n# comment\n" +
           tricycle_line("1", "1 4294967295", "0 0 0", "0 0 0"));
  EXPECT_EQ(records.size(), 2U);
  EXPECT_EQ(report_.malformed_lines,
            (std::vector<std::size_t>{10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20}));
  EXPECT_EQ(report_.lines, 23U);
  EXPECT_EQ(report_.other, 10U);
  EXPECT_NE(describe(report_).find("11 malformed lines left out: 10 11 12 13 14 ..."),
            std::string::npos);
}

TEST_F(TricycleLog, SaysWhatItsHeaderLacks) {
  const std::string whole = tricycle_header();
  EXPECT_EQ(error_of(whole), "no error");
  const auto without = [&](const std::string& from, const std::string& to) {
    std::string text = whole;
    text.replace(text.find(from), from.size(), to);
    return error_of(text + tricycle_line("1", "1 1", "0 0 0", "0 0 0"));
  };
  const std::string begin = folder_.file("test.log") + ": no tricycle log: its header";
  EXPECT_EQ(without("kinematic_model", "model"), begin + " has no \"kinematic_model:\"");
  EXPECT_EQ(without("parameter_values", "values"), begin + " has no \"parameter_values:\"");
  EXPECT_EQ(without("1.4 0.02", "1.4"), begin + " has no value of \"steer_offset\"");
  EXPECT_EQ(without("Ktraction", "gain"), begin + " has no value of \"Ktraction\"");
  EXPECT_EQ(without("1.0 1.4", "one 1.4"), begin + " has no value of \"Ktraction\"");
  EXPECT_EQ(without("8192", "0"), begin + " has no number of ticks of \"steering\"");
  EXPECT_EQ(without("5000", "0.5"), begin + " has no number of ticks of \"traction_wheel\"");
  EXPECT_EQ(without("1.5, 0.25, 0", "1.5, 0.25"), begin + "'s \"translation:\" has not 3 numbers");
  EXPECT_EQ(without("0, 0, 0.7", "0, zero, 0.7"), begin + "'s \"rotation:\" has not 4 numbers");
  EXPECT_EQ(error_of(""), begin + " has no \"kinematic_model:\"");
}

TEST_F(TricycleLog, NamesItsParametersByTheirNamesNotByTheirPlaces) {
  std::string text = tricycle_header();
  const std::string names = "Ksteer Ktraction axis_length steer_offset";
  text.replace(text.find(names), names.size(), "axis_length steer_offset Ktraction Ksteer");
  read(text);
  EXPECT_EQ(header_.axis_length, 0.1);
  EXPECT_EQ(header_.steer_gain, 0.02);
}

TEST_F(TricycleLog, NamesAFileThatIsNotThere) {
  try {
    TricycleLogReader reader("/nowhere/dataset.txt");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()).find("/nowhere/dataset.txt: cannot be read"), 0U);
  }
}

}  // namespace
}  // namespace falko_slam
