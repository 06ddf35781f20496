// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/pose_graph/consistency.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>

#include "chi_square.hpp"
#include "odometry_chain.hpp"
#include "support/simulated_graphs.hpp"

namespace falko_slam {
namespace {

using test::GraphNoise;
using test::SimulatedGraph;

struct Case {
  PoseGraph graph;
  std::vector<bool> is_false;  // of each constraint
};

// A town, with false closures between random nodes beside the true ones.
Case town_with_false_closures(std::size_t nodes, double share, std::mt19937_64& random) {
  const SimulatedGraph town = test::drive_grid(nodes, GraphNoise(), random);
  Case result{town.graph, {}};
  result.graph.constraints.clear();
  for (const GraphConstraint& constraint : town.graph.constraints) {
    result.graph.constraints.push_back(constraint);
    result.is_false.push_back(false);
    if (constraint.kind != ConstraintKind::kClosure) continue;
    if (test::uniform(random, 0.0, 1.0) > share) continue;
    GraphConstraint wrong = constraint;
    wrong.from = {static_cast<std::uint64_t>(
        test::uniform(random, 0.0, static_cast<double>(constraint.to.value) - 1.0))};
    wrong.from_T_to = Pose2(test::normal(random, 0.5), test::normal(random, 0.5),
                            test::uniform(random, -kPi, kPi));
    const Pose2 truth = town.truth[wrong.from.value].inverse() * town.truth[wrong.to.value];
    const Pose2 left = truth.inverse() * wrong.from_T_to;
    if (left.translation().norm() < 1.0 && std::abs(left.theta()) < 0.3) continue;
    result.graph.constraints.push_back(wrong);
    result.is_false.push_back(true);
  }
  return result;
}

TEST(ClosureSelection, KeepsFalseClosuresOutAndTrueOnesIn) {
  auto random = test::seeded_random();
  std::size_t true_ones = 0, true_accepted = 0, false_ones = 0, false_accepted = 0;
  for (int run = 0; run < 5; ++run) {
    const Case town = town_with_false_closures(800, 0.25, random);
    const std::vector<ClosureVerdict> verdicts = select_closures(town.graph);
    for (std::size_t i = 0; i < verdicts.size(); ++i) {
      if (town.graph.constraints[i].kind != ConstraintKind::kClosure) continue;
      const bool accepted = verdicts[i] == ClosureVerdict::kAccepted;
      ++(town.is_false[i] ? false_ones : true_ones);
      if (accepted) ++(town.is_false[i] ? false_accepted : true_accepted);
    }
  }
  EXPECT_GT(false_ones, true_ones / 6);
  EXPECT_EQ(false_accepted, 0U);
  EXPECT_GT(static_cast<double>(true_accepted), 0.97 * static_cast<double>(true_ones));
}

// All subsets, by tests of pairs that multiply the cycles out.
std::size_t largest_consistent_set(const OdometryChain& chain,
                                   const std::vector<GraphConstraint>& closures, double gate) {
  const auto correction = [&](const GraphConstraint& c) {
    return chain.pose(c.from.value) * c.from_T_to * chain.pose(c.to.value).inverse();
  };
  const auto noise = [&](const GraphConstraint& c) {
    return moved(chain.pose(c.from.value) * c.from_T_to, c.information.inverse());
  };
  // Covariance step by step: each counts with the Jacobian of every passage.
  const auto passes = [&](const GraphConstraint* first, const GraphConstraint& second) {
    const Pose2 shift = first != nullptr ? correction(*first) : Pose2();
    const auto passage = [](std::uint64_t from, std::uint64_t to, std::uint64_t step) {
      if (from < step && step <= to) return 1.0;
      return to < step && step <= from ? -1.0 : 0.0;
    };
    Eigen::Matrix3d covariance = noise(second);
    if (first != nullptr) covariance += noise(*first);
    for (std::size_t step = 1; step < chain.size(); ++step) {
      Eigen::Matrix3d jacobian = Eigen::Matrix3d::Identity();
      if (first != nullptr) {
        jacobian *= passage(second.from.value, first->from.value, step);
        jacobian += passage(first->to.value, second.to.value, step) * shift.adjoint();
      } else {
        jacobian *= passage(second.from.value, second.to.value, step);
      }
      covariance += jacobian * chain.covariance({step - 1, step}) * jacobian.transpose();
    }
    const Eigen::Vector3d left = (shift * correction(second).inverse()).log();
    return left.dot(covariance.inverse() * left) <= gate;
  };
  std::size_t largest = 0;
  for (unsigned subset = 0; subset < 1U << closures.size(); ++subset) {
    std::vector<const GraphConstraint*> chosen;
    for (std::size_t i = 0; i < closures.size(); ++i) {
      if (subset >> i & 1U) chosen.push_back(&closures[i]);
    }
    bool good = true;
    for (std::size_t i = 0; i < chosen.size() && good; ++i) {
      good = passes(nullptr, *chosen[i]);
      for (std::size_t j = 0; j < i && good; ++j) good = passes(chosen[i], *chosen[j]);
    }
    if (good) largest = std::max(largest, chosen.size());
  }
  return largest;
}

TEST(ClosureSelection, KeepsAsManyAsTheBestOfAllSubsets) {
  auto random = test::seeded_random();
  ConsistencyParams params;
  params.gate_probability = 0.9;
  params.confirmations = 1;
  for (int run = 0; run < 20; ++run) {
    SimulatedGraph rounds = test::drive_rounds(60, 20, 1000, {0.05, 0.05, 0.02}, random);
    OdometryChain chain;
    ClosureSelection selection(params);
    for (std::size_t i = 0; i < 60; ++i) {
      const PoseEstimate step =
          i > 0 ? estimate_of(rounds.graph.constraints[i - 1]) : PoseEstimate();
      chain.add(step);
      selection.add_step({i}, step);
    }
    std::vector<GraphConstraint> closures;
    for (int i = 0; i < 9; ++i) {
      const auto from = static_cast<std::size_t>(test::uniform(random, 0.0, 39.0));
      closures.push_back(test::measure(rounds, from, from + 20, ConstraintKind::kClosure,
                                       {0.05, 0.05, 0.02}, random));
      if (i % 2 == 0) {
        closures.back().from_T_to =
            closures.back().from_T_to * Pose2(test::normal(random, 0.3), 0.0, 0.0);
      }
      selection.add_closure(closures.back());
    }

    std::size_t kept = 0;
    for (std::size_t i = 0; i < closures.size(); ++i) {
      if (selection.verdict(i) == ClosureVerdict::kAccepted) ++kept;
    }
    EXPECT_EQ(kept, largest_consistent_set(chain, closures,
                                           chi_square_quantile_3(params.gate_probability)));
  }
}

TEST(ClosureSelection, WaitsForASecondOpinionWhereOdometryCannotTell) {
  auto random = test::seeded_random();
  const GraphNoise slippery{0.3, 0.3, 0.05};
  const SimulatedGraph rounds = test::drive_rounds(250, 200, 1000, slippery, random);
  ClosureSelection selection;
  for (std::size_t i = 0; i < 250; ++i) {
    selection.add_step({i}, i > 0 ? estimate_of(rounds.graph.constraints[i - 1]) : PoseEstimate());
  }
  const auto closure = [&](std::size_t from) {
    return test::measure(rounds, from, from + 200, ConstraintKind::kClosure, {}, random);
  };

  const auto first = selection.add_closure(closure(10));
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0].verdict, ClosureVerdict::kPending);
  const auto second = selection.add_closure(closure(12));

