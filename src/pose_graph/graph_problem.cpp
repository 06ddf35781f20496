// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "graph_problem.hpp"

#include <cmath>

#include "disjoint_sets.hpp"

namespace falko_slam {

std::vector<bool> GraphProblem::anchored() const {
  DisjointSets parts(poses.size());
  for (const GraphFactor& factor : factors) {
    if (factor.in_force) parts.join(factor.from, factor.to);
  }
  std::vector<bool> held(poses.size(), false);  // by the representative of a part
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (fixed[i]) held[parts.find(i)] = true;
  }
  std::vector<bool> result = fixed;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (held[parts.find(i)]) continue;
    held[parts.find(i)] = true;
    result[i] = true;
  }
  return result;
}

LossValue evaluate_loss(Loss loss, double scale, double squared) {
  const double c2 = scale * scale;
  switch (loss) {
    case Loss::kNone:
      break;
    case Loss::kHuber:
      if (squared <= c2) break;
      return {2.0 * scale * std::sqrt(squared) - c2, scale / std::sqrt(squared),
              -0.5 * scale / (squared * std::sqrt(squared))};
    case Loss::kCauchy:
      return {c2 * std::log1p(squared / c2), c2 / (c2 + squared),
              -c2 / ((c2 + squared) * (c2 + squared))};
  }
  return {squared, 1.0, 0.0};
}

GraphCost evaluate_cost(const GraphProblem& problem, const OptimizerParams& params) {
  GraphCost sum;
  for (const GraphFactor& f : problem.factors) {
    if (!f.in_force) continue;
    const double squared =
        f.factor.residual(problem.poses[f.from], problem.poses[f.to]).squaredNorm();
    sum.chi2 += squared;
    sum.cost +=
        f.robust ? evaluate_loss(params.closure_loss, params.loss_scale, squared).cost : squared;
  }
  return sum;
}

}  // namespace falko_slam
