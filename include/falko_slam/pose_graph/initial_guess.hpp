// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "falko_slam/pose_graph/pose_graph.hpp"

namespace falko_slam {

/// The connected parts of a graph, each as the ids of its nodes in their order in the graph.
/// Throws std::invalid_argument if a constraint names a node that is not there.
std::vector<std::vector<KeyframeId>> connected_parts(const PoseGraph& graph);

/// Throws std::invalid_argument that says which nodes the parts hold, if there is more than one.
void require_connected(const PoseGraph& graph);

/// Poses from the constraints alone, whatever the poses given.
///
/// Two linear problems: the headings as complex numbers first (the chordal relaxation,
/// \cite carlone2015initialization), refined by their wrapped differences (as \cite carlone2014,
/// with the whole turns that the first step found), then the positions for these headings. The
/// weights are scalars, means of the information. Exact where the constraints agree. Each part of
/// the graph is held at its first fixed node, or at its first node.
struct ComputedGuess {
  PoseGraph likely;  ///< positions by least squares: near the optimum
  /// Positions along the breadth-first tree: further off, but where information is far from
  /// isotropic a Gauss-Newton step from here lands nearer, for the tree's translations are met.
  PoseGraph on_tree;
};
ComputedGuess guess_from_constraints(const PoseGraph& graph);

/// Poses along the breadth-first tree of the constraints from where each part is held.
PoseGraph guess_from_spanning_tree(const PoseGraph& graph);

/// Which poses the optimiser starts from.
enum class Guess {
  kGiven,     ///< those of the graph
  kComputed,  ///< guess_from_constraints, on the tree
  kBetter,    ///< computed, unless the chi2 of those given is below that of the likely ones
};

struct GuessedGraph {
  PoseGraph graph;
  bool computed = false;  ///< the poses are not those given
};
GuessedGraph guess_poses(const PoseGraph& graph, Guess guess);

}  // namespace falko_slam
