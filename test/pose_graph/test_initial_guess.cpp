// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/pose_graph/initial_guess.hpp"

#include <gtest/gtest.h>

#include "falko_slam/pose_graph/optimizer.hpp"
#include "support/simulated_graphs.hpp"

namespace falko_slam {
namespace {

using test::SimulatedGraph;

// A town without noise, whose poses say nothing.
SimulatedGraph exact_town() {
  auto random = test::seeded_random();
  SimulatedGraph town = test::drive_grid(300, {}, random);
  for (GraphConstraint& c : town.graph.constraints) {
    c.from_T_to = town.truth[c.from.value].inverse() * town.truth[c.to.value];
  }
  for (std::size_t i = 1; i < town.graph.nodes.size(); ++i) {
    town.graph.nodes[i].map_T_node = Pose2();
  }
  return town;
}

TEST(InitialGuess, IsExactWithoutNoise) {
  const SimulatedGraph town = exact_town();
  const ComputedGuess guess = guess_from_constraints(town.graph);
  for (const PoseGraph& graph :
       {guess.likely, guess.on_tree, guess_from_spanning_tree(town.graph)}) {
    EXPECT_LT(chi2_of(graph), 1e-10);
    for (std::size_t i = 0; i < town.truth.size(); ++i) {
      const Pose2 left = town.truth[i].inverse() * graph.nodes[i].map_T_node;
      EXPECT_LT(left.translation().norm() + std::abs(left.theta()), 1e-9);
    }
  }
}

TEST(InitialGuess, HoldsTheFixedNode) {
  SimulatedGraph town = exact_town();
  const Pose2 by(5.0, 6.0, -3.0);
  town.graph.nodes[100].map_T_node = by * town.truth[100];
  town.graph.fixed = {{100}};
  const PoseGraph guess = guess_from_constraints(town.graph).likely;
  for (std::size_t i = 0; i < town.truth.size(); ++i) {
    const Pose2 left = (by * town.truth[i]).inverse() * guess.nodes[i].map_T_node;
    EXPECT_LT(left.translation().norm() + std::abs(left.theta()), 1e-9);
  }
}

TEST(InitialGuess, IsNearTheOptimumOfALongRound) {
  auto random = test::seeded_random();
  const SimulatedGraph rounds = test::drive_rounds(2000, 500, 100, {0.02, 0.02, 0.02}, random);
  const double dead_reckoning = chi2_of(guess_from_spanning_tree(rounds.graph));
  EXPECT_LT(chi2_of(guess_from_constraints(rounds.graph).likely), 1e-2 * dead_reckoning);
}

TEST(InitialGuess, KeepsPosesThatAreBetter) {
  auto random = test::seeded_random();
  const SimulatedGraph town = test::drive_grid(300, {}, random);
  EXPECT_TRUE(guess_poses(town.graph, Guess::kBetter).computed);
  EXPECT_FALSE(guess_poses(town.graph, Guess::kGiven).computed);
  PoseGraphOptimizer optimizer(town.graph);
  optimizer.optimize();
  EXPECT_FALSE(guess_poses(optimizer.graph(), Guess::kBetter).computed);
  EXPECT_TRUE(guess_poses(optimizer.graph(), Guess::kComputed).computed);
}

TEST(InitialGuess, NamesThePartsOfAGraph) {
  PoseGraph graph;
  for (std::uint64_t id = 0; id < 5; ++id) graph.nodes.push_back({{id}, Pose2()});
  graph.constraints = {{{0}, {1}, Pose2()}, {{3}, {2}, Pose2()}};
  try {
    require_connected(graph);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "the graph falls into 3 parts: 2 nodes from 0 to 1; 2 nodes from 2 to 3; 1 nodes "
                 "from 4 to 4");
  }
  EXPECT_NO_THROW(guess_from_constraints(graph));
  graph.constraints.push_back({{4}, {2}, Pose2()});
  graph.constraints.push_back({{4}, {0}, Pose2()});
  EXPECT_NO_THROW(require_connected(graph));
}

}  // namespace
}  // namespace falko_slam