  ASSERT_EQ(second.size(), 2U);
  EXPECT_EQ(second[0].closure, 0U);
  EXPECT_EQ(second[0].verdict, ClosureVerdict::kAccepted);
  EXPECT_EQ(second[1].verdict, ClosureVerdict::kAccepted);
}

TEST(ClosureSelection, OutvotesAFalseClosureThatCameFirst) {
  auto random = test::seeded_random();
  const GraphNoise slippery{0.3, 0.3, 0.05};
  const SimulatedGraph rounds = test::drive_rounds(250, 200, 1000, slippery, random);
  ClosureSelection selection;
  for (std::size_t i = 0; i < 250; ++i) {
    selection.add_step({i}, i > 0 ? estimate_of(rounds.graph.constraints[i - 1]) : PoseEstimate());
  }
  GraphConstraint wrong = test::measure(rounds, 11, 211, ConstraintKind::kClosure, {}, random);
  wrong.from_T_to = wrong.from_T_to * Pose2(4.0, 0.0, 0.0);

  selection.add_closure(wrong);
  EXPECT_EQ(selection.verdict(0), ClosureVerdict::kPending);
  for (const std::size_t from : {10, 12}) {
    selection.add_closure(
        test::measure(rounds, from, from + 200, ConstraintKind::kClosure, {}, random));
  }

  EXPECT_EQ(selection.verdict(0), ClosureVerdict::kAgainstOtherClosures);
  EXPECT_EQ(selection.verdict(1), ClosureVerdict::kAccepted);
  EXPECT_EQ(selection.verdict(2), ClosureVerdict::kAccepted);
}

TEST(ClosureSelection, NamesWhatItCannotTake) {
  ConsistencyParams params;
  params.gate_probability = 1.0;
  EXPECT_THROW(ClosureSelection{params}, std::invalid_argument);
  ClosureSelection selection;
  selection.add_step({1}, {});
  EXPECT_THROW(selection.add_step({1}, {}), std::invalid_argument);
  EXPECT_THROW(selection.add_step({2}, {Pose2(std::nan(""), 0.0, 0.0), {}}), std::invalid_argument);
  EXPECT_THROW(selection.add_closure({{1}, {2}, Pose2()}), std::invalid_argument);
  PoseGraph graph;
  graph.nodes = {{{0}, Pose2()}, {{1}, Pose2()}};
  EXPECT_THROW(select_closures(graph), std::invalid_argument);
}

TEST(ChiSquare, KnowsItsQuantiles) {
  EXPECT_NEAR(chi_square_quantile_3(0.95), 7.8147, 1e-4);
  EXPECT_NEAR(chi_square_quantile_3(0.999), 16.2662, 1e-4);
}

}  // namespace
}  // namespace falko_slam
