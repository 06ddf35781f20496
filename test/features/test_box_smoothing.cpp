// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "box_smoothing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/seeds.hpp"

namespace falko_slam {
namespace {

// The mean of the piecewise linear signal over a window, summed up in small steps.
double mean_by_steps(const std::vector<double>& abscissas, const std::vector<double>& values,
                     double from, double to) {
  constexpr int kSteps = 20000;
  double sum = 0.0;
  std::size_t i = 0;
  for (int step = 0; step < kSteps; ++step) {
    const double at = from + (to - from) * (step + 0.5) / kSteps;
    while (i + 2 < abscissas.size() && abscissas[i + 1] < at) ++i;
    const double share = (at - abscissas[i]) / (abscissas[i + 1] - abscissas[i]);
    sum += values[i] + share * (values[i + 1] - values[i]);
  }
  return sum / kSteps;
}

class BoxSmoothingOfUnevenSamples : public ::testing::Test {
 protected:
  BoxSmoothingOfUnevenSamples() {
    auto random = test::seeded_random();
    double abscissa = -3.0;
    for (int i = 0; i < 60; ++i) {
      abscissas_.push_back(abscissa += test::uniform(random, 0.01, 0.3));
      values_.push_back(test::uniform(random, -1.0, 1.0));
    }
  }

  std::vector<double> smoothed(std::vector<double> values, double width) {
    BoxSmoothing smoothing;
    smoothing.assign(abscissas_.data(), abscissas_.data() + abscissas_.size(), width);
    smoothing(values.data());
    return values;
  }

  std::vector<double> abscissas_, values_;
};

TEST_F(BoxSmoothingOfUnevenSamples, GivesTheMeansOverTheWindows) {
  for (const double width : {0.02, 0.3, 1.0, 100.0}) {
    const auto means = smoothed(values_, width);
    for (std::size_t i = 1; i + 1 < means.size(); ++i) {
      const double at = abscissas_[i];
      const double reach = std::min({width, at - abscissas_.front(), abscissas_.back() - at});
      EXPECT_NEAR(means[i], mean_by_steps(abscissas_, values_, at - reach, at + reach), 1e-3);
    }
  }
}

TEST_F(BoxSmoothingOfUnevenSamples, KeepsEndsAndStraightLines) {
  const auto means = smoothed(values_, 0.5);
  EXPECT_EQ(means.front(), values_.front());
  EXPECT_EQ(means.back(), values_.back());
  std::vector<double> line;
  for (const double abscissa : abscissas_) line.push_back(2.0 - 3.0 * abscissa);
  const auto same = smoothed(line, 0.5);
  for (std::size_t i = 0; i < line.size(); ++i) EXPECT_NEAR(same[i], line[i], 1e-12);
}

// Three windows are nearly a Gaussian whose standard deviation is their half-width: the mean of
// |s| is then sqrt(2 / pi) of it.
TEST(BoxSmoothing, ThriceIsNearlyAGaussian) {
  std::vector<double> abscissas, values;
  for (int i = -1000; i <= 1000; ++i) {
    abscissas.push_back(0.005 * i);
    values.push_back(std::abs(abscissas.back()));
  }
  BoxSmoothing smoothing;
  smoothing.assign(abscissas.data(), abscissas.data() + abscissas.size(), 1.0);
  for (int pass = 0; pass < 3; ++pass) smoothing(values.data());
  EXPECT_NEAR(values[1000], std::sqrt(2.0 / 3.141592653589793), 0.03);
}

TEST(BoxSmoothing, LeavesOneSampleAndEqualAbscissasAlone) {
  BoxSmoothing smoothing;
  std::vector<double> values = {4.0, 5.0, 6.0};
  const std::vector<double> abscissas = {1.0, 1.0, 1.0};
  for (const std::size_t size : {0U, 1U, 2U, 3U}) {
    smoothing.assign(abscissas.data(), abscissas.data() + size, 0.5);
    smoothing(values.data());
    EXPECT_EQ(values, (std::vector<double>{4.0, 5.0, 6.0})) << size;
  }
}

}  // namespace
}  // namespace falko_slam
