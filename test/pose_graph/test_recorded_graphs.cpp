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

INSTANTIATE_TEST_SUITE_P(Published, RecordedGraphs,
                         ::testing::Values(Published{"intel", 215.830}, Published{"mit", 41.163},
                                           Published{"m3500", 137.913}, Published{"csail", 40.408}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace falko_slam
