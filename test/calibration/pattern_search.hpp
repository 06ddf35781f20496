// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>

namespace falko_slam {
namespace test {

/// The lowest point that steps along the axes lead to, halved until they are this small a share of
/// the first ones: slow, and without a single derivative or idea.
inline Eigen::VectorXd pattern_search(const std::function<double(const Eigen::VectorXd&)>& cost,
                                      Eigen::VectorXd at, Eigen::VectorXd step,
                                      double smallest = 1e-9) {
  double least = cost(at);
  for (double scale = 1.0; scale > smallest;) {
    bool lower = false;
    for (Eigen::Index i = 0; i < at.size(); ++i) {
      for (const double sign : {1.0, -1.0}) {
        Eigen::VectorXd next = at;
        next[i] += sign * scale * step[i];
        const double value = cost(next);
        if (value >= least) continue;
        at = next;
        least = value;
        lower = true;
      }
    }
    if (!lower) scale *= 0.5;
  }
  return at;
}

}  // namespace test
}  // namespace falko_slam
