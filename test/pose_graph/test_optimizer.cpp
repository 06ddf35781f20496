// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/pose_graph/optimizer.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "falko_slam/geometry/angles.hpp"
#include "support/simulated_graphs.hpp"

namespace falko_slam {
namespace {

using test::GraphNoise;
using test::SimulatedGraph;

SimulatedGraph small_town(std::mt19937_64& random) {
  return test::drive_grid(200, GraphNoise(), random);
}

OptimizerParams without_loss() {
  OptimizerParams params;
  params.closure_loss = Loss::kNone;
  return params;
}

double greatest_difference(const PoseGraph& a, const PoseGraph& b) {
  double greatest = 0.0;
  for (std::size_t i = 0; i < a.nodes.size(); ++i) {
    const Pose2 left = a.nodes[i].map_T_node.inverse() * b.nodes[i].map_T_node;
    greatest = std::max({greatest, left.translation().norm(), std::abs(left.theta())});
  }
  return greatest;
}

// A graph moved as a whole.
PoseGraph moved(PoseGraph graph, const Pose2& by) {
  for (GraphNode& node : graph.nodes) node.map_T_node = by * node.map_T_node;
  return graph;
}

// Drives through the graph, updating at every closure.
PoseGraphOptimizer drive(const PoseGraph& graph, const OptimizerParams& params) {
  PoseGraphOptimizer optimizer(params);
  std::size_t next = 0;
  for (const GraphNode& node : graph.nodes) {
    if (node.id.value == 0) optimizer.add_node(node);
    bool closed = false;
    for (; next < graph.constraints.size(); ++next) {
      const GraphConstraint& constraint = graph.constraints[next];
      if (constraint.to != node.id) break;
      if (constraint.kind == ConstraintKind::kOdometry) {
        optimizer.add_node({node.id, optimizer.pose(constraint.from) * constraint.from_T_to});
      }
      optimizer.add_constraint(constraint);
      closed = closed || constraint.kind == ConstraintKind::kClosure;
    }
    if (!closed) continue;
    EXPECT_TRUE(optimizer.update().converged);
  }
  return optimizer;
}

TEST(PoseGraphOptimizer, FindsTheTruthWithoutNoise) {
  auto random = test::seeded_random();
  SimulatedGraph drive = small_town(random);
  for (GraphConstraint& c : drive.graph.constraints) {
    c.from_T_to = drive.truth[c.from.value].inverse() * drive.truth[c.to.value];
  }

  PoseGraphOptimizer optimizer(drive.graph);
  const OptimizationSummary summary = optimizer.optimize();

  EXPECT_TRUE(summary.converged) << summary.message;
  EXPECT_LT(summary.final_chi2, 1e-6);
  for (std::size_t i = 0; i < drive.truth.size(); ++i) {
    EXPECT_LT((optimizer.pose({i}).translation() - drive.truth[i].translation()).norm(), 1e-6);
  }
}

TEST(PoseGraphOptimizer, MovesWithTheGraph) {
  auto random = test::seeded_random();
  const SimulatedGraph drive = small_town(random);
  const Pose2 by(30.0, -20.0, 2.9);

  PoseGraphOptimizer here(drive.graph), there(moved(drive.graph, by));
  const OptimizationSummary summary_here = here.optimize(), summary_there = there.optimize();

  EXPECT_NEAR(summary_here.final_chi2, summary_there.final_chi2, 1e-5);
  EXPECT_LT(greatest_difference(moved(here.graph(), by), there.graph()), 1e-5);
}

TEST(PoseGraphOptimizer, LeavesFixedNodesWhereTheyAre) {
  auto random = test::seeded_random();
  SimulatedGraph drive = small_town(random);
  drive.graph.fixed = {{7}, {150}};

  PoseGraphOptimizer optimizer(drive.graph);
  optimizer.optimize();

  for (const KeyframeId id : drive.graph.fixed) {
    const Pose2 left = drive.graph.nodes[id.value].map_T_node.inverse() * optimizer.pose(id);
    EXPECT_LT(left.translation().norm() + std::abs(left.theta()), 1e-12);
    EXPECT_TRUE(optimizer.marginal_covariance(id)->isZero(0.0));
  }
}

TEST(PoseGraphOptimizer, UpdatesToTheOptimumOfTheWholeGraph) {
  auto random = test::seeded_random();
  for (const Loss loss : {Loss::kNone, Loss::kHuber, Loss::kCauchy}) {
    OptimizerParams params;
    params.closure_loss = loss;
    const SimulatedGraph town = test::drive_grid(600, GraphNoise(), random);

    PoseGraphOptimizer optimizer = drive(town.graph, params);
    const PoseGraph updated = optimizer.graph();
    const double cost = optimizer.update().final_cost;
    const OptimizationSummary summary = optimizer.optimize();

    EXPECT_NEAR(cost, summary.final_cost, 1e-3);
    EXPECT_LT(greatest_difference(updated, optimizer.graph()), 2e-3);
    PoseGraphOptimizer batch(updated, params);
    EXPECT_NEAR(batch.optimize().final_cost, summary.final_cost, 1e-4);
  }
}

TEST(PoseGraphOptimizer, ClosesLongRoundsInUpdates) {
  auto random = test::seeded_random();
  const SimulatedGraph rounds = test::drive_rounds(1500, 500, 250, GraphNoise(), random);

  PoseGraphOptimizer optimizer = drive(rounds.graph, {});
  const double chi2 = optimizer.update().final_chi2;

  EXPECT_LT(chi2, 60.0);  // of 5 closures, 15 degrees of freedom
  EXPECT_NEAR(optimizer.optimize().final_chi2, chi2, 1e-2);
}

TEST(PoseGraphOptimizer, ForgetsAConstraintThatIsNoLongerInForce) {
  auto random = test::seeded_random();
  const SimulatedGraph town = small_town(random);
  PoseGraphOptimizer optimizer(town.graph), untouched(town.graph);
  untouched.optimize();
  optimizer.update();
  GraphConstraint wrong{{20}, {180}, Pose2(0.0, 0.0, 1.0)};
  wrong.information *= 1e4;

  const std::size_t number = optimizer.add_constraint(wrong);
  optimizer.update();
  EXPECT_GT(greatest_difference(optimizer.graph(), untouched.graph()), 1e-3);
  optimizer.set_in_force(number, false);
  optimizer.update();

  EXPECT_LT(greatest_difference(optimizer.graph(), untouched.graph()), 2e-3);
  EXPECT_EQ(optimizer.graph().constraints.size(), town.graph.constraints.size());
}

TEST(PoseGraphOptimizer, HoldsAgainstOneFalseClosure) {
  auto random = test::seeded_random();
  SimulatedGraph town = small_town(random);
  PoseGraphOptimizer clean(town.graph);
  clean.optimize();
  GraphConstraint wrong = test::measure(town, 20, 180, ConstraintKind::kClosure, {}, random);
  wrong.from_T_to = wrong.from_T_to * Pose2(5.0, -4.0, 1.0);
  town.graph.constraints.push_back(wrong);

  PoseGraphOptimizer robust(town.graph), plain(town.graph, without_loss());
  robust.optimize();
  plain.optimize();

  EXPECT_LT(greatest_difference(clean.graph(), robust.graph()), 0.05);
  EXPECT_GT(greatest_difference(clean.graph(), plain.graph()), 0.5);
  PoseGraphOptimizer updated(clean.graph());
  updated.update();
  updated.add_constraint(wrong);
  updated.update();
  EXPECT_LT(greatest_difference(clean.graph(), updated.graph()), 0.05);
}

// Normalised estimation error squared: 3 degrees of freedom, over all runs within the 99.9 % bounds
// of its sum (normal approximation of chi-square).
TEST(PoseGraphOptimizer, StatesHowFarItIsOff) {
  auto random = test::seeded_random();
  constexpr int kRuns = 200;
  double sum = 0.0;
  for (int run = 0; run < kRuns; ++run) {
    const SimulatedGraph rounds = test::drive_rounds(60, 20, 5, GraphNoise(), random);
    PoseGraphOptimizer optimizer(rounds.graph, without_loss());
    optimizer.optimize();
    const Pose2 estimate = optimizer.pose({47});
    const Pose2& truth = rounds.truth[47];
    const Eigen::Vector3d error(estimate.x() - truth.x(), estimate.y() - truth.y(),
                                angle_between(truth.theta(), estimate.theta()));
    const Eigen::Matrix3d covariance = *optimizer.marginal_covariance({47});
    sum += error.dot(covariance.inverse() * error);
  }
  constexpr double kFreedom = 3.0 * kRuns;
  EXPECT_NEAR(sum, kFreedom, 3.3 * std::sqrt(2.0 * kFreedom));
}

TEST(PoseGraphOptimizer, HasNoCovarianceForALooseGraph) {
  PoseGraph graph;
  graph.nodes = {{{0}, Pose2()}, {{1}, Pose2(1.0, 0.0, 0.0)}};
  GraphConstraint along{{0}, {1}, Pose2(1.0, 0.0, 0.0)};
  along.information = Eigen::Vector3d(1.0, 0.0, 1.0).asDiagonal();
  graph.constraints = {along};

  EXPECT_FALSE(PoseGraphOptimizer(graph).marginal_covariance({1}).has_value());
}

TEST(PoseGraphOptimizer, NamesWhatItCannotTake) {
  PoseGraphOptimizer optimizer;
  optimizer.add_node({{1}, Pose2()});
  optimizer.add_node({{2}, Pose2()});
  const auto complaint = [&](const GraphConstraint& constraint) -> std::string {
    try {
      optimizer.add_constraint(constraint);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "none";
  };
  GraphConstraint indefinite{{1}, {2}, Pose2()};
  indefinite.information(0, 0) = -1.0;
  GraphConstraint lopsided{{1}, {2}, Pose2()};
  lopsided.information(0, 1) = 0.5;
  const double nan = std::nan("");

  EXPECT_THROW(optimizer.add_node({{1}, Pose2()}), std::invalid_argument);
  EXPECT_THROW(optimizer.add_node({{3}, Pose2(nan, 0.0, 0.0)}), std::invalid_argument);
  EXPECT_NE(
      complaint({{1}, {2}, Pose2(nan, 0.0, 0.0)}).find("nodes 1 and 2: the pose is not finite"),
      std::string::npos);
  EXPECT_THROW(optimizer.pose({9}), std::invalid_argument);
  EXPECT_THROW(optimizer.set_in_force(0, true), std::invalid_argument);
  EXPECT_EQ(complaint({{1}, {9}, Pose2()}), "node 9: is not in the graph");
  EXPECT_EQ(complaint({{2}, {2}, Pose2()}),
            "constraint of nodes 2 and 2: must be two different ones");
  EXPECT_NE(complaint(indefinite).find("must be positive semidefinite"), std::string::npos);
  EXPECT_NE(complaint(lopsided).find("must be symmetric"), std::string::npos);
  EXPECT_EQ(optimizer.graph().constraints.size(), 0U);
}

}  // namespace
}  // namespace falko_slam
