// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace falko_slam {

/// The joint squared Mahalanobis distance of pairs, built up pair by pair.
class JointDistance {
 public:
  virtual ~JointDistance() = default;
  /// Of the pairs at places 0 to count - 1 and this one, which takes place `count`.
  virtual double with(std::size_t count, std::size_t pair) = 0;
};

/// Who may be paired with whom: pairs of one observation stand side by side.
struct JointPairs {
  struct Pair {
    std::size_t observation = 0;
    std::size_t landmark = 0;  ///< below `landmarks`
    double distance = 0.0;     ///< of the pair alone
  };
  std::vector<Pair> pairs;
  std::size_t landmarks = 0;
};

struct JointSearchParams {
  double joint_probability = 0.999;
  double step_gate = 11.6;  ///< what a pair may add to the joint distance of those before it
  double ambiguity = 6.0;
  int max_nodes = 2000;
};

struct JointSelection {
  std::vector<std::size_t> pairs;      ///< places in JointPairs::pairs, without the ambiguous
  std::vector<std::size_t> ambiguous;  ///< observations whose pairs differ among rivals
  std::size_t most = 0;                ///< size of the largest set
  double distance = 0.0;               ///< of the best set, the ambiguous pairs included
  bool proven = true;                  ///< every set was tried or could not have been better
};

/// Branch and bound over the observations, those with the fewest and nearest landmarks first.
///
/// The joint gate alone has a slack that grows with the root of the number of pairs, room for a
/// wrong one among many right ones: so each pair must fit to those before it by itself, too.
JointSelection search_jointly(const JointPairs& pairs, JointDistance& distance,
                              const JointSearchParams& params);

/// What a chi-square variable of two degrees of freedom stays below with this probability.
double pair_gate(double probability);

/// The same of 2 * pairs degrees of freedom for pairs = 0, 1, ..., most, within 2 %:
/// \cite abramowitz1964, 26.4.17.
std::vector<double> joint_gates(double probability, std::size_t most);

}  // namespace falko_slam
