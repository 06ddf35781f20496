// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <fstream>

#include <nlohmann/json.hpp>

#include "falko_slam/pose_graph/g2o_file.hpp"
#include "support/command.hpp"
#include "support/simulated_graphs.hpp"

namespace falko_slam {
namespace {

using nlohmann::json;
using test::falko;

class OptimizeCommand : public ::testing::Test {
 protected:
  void SetUp() override {
    auto random = test::seeded_random();
    town_ = test::drive_grid(300, {}, random).graph;
    in_ = folder_.file("in.g2o.gz");
    out_ = folder_.file("out.g2o");
    write_g2o(in_, town_);
  }

  test::TemporaryFolder folder_;
  PoseGraph town_;
  std::string in_, out_;
};

TEST_F(OptimizeCommand, WritesTheOptimisedGraph) {
  const auto result = falko({"optimize", in_, out_, "--json", folder_.file("figures.json")});

  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_TRUE(result.says("300 nodes"));
  EXPECT_TRUE(result.says("converged"));
  const json figures = json::parse(test::whole_file(folder_.file("figures.json")));
  EXPECT_LT(figures["chi2"], figures["given_chi2"]);
  EXPECT_NEAR(chi2_of(read_g2o(out_).graph), figures["chi2"], 1e-6);
}

TEST_F(OptimizeCommand, ComesToTheSameFromEdgesAlone) {
  std::ofstream edges(folder_.file("edges.g2o"));
  write_g2o(folder_.file("whole.g2o"), town_);
  std::ifstream whole(folder_.file("whole.g2o"));
  for (std::string line; std::getline(whole, line);) {
    if (line.rfind("EDGE", 0) == 0) edges << line << "\n";
  }
  edges.close();

  const auto given = falko({"optimize", in_, out_, "--guess", "given", "--json", "-"});
  const auto alone = falko({"optimize", folder_.file("edges.g2o"), out_, "--json", "-"});

  EXPECT_NEAR(json::parse(given.output)["chi2"], json::parse(alone.output)["chi2"], 1e-6);
  const auto refused = falko({"optimize", folder_.file("edges.g2o"), out_, "--guess", "given"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_TRUE(refused.complains("holds no poses to start from"));
}

TEST_F(OptimizeCommand, LeavesOutWhatContradicts) {
  GraphConstraint wrong = town_.constraints.back();
  wrong.kind = ConstraintKind::kClosure;
  wrong.from = {20};
  wrong.to = {280};
  wrong.from_T_to = Pose2(0.0, 0.0, 1.0);
  town_.constraints.push_back(wrong);
  write_g2o(in_, town_);

  const auto result = falko({"optimize", in_, out_, "--select-consistent"});

  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_TRUE(result.says("1 closures against_odometry"));
}

TEST_F(OptimizeCommand, NamesWhatIsWrong) {
  EXPECT_EQ(falko({"optimize", in_}).exit_code, 106);
  EXPECT_TRUE(falko({"optimize", folder_.file("none"), out_}).complains("none: cannot be read"));
  town_.constraints.erase(town_.constraints.begin(), town_.constraints.begin() + 5);
  write_g2o(in_, town_);
  const auto result = falko({"optimize", in_, out_});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(result.complains("the graph falls into"));
  EXPECT_EQ(folder_.names().count("out.g2o"), 0U);
}

}  // namespace
}  // namespace falko_slam
