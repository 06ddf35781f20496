// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// SLAM on real recordings against hand-checked relations.
#include <gtest/gtest.h>

#include <fstream>

#include "falko_slam/evaluation/error_summary.hpp"
#include "falko_slam/evaluation/relations.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/geometry/trajectory_file.hpp"
#include "support/command.hpp"
#include "support/recordings.hpp"

namespace falko_slam {
namespace {

struct RecordedLog {
  const char* name;
  double translation;  // mean error, at most [m]
  double rotation;     // [deg]
};

void PrintTo(const RecordedLog& recording, std::ostream* out) { *out << recording.name; }

class RecordedSlam : public ::testing::TestWithParam<RecordedLog> {};

TEST_P(RecordedSlam, IsAsGoodAsItWas) {
  const RecordedLog& expected = GetParam();
  const std::string log = test::carmen_folder() + expected.name + ".clf.bz2";
  const std::string truth = test::carmen_folder() + expected.name + ".relations.gz";
  if (!std::ifstream(log) || !std::ifstream(truth)) {
    GTEST_SKIP() << log << " or " << truth << " is not there: set FALKO_SLAM_DATA to the folder "
                 << "that holds carmen/";
  }
  const test::TemporaryFolder folder;
  const auto result = test::falko({"slam", log, "--out", folder.path()});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const RelationErrors found =
      evaluate_relations(read_tum(folder.file("trajectory.tum")), read_relations(truth));
  EXPECT_LE(summarise(found.errors.translation).mean, expected.translation);
  EXPECT_LE(radians_to_degrees(summarise(found.errors.rotation).mean), expected.rotation);
  EXPECT_EQ(found.missing, 0U);
}
INSTANTIATE_TEST_SUITE_P(Carmen, RecordedSlam,
                         ::testing::Values(RecordedLog{"intel", 0.030, 0.6},
                                           RecordedLog{"fr079", 0.045, 0.6}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace falko_slam
