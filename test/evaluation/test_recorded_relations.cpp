// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The metric on real recordings: raw odometry against hand-checked relations.
#include <gtest/gtest.h>

#include <fstream>
#include <variant>

#include "falko_slam/evaluation/relations.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/geometry/trajectory_file.hpp"
#include "falko_slam/sensor/carmen_log.hpp"
#include "support/recordings.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

struct Recording {
  const char* name;
  std::size_t scans;
  std::size_t relations;
  double translation;  // mean error [m]
  double rotation;     // mean error [deg]
};

void PrintTo(const Recording& recording, std::ostream* out) { *out << recording.name; }

Trajectory odometry_of(const std::string& log) {
  CarmenLogReader reader(log);
  Trajectory odometry;
  while (const auto record = reader.next()) {
    const auto* scan = std::get_if<CarmenScan>(&*record);
    if (scan != nullptr) odometry.push_back({scan->stamp, scan->world_T_robot});
  }
  return odometry;
}

class RecordedRelations : public ::testing::TestWithParam<Recording> {};

TEST_P(RecordedRelations, RawOdometryHasItsKnownError) {
  const Recording& expected = GetParam();
  const std::string log = test::carmen_folder() + expected.name + ".clf.bz2";
  const std::string truth = test::carmen_folder() + expected.name + ".relations.gz";
  if (!std::ifstream(log) || !std::ifstream(truth)) {
    GTEST_SKIP() << log << " or " << truth << " is not there: set FALKO_SLAM_DATA to the folder "
                 << "that holds carmen/";
  }
  const test::TemporaryFolder folder;
  write_tum(folder.file("trajectory.tum"), odometry_of(log));

  const Trajectory trajectory = read_tum(folder.file("trajectory.tum"));
  const RelationErrors result = evaluate_relations(trajectory, read_relations(truth));

  EXPECT_EQ(trajectory.size(), expected.scans);
  EXPECT_EQ(result.compared.size(), expected.relations);
  EXPECT_EQ(result.missing, 0U);
  EXPECT_NEAR(summarise(result.errors.translation).mean, expected.translation, 0.005);
  EXPECT_NEAR(radians_to_degrees(summarise(result.errors.rotation).mean), expected.rotation, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Logs, RecordedRelations,
                         ::testing::Values(Recording{"intel", 13631, 2984, 7.37, 39.2},
                                           Recording{"fr079", 4934, 1685, 6.50, 30.3}),
                         [](const auto& which) { return std::string(which.param.name); });

}  // namespace
}  // namespace falko_slam
