// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "joint_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "falko_slam/common/chi_square.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

// Distances that grow with every pair, by what the pair brings and what it has against the others.
class MadeUpDistance : public JointDistance {
 public:
  MadeUpDistance(std::vector<double> own, double clash) : own_(std::move(own)), clash_(clash) {}

  double with(std::size_t count, std::size_t pair) override {
    chosen_.resize(count);
    chosen_.push_back(pair);
    return of(chosen_);
  }
  double of(const std::vector<std::size_t>& pairs) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      sum += own_[pairs[i]];
      for (std::size_t j = 0; j < i; ++j)
        sum += clash_ * static_cast<double>((pairs[i] * 7 + pairs[j] * 3) % 5);
    }
    return sum;
  }

 private:
  std::vector<double> own_;
  double clash_;
  std::vector<std::size_t> chosen_;
};

struct Problem {
  JointPairs pairs;
  std::vector<double> own;
};

// The observations are already in the order of the search: up to three pairs each, one first.
Problem random_problem(std::mt19937_64& random) {
  Problem problem;
  problem.pairs.landmarks = 6;
  double distance = 0.0;
  for (std::size_t observation = 0; observation < 6; ++observation) {
    const std::size_t count = 1 + observation / 2;
    for (std::size_t k = 0; k < count; ++k) {
      distance += test::uniform(random, 0.01, 0.3);
      const auto landmark = static_cast<std::size_t>(test::uniform(random, 0.0, 5.999));
      problem.pairs.pairs.push_back({observation, landmark, distance});
      problem.own.push_back(distance);
    }
  }
  return problem;
}

struct Best {
  std::vector<std::vector<std::size_t>> sets;  // the best one and its rivals
  std::size_t most = 0;
  double least = 0.0;
};

Best exhaustive(const Problem& problem, const MadeUpDistance& distance,
                const JointSearchParams& params) {
  std::vector<std::pair<double, std::vector<std::size_t>>> all;
  const auto gates = joint_gates(params.joint_probability, 6);
  std::function<void(std::size_t, std::vector<std::size_t>)> choose =
      [&](std::size_t observation, std::vector<std::size_t> chosen) {
        if (observation == 6) return all.push_back({distance.of(chosen), chosen});
        choose(observation + 1, chosen);
        for (std::size_t p = 0; p < problem.pairs.pairs.size(); ++p) {
          const auto& pair = problem.pairs.pairs[p];
          const bool taken = std::any_of(chosen.begin(), chosen.end(), [&](std::size_t other) {
            return problem.pairs.pairs[other].landmark == pair.landmark;
          });
          if (pair.observation != observation || taken) continue;
          auto more = chosen;
          more.push_back(p);
          const double joint = distance.of(more);
          if (joint > gates[more.size()] || joint - distance.of(chosen) > params.step_gate)
            continue;
          choose(observation + 1, more);
        }
      };
  choose(0, {});
  Best best;
  for (const auto& [joint, chosen] : all) best.most = std::max(best.most, chosen.size());
  best.least = 1e300;
  for (const auto& [joint, chosen] : all) {
    if (chosen.size() == best.most) best.least = std::min(best.least, joint);
  }
  for (const auto& [joint, chosen] : all) {
    if (chosen.size() == best.most && joint <= best.least + params.ambiguity) {
      best.sets.push_back(chosen);
    }
  }
  return best;
}

// Pairs that all of the sets have.
std::vector<std::size_t> common(const std::vector<std::vector<std::size_t>>& sets) {
  std::vector<std::size_t> result;
  for (const std::size_t pair : sets.front()) {
    const bool everywhere = std::all_of(sets.begin(), sets.end(), [&](const auto& set) {
      return std::find(set.begin(), set.end(), pair) != set.end();
    });
    if (everywhere) result.push_back(pair);
  }
  std::sort(result.begin(), result.end());
  return result;
}

TEST(JointSearch, FindsWhatTryingEverythingFinds) {
  std::mt19937_64 random = test::seeded_random();
  for (int run = 0; run < 300; ++run) {
    const Problem problem = random_problem(random);
    MadeUpDistance distance(problem.own, test::uniform(random, 0.0, 1.5));
    JointSearchParams params;
    params.joint_probability = 0.8;
    params.step_gate = 8.0;
    params.ambiguity = test::uniform(random, 0.0, 0.5);
    params.max_nodes = 1000000;
    const Best expected = exhaustive(problem, distance, params);
    const JointSelection found = search_jointly(problem.pairs, distance, params);
    EXPECT_TRUE(found.proven);
    EXPECT_EQ(found.most, expected.most);
    EXPECT_NEAR(found.distance, expected.least, 1e-12);
    if (expected.sets.size() < 64) {
      EXPECT_EQ(found.pairs, common(expected.sets));
    }
  }
}

TEST(JointSearch, TakesTheBestSoFarWhereItIsCutShort) {
  JointPairs pairs;
  std::vector<double> own;
  for (std::size_t i = 0; i < 20; ++i) {
    pairs.pairs.push_back({i, i, 0.1});
    own.push_back(0.1);
  }
  pairs.landmarks = 20;
  MadeUpDistance distance(own, 0.0);
  JointSearchParams params;
  params.max_nodes = 7;
  const JointSelection found = search_jointly(pairs, distance, params);
  EXPECT_FALSE(found.proven);
  EXPECT_EQ(found.pairs.size(), 7U);
}

TEST(JointSearch, HasNothingToFindAmongNothing) {
  MadeUpDistance distance({}, 0.0);
  const JointSelection found = search_jointly({}, distance, {});
  EXPECT_TRUE(found.proven);
  EXPECT_TRUE(found.pairs.empty());
}

TEST(JointGates, AreThoseOfTheChiSquareLaw) {
  for (const double probability : {0.5, 0.95, 0.999}) {
    const auto gates = joint_gates(probability, 40);
    EXPECT_NEAR(pair_gate(probability), chi_square_bound(1.0 - probability, 2), 1e-6);
    for (std::size_t n = 1; n <= 40; ++n) {
      const double exact = chi_square_bound(1.0 - probability, 2 * static_cast<int>(n));
      EXPECT_NEAR(gates[n] / exact, 1.0, 0.02) << n;
    }
  }
}

}  // namespace
}  // namespace falko_slam
