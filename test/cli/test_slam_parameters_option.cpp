// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "falko_slam/map/map_file.hpp"
#include "support/command.hpp"
#include "support/office_scenario.hpp"

namespace falko_slam {
namespace {

using test::falko;

class SlamParametersOption : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<test::TemporaryFolder>();
    const std::string scenario = folder_->write("office.yaml", test::office_scenario(1440));
    ASSERT_EQ(falko({"simulate", scenario, "--out", folder_->file("drive.bag")}).exit_code, 0);
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static test::CommandResult slam(const std::string& yaml, const std::string& out) {
    return falko({"slam", folder_->file("drive.bag"), "--out", folder_->file(out), "--parameters",
                  folder_->write(out + ".yaml", yaml)});
  }

  static inline std::unique_ptr<test::TemporaryFolder> folder_;
};

TEST_F(SlamParametersOption, IsTakenByName) {
  const auto result = slam("map:\n  resolution: 0.2\n", "coarse");
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(read_map(folder_->file("coarse/map.yaml")).resolution, 0.2);
}

TEST_F(SlamParametersOption, WarnsOfNamesThatNobodyReads) {
  const auto result = slam("tracker:\n  min_stepp: 0.4\nodom_frame: odom\n", "misspelt");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(result.complains("misspelt.yaml/tracker/min_stepp is not known")) << result.errors;
  EXPECT_FALSE(result.complains("odom_frame")) << result.errors;
}

TEST_F(SlamParametersOption, RefusesWrongValuesWithFileAndField) {
  const auto text = slam("tracker:\n  min_step: far\n", "text");
  EXPECT_EQ(text.exit_code, 1);
  EXPECT_TRUE(text.complains("text.yaml/tracker/min_step is a text, must be a number"))
      << text.errors;
  const auto range = slam("map:\n  resolution: 7.0\n", "range");
  EXPECT_EQ(range.exit_code, 1);
  EXPECT_TRUE(range.complains("range.yaml: ")) << range.errors;
  EXPECT_TRUE(range.complains("resolution = 7")) << range.errors;
  EXPECT_FALSE(folder_->names().count("range") > 0);
}

TEST_F(SlamParametersOption, NamesAFileThatIsNotThere) {
  const auto result = falko({"slam", folder_->file("drive.bag"), "--out", folder_->file("x"),
                             "--parameters", "/nowhere.yaml"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(result.complains("/nowhere.yaml: cannot be read")) << result.errors;
}

}  // namespace
}  // namespace falko_slam
