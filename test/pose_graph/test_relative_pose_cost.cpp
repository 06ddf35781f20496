// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "relative_pose_cost.hpp"

#include <ceres/autodiff_cost_function.h>
#include <gtest/gtest.h>

#include <array>

#include "support/seeds.hpp"

namespace falko_slam {
namespace {

using RowMajor = RelativePoseFactor::RowMajor;

// The residual as it is written, for numbers and for ceres::Jet.
struct PlainResidual {
  const GraphConstraint& constraint;

  template <class T>
  bool operator()(const T* from, const T* to, T* residual) const {
    using std::cos;
    using std::sin;
    const Pose2& z = constraint.from_T_to;
    const T dx = to[0] - from[0], dy = to[1] - from[1];
    const T seen_x = cos(from[2]) * dx + sin(from[2]) * dy - z.x();
    const T seen_y = -sin(from[2]) * dx + cos(from[2]) * dy - z.y();
    T turn = to[2] - from[2] - z.theta();
    while (turn >= kPi) turn -= kTwoPi;
    while (turn < -kPi) turn += kTwoPi;
    const T plain[3] = {std::cos(z.theta()) * seen_x + std::sin(z.theta()) * seen_y,
                        -std::sin(z.theta()) * seen_x + std::cos(z.theta()) * seen_y, turn};
    const Eigen::Matrix3d whitening = square_root_of_information(constraint.information);
    for (int i = 0; i < 3; ++i) {
      residual[i] =
          whitening(i, 0) * plain[0] + whitening(i, 1) * plain[1] + whitening(i, 2) * plain[2];
    }
    return true;
  }
};

struct Evaluation {
  Eigen::Vector3d residual;
  RowMajor dfrom, dto;
};

Evaluation evaluate(const ceres::CostFunction& cost, const Eigen::Vector3d& from,
                    const Eigen::Vector3d& to) {
  Evaluation result;
  const std::array<const double*, 2> blocks{from.data(), to.data()};
  std::array<double*, 2> jacobians{result.dfrom.data(), result.dto.data()};
  EXPECT_TRUE(cost.Evaluate(blocks.data(), result.residual.data(), jacobians.data()));
  return result;
}

GraphConstraint random_constraint(std::mt19937_64& random, double turn) {
  GraphConstraint constraint{{0}, {1}};
  constraint.from_T_to = Pose2(test::normal(random, 2.0), test::normal(random, 2.0), turn);
  Eigen::Matrix3d root;
  for (int i = 0; i < 9; ++i) root(i) = test::normal(random, 3.0);
  constraint.information = root.transpose() * root;
  return constraint;
}

TEST(RelativePoseCost, AgreesWithAutomaticDerivatives) {
  auto random = test::seeded_random();
  for (const double turn : {0.0, 1e-9, -1e-9, kPi, -kPi, kPi - 1e-9, 1e-9 - kPi, 3.0 * kPi, 0.7}) {
    for (int run = 0; run < 20; ++run) {
      const GraphConstraint constraint = random_constraint(random, turn);
      const Eigen::Vector3d from(test::normal(random, 5.0), test::normal(random, 5.0),
                                 test::uniform(random, -6.0, 6.0));
      const Eigen::Vector3d to(test::normal(random, 5.0), test::normal(random, 5.0),
                               test::uniform(random, -6.0, 6.0));
      const RelativePoseFactor factor(constraint);
      const ceres::AutoDiffCostFunction<PlainResidual, 3, 3, 3> automatic(
          new PlainResidual{constraint});

      const Evaluation ours = evaluate(RelativePoseCost(factor), from, to);
      const Evaluation theirs = evaluate(automatic, from, to);

      const double scale = 1.0 + theirs.dfrom.norm() + theirs.residual.norm();
      EXPECT_LT((ours.residual - theirs.residual).norm(), 1e-12 * scale);
      EXPECT_LT((ours.dfrom - theirs.dfrom).norm(), 1e-12 * scale);
      EXPECT_LT((ours.dto - theirs.dto).norm(), 1e-12 * scale);
    }
  }
}

TEST(RelativePoseCost, IsTheResidualOfTheConstraintWhitened) {
  auto random = test::seeded_random();
  for (int run = 0; run < 50; ++run) {
    const GraphConstraint constraint = random_constraint(random, test::uniform(random, -3.0, 3.0));
    const Pose2 from(test::normal(random, 5.0), 1.0, test::uniform(random, -3.0, 3.0));
    const Pose2 to(test::normal(random, 5.0), 2.0, test::uniform(random, -3.0, 3.0));

    const double squared =
        RelativePoseFactor(constraint)
            .residual({from.x(), from.y(), from.theta()}, {to.x(), to.y(), to.theta()})
            .squaredNorm();

    EXPECT_NEAR(squared, chi2_of(constraint, from, to), 1e-9 * squared);
  }
}

}  // namespace
}  // namespace falko_slam
