// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/closure_check.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "falko_slam/common/whole_file.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

PoseGraph three_nodes() {
  PoseGraph graph;
  graph.nodes = {{{0}, Pose2()}, {{1}, Pose2(1.0, 0.0, 0.0)}, {{2}, Pose2(1.0, 2.0, 1.0)}};
  return graph;
}

std::string error_of(const std::string& path) {
  try {
    check_closures(path, three_nodes());
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(ClosureCheck, TellsWhichClosuresAreOffThePoses) {
  const test::TemporaryFolder folder;
  write_whole_file(folder.file("closures.csv"),
                   "x,y,theta,verdict,source,target\n"
                   "1.0,0.1,0.0,accepted,1,0\n"
                   "1.0,2.0,0.8,accepted,2,0\n"
                   "0.4,0.0,0.0,accepted,1,0\n"
                   "9.0,0.0,0.0,pending,1,0\n");
  const ClosureCheck check = check_closures(folder.file("closures.csv"), three_nodes());
  EXPECT_EQ(check.accepted, 3U);
  EXPECT_EQ(check.refused, 1U);
  EXPECT_EQ(check.far_off, 2U);
  EXPECT_NEAR(check.errors.translation.at(0), 0.1, 1e-12);
  EXPECT_NEAR(check.errors.rotation.at(1), 0.2, 1e-12);
  EXPECT_NEAR(check.errors.translation.at(2), 0.6, 1e-12);
}

TEST(ClosureCheck, BadTablesAreNamedWithTheirLine) {
  const test::TemporaryFolder folder;
  const std::string head = "source,target,verdict,x,y,theta\n";
  const auto error = [&](const std::string& text) {
    write_whole_file(folder.file("bad.csv"), text);
    return error_of(folder.file("bad.csv"));
  };
  EXPECT_NE(error("source,target\n").find("bad.csv: line 1"), std::string::npos);
  EXPECT_NE(error(head + "1,0,accepted,1\n").find("bad.csv: line 2"), std::string::npos);
  EXPECT_NE(error(head + "1,0,accepted,1,one,0\n").find("line 2"), std::string::npos);
  EXPECT_NE(error(head + "1,0,accepted,1,0,0\n1,7,accepted,1,0,0\n").find("line 3"),
            std::string::npos);
  EXPECT_NE(error_of(folder.file("none.csv")).find("none.csv"), std::string::npos);
}

}  // namespace
}  // namespace falko_slam
