// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "falko_slam/pose_graph/pose_graph.hpp"

namespace falko_slam {

struct ConsistencyParams {
  /// Of a true closure, or of a pair of them, to pass its test. [0.5, 0.999999]
  double gate_probability = 0.99;
  /// Closures that tell the same tale before they are believed against odometry that cannot tell:
  /// see ClosureSelection. [1, 100]
  int confirmations = 2;
  /// Standard deviation of the position, along odometry alone, up to which odometry can tell a
  /// true closure from a false one. [0, 1000] [m]
  double trusted_drift = 1.0;
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
/// Odometry is a chain of steps. Closure i says where node b_i is seen from node a_i; with odometry
/// o between any two nodes of the chain, two tests with three degrees of freedom are made:
///
///     alone    z_i^-1 o(a_i, b_i)                               is the identity
///     pairs    z_i^-1 o(a_i, a_j) z_j o(b_j, b_i)               is the identity
///
/// within the covariance of what is multiplied, to first order, whatever stretch of odometry is run
/// through twice counting once in each direction. A closure that fails alone is refused. Of the
/// rest, two are joined by an edge if they pass as a pair; the largest clique is accepted.
///
/// A pair says little where odometry between their ends has drifted far: a closure that nobody
/// confirms is accepted if odometry can tell (its standard deviation is at most `trusted_drift`),
/// else it is pending until `confirmations` in all, it among them, agree. Not thread-safe.
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
  std::size_t closures() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace falko_slam
