// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/pose_graph/pose_graph.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace test {

/// A drive with known truth, as a graph: nodes where odometry saw them, constraints with noise of
/// the covariance they state.
struct SimulatedGraph {
  PoseGraph graph;
  std::vector<Pose2> truth;  ///< map_T_node
};

/// Standard deviations of a constraint, along the axes of the node it leads to.
struct GraphNoise {
  double along = 0.02, across = 0.01;  ///< [m]
  double heading = 0.002;              ///< [rad]
};

inline GraphConstraint measure(const SimulatedGraph& drive, std::size_t from, std::size_t to,
                               ConstraintKind kind, const GraphNoise& noise,
                               std::mt19937_64& random) {
  const Pose2 error(normal(random, 1.0) * noise.along, normal(random, 1.0) * noise.across,
                    normal(random, 1.0) * noise.heading);
  GraphConstraint constraint{{from}, {to}};
  // The residual of the truth is the error, with either sign.
  constraint.from_T_to = drive.truth[from].inverse() * drive.truth[to] * error.inverse();
  constraint.information = Eigen::Vector3d(std::pow(noise.along, -2), std::pow(noise.across, -2),
                                           std::pow(noise.heading, -2))
                               .asDiagonal();
  constraint.kind = kind;
  return constraint;
}

/// Goes on to a pose of the truth: a node where odometry puts it, and the odometry.
inline void drive_on(SimulatedGraph& drive, const Pose2& map_T_node, const GraphNoise& noise,
                     std::mt19937_64& random) {
  const std::size_t node = drive.truth.size();
  drive.truth.push_back(map_T_node);
  if (node == 0) {
    drive.graph.nodes.push_back({{0}, map_T_node});
    return;
  }
  const GraphConstraint step =
      measure(drive, node - 1, node, ConstraintKind::kOdometry, noise, random);
  drive.graph.nodes.push_back({{node}, drive.graph.nodes.back().map_T_node * step.from_T_to});
  drive.graph.constraints.push_back(step);
}

/// A random walk along the streets of a square town, one node a metre. At every second crossing
/// that it comes to again it closes a loop with the node that was there first.
inline SimulatedGraph drive_grid(std::size_t nodes, const GraphNoise& noise,
                                 std::mt19937_64& random) {
  const int side = static_cast<int>(std::sqrt(static_cast<double>(nodes)) * 0.7) + 2;
  SimulatedGraph drive;
  std::map<std::pair<int, int>, std::size_t> first_at;
  int x = side / 2, y = side / 2, direction = 0, left_of_block = 0;
  while (drive.truth.size() < nodes) {
    const std::size_t node = drive.truth.size();
    drive_on(drive, Pose2(x, y, 0.5 * kPi * direction), noise, random);
    const auto [first, is_new] = first_at.emplace(std::make_pair(x, y), node);
    if (!is_new && node > first->second + 1 && uniform(random, 0.0, 1.0) < 0.5) {
      drive.graph.constraints.push_back(
          measure(drive, first->second, node, ConstraintKind::kClosure, noise, random));
    }
    const auto inside = [side](int value) { return value >= 0 && value < side; };
    const auto dx = [](int d) { return d % 4 == 0 ? 1 : d % 4 == 2 ? -1 : 0; };
    const auto dy = [](int d) { return d % 4 == 1 ? 1 : d % 4 == 3 ? -1 : 0; };
    if (--left_of_block < 0) {
      left_of_block = 4;
      direction = (direction + static_cast<int>(uniform(random, 0.0, 3.0)) + 3) % 4;
    }
    while (!inside(x + dx(direction)) || !inside(y + dy(direction)))
      direction = (direction + 1) % 4;
    x += dx(direction);
    y += dy(direction);
  }
  return drive;
}

/// Rounds of a circle, `per_round` nodes of a metre each; a closure with the node a round before at
/// every `closure_every`-th node from the second round on.
inline SimulatedGraph drive_rounds(std::size_t nodes, std::size_t per_round,
                                   std::size_t closure_every, const GraphNoise& noise,
                                   std::mt19937_64& random) {
  SimulatedGraph drive;
  const double turn = kTwoPi / static_cast<double>(per_round);
  const double radius = 1.0 / turn;
  for (std::size_t node = 0; node < nodes; ++node) {
    const double angle = turn * static_cast<double>(node % per_round);
    drive_on(drive, Pose2(radius * std::sin(angle), radius * (1.0 - std::cos(angle)), angle), noise,
             random);
    if (node >= per_round && node % closure_every == 0) {
      drive.graph.constraints.push_back(
          measure(drive, node - per_round, node, ConstraintKind::kClosure, noise, random));
    }
  }
  return drive;
}

}  // namespace test
}  // namespace falko_slam
