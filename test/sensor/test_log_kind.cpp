// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/sensor/log_kind.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

class LogKindOf : public ::testing::Test {
 protected:
  LogKind kind(const std::string& text, const std::string& name = "test.log") {
    return recognize_log(folder_.write(name, text));
  }
  std::string error_of(const std::string& path) {
    try {
      recognize_log(path);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "no error";
  }

  test::TemporaryFolder folder_;
};

TEST_F(LogKindOf, IsThatOfTheFirstLineThatBelongsToOne) {
  for (const char* line : {"FLASER 1 2", "ROBOTLASER1\t0", "ODOM 1", "VERTEX2 1", "PARAM a 1"}) {
    EXPECT_EQ(kind("# message_name [...]\n\nSYNC x\n" + std::string(line) + "\ntime: 1\n"),
              LogKind::kCarmen)
        << line;
  }
  EXPECT_EQ(kind("#kinematic_model: traction_drive_wheel\n"), LogKind::kTricycle);
  EXPECT_EQ(kind("#kinematic_model:\r\nODOM 1\n"), LogKind::kTricycle);
  EXPECT_EQ(kind("# a log\ntime: 1 ticks: 2 3\n"), LogKind::kTricycle);
}

TEST_F(LogKindOf, IsFoundInPackedFiles) {
  for (const char* name : {"test.log.gz", "test.log.bz2"}) {
    EXPECT_EQ(kind("ODOM 1\n", name), LogKind::kCarmen) << name;
    EXPECT_EQ(kind("time: 1\n", name), LogKind::kTricycle) << name;
  }
}

TEST_F(LogKindOf, DemandsWholeWords) {
  const std::string log = folder_.write("test.log", "ODOMETER 1\ntimes: 1\n ODOM 1\n");
  EXPECT_EQ(error_of(log), log +
                               ": neither a CARMEN log nor a tricycle's log: none of 3 lines "
                               "begins as theirs do");
}

TEST_F(LogKindOf, NamesAFileThatIsNone) {
  EXPECT_EQ(error_of(folder_.write("empty", "")).find(folder_.file("empty") + ": neither"), 0U);
  EXPECT_EQ(error_of(folder_.file("gone")).find(folder_.file("gone") + ": cannot be read"), 0U);
}

}  // namespace
}  // namespace falko_slam
