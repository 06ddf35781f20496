// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Graphs that are published with their optima, in g2o's convention.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "falko_slam/pose_graph/g2o_file.hpp"
#include "falko_slam/pose_graph/initial_guess.hpp"
#include "falko_slam/pose_graph/optimizer.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

std::string graph_file(const std::string& name) {
  const char* folder = std::getenv("FALKO_SLAM_DATA");
  return std::string(folder ? folder : FALKO_SLAM_SOURCE_DIR "/../shared/data") + "/pose_graphs/" +
         name + ".g2o.gz";
}

struct Published {
  const char* name;
  double chi2;
};

class RecordedGraphs : public ::testing::TestWithParam<Published> {
 protected:
  void SetUp() override {
    if (!std::ifstream(graph_file(GetParam().name))) {
      GTEST_SKIP() << graph_file(GetParam().name) << " is not there: set FALKO_SLAM_DATA to the "
                   << "folder that holds pose_graphs/";
    }
  }
};

double optimum(const PoseGraph& graph) {
  OptimizerParams params;
  params.closure_loss = Loss::kNone;
  PoseGraphOptimizer optimizer(graph, params);
  const OptimizationSummary summary = optimizer.optimize();
  EXPECT_TRUE(summary.converged) << summary.message;
  return summary.final_chi2;
}

TEST_P(RecordedGraphs, ReachTheirOptimumFromTheEdgesAlone) {
  const G2oFile file = read_g2o(graph_file(GetParam().name));
  EXPECT_NEAR(optimum(guess_poses(file.graph, Guess::kComputed).graph), GetParam().chi2, 1e-3);
}

TEST_P(RecordedGraphs, ReachTheirOptimumFromTheBetterStart) {
  const G2oFile file = read_g2o(graph_file(GetParam().name));
  EXPECT_NEAR(optimum(guess_poses(file.graph, Guess::kBetter).graph), GetParam().chi2, 1e-3);
}

// The noise of m3500 is 0.15 of what its information states (chi2 138 of 5862): measured anew,
// about its optimum, with three times that, and with what is stated.
TEST(NoisyM3500, EndsNoHigherThanFromASpanningTree) {
  const std::string path = graph_file("m3500");
  if (!std::ifstream(path)) GTEST_SKIP() << path << " is not there: set FALKO_SLAM_DATA";
  PoseGraphOptimizer optimizer(guess_poses(read_g2o(path).graph, Guess::kComputed).graph);
  optimizer.optimize();
  auto random = test::seeded_random();
  for (int run = 0; run < 12; ++run) {
    const double noise = run < 10 ? 0.46 : 1.0;
    PoseGraph graph = optimizer.graph();
    for (GraphConstraint& c : graph.constraints) {
      const Eigen::Vector3d sigma = noise * c.information.diagonal().cwiseSqrt().cwiseInverse();
      const Pose2 error(sigma.x() * test::normal(random, 1.0),
                        sigma.y() * test::normal(random, 1.0),
                        sigma.z() * test::normal(random, 1.0));
      c.from_T_to = graph.nodes[c.from.value].map_T_node.inverse() *
                    graph.nodes[c.to.value].map_T_node * error;
    }
    const double computed = optimum(guess_poses(graph, Guess::kComputed).graph);
    EXPECT_LE(computed, optimum(guess_from_spanning_tree(graph)) * (1.0 + 1e-6)) << run;
  }
}

INSTANTIATE_TEST_SUITE_P(Published, RecordedGraphs,
                         ::testing::Values(Published{"intel", 215.830}, Published{"mit", 41.163},
                                           Published{"m3500", 137.913}, Published{"csail", 40.408}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace falko_slam
