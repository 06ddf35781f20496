// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "falko_slam/pose_graph/pose_graph.hpp"

namespace falko_slam {

struct ConsistencyParams {
  /// Of a true closure, or of a pair of them, to pass its test. [0.5, 0.999999]
  double gate_probability = 0.999;
  /// A test is trusted if a false closure, anywhere in the area driven so far and with any heading,
  /// passes it with at most this probability. [0, 1]
  double trusted_chance = 0.002;
  /// How many closures must agree by trusted tests, each of them counted, where odometry alone is
  /// not trusted. [1, 100]
  int confirmations = 2;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const ConsistencyParams& params);

enum class ClosureVerdict {
  kAccepted,
  kPending,               ///< odometry cannot tell, and too few others confirm it so far
  kAgainstOdometry,       ///< the way it closes is not the identity within its covariance
  kAgainstOtherClosures,  ///< those that contradict it are more
};
const char* name_of(ClosureVerdict verdict);

/// Which closures may enter the graph: pairwise consistency maximisation (\cite mangelson2018),
/// kept up as closures come in.
///
/// Odometry is a chain of steps, C_p the pose of node p along it. Closure i measured z_i from a_i
/// to b_i; it corrects the chain by D_i = C_(a_i) z_i C_(b_i)^-1. Two tests, with three degrees of
/// freedom each, within the covariance of what is multiplied, to first order:
///
///     alone    D_i = 1                that is, z_i = o(a_i, b_i)
///     pairs    D_j D_i^-1 = 1         that is, o(a_i, a_j) z_j o(b_j, b_i) z_i^-1 = 1
///
/// A stretch of odometry that a cycle runs through twice, there and back, cancels as it must. A
/// closure that fails alone is refused. Of the rest the largest set is kept in which all pairs
/// pass; of sets of one size, the one that was there first.
///
/// The further odometry drifts, the more false closures pass: by the volume of the gate over that
/// of all poses in the area driven so far. Where that chance is above `trusted_chance` in the test
/// alone, a closure that stands by itself says nothing about its truth: it is pending until there
/// are `confirmations` that agree, by tests of pairs whose drift can be trusted again.
///
/// A pair costs O(1), a closure O(closures), and the largest set is searched only among those that
/// hang together by contradictions. Not thread-safe.
class ClosureSelection {
 public:
  /// Throws std::invalid_argument.
  explicit ClosureSelection(const ConsistencyParams& params = {});
  ~ClosureSelection();
  ClosureSelection(ClosureSelection&&) noexcept;
  ClosureSelection& operator=(ClosureSelection&&) noexcept;

  /// The next node of the chain, seen from the last one with the covariance of a PoseEstimate; that
  /// of the first is not used. Throws std::invalid_argument for a node that is there already.
  void add_step(KeyframeId node, const PoseEstimate& last_T_node);

  struct Change {
    std::size_t closure;  ///< counted from 0 as they were added
    ClosureVerdict verdict;
  };
  /// Judges a closure, and again those that it touches. Returns it and all whose verdict is another
  /// now. Throws std::invalid_argument for nodes that are not there.
  std::vector<Change> add_closure(const GraphConstraint& closure);

  ClosureVerdict verdict(std::size_t closure) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The verdict of each constraint of a graph whose closures come in their order; accepted for all
/// that are no closures. The chain is made of the constraints of each node and the next one in the
/// graph. Throws std::invalid_argument where one is missing.
std::vector<ClosureVerdict> select_closures(const PoseGraph& graph,
                                            const ConsistencyParams& params = {});

}  // namespace falko_slam
