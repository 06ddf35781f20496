// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/slam/nearby_keyframes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "falko_slam/common/keyframe_id.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

struct Link {
  std::size_t a, b;
  Eigen::Matrix3d covariance;
};

// Keyframes here and there on a field, linked at random.
struct Town {
  std::vector<Pose2> poses;
  std::vector<double> paths;
  std::vector<Link> links;
  bool all_around = false;

  Town(std::size_t size, bool around, std::mt19937_64& random) : all_around(around) {
    for (std::size_t i = 0; i < size; ++i) {
      poses.emplace_back(test::uniform(random, 0.0, 8.0), test::uniform(random, 0.0, 8.0),
                         test::uniform(random, -kPi, kPi));
      paths.push_back(0.7 * static_cast<double>(i));
      for (int k = 0; k < 2 && i > 0; ++k) {
        if (k > 0 && test::uniform(random, 0.0, 1.0) < 0.5) continue;
        const auto other =
            static_cast<std::size_t>(test::uniform(random, 0.0, static_cast<double>(i) - 1e-9));
        const double place = test::uniform(random, 0.005, 0.06);
        const double turn = test::uniform(random, 0.001, 0.02);
        links.push_back({k > 0 ? other : i - 1, i,
                         Eigen::Vector3d(place * place, place * place, turn * turn).asDiagonal()});
      }
    }
  }
  NearbyKeyframes keyframes(const NearbyKeyframesParams& params) const {
    NearbyKeyframes result(params);
    for (const double path : paths) result.add(path, all_around);
    for (const Link& link : links) result.connect({link.a}, {link.b}, link.covariance);
    return result;
  }

  // Variances of all, seen from one: links are walked as long as that makes any of them surer.
  std::vector<double> variances(std::size_t source) const {
    std::vector<double> result(poses.size(), kFar);
    result[source] = 0.0;
    const auto arm = [&](std::size_t at) {
      return (poses[at].translation() - poses[source].translation()).squaredNorm();
    };
    for (bool better = true; better;) {
      better = false;
      for (const Link& link : links) {
        for (const auto& [from, to] : {std::pair(link.a, link.b), std::pair(link.b, link.a)}) {
          const double sum = result[from] + link.covariance(0, 0) + link.covariance(1, 1) +
                             arm(from) * link.covariance(2, 2);
          if (sum >= result[to]) continue;
          result[to] = sum;
          better = true;
        }
      }
    }
    return result;
  }

  std::vector<KeyframeId> nearby(std::size_t source, const NearbyKeyframesParams& params) const {
    const auto variance = variances(source);
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const double distance = (poses[i].translation() - poses[source].translation()).norm();
      const double turn = std::abs(angle_between(poses[source].theta(), poses[i].theta()));
      if (i == source || std::abs(paths[i] - paths[source]) < params.min_path ||
          distance > params.max_distance || (!all_around && turn > params.max_turn) ||
          std::sqrt(variance[i]) > params.max_drift) {
        continue;
      }
      order.push_back({distance + (all_around ? 0.0 : turn), i});
    }
    std::sort(order.begin(), order.end());
    std::vector<KeyframeId> result;
    for (const auto& [distance, i] : order) {
      const bool beside = std::any_of(result.begin(), result.end(), [&, i = i](KeyframeId other) {
        return std::abs(paths[other.value] - paths[i]) < params.spacing;
      });
      if (!beside && result.size() < static_cast<std::size_t>(params.count)) result.push_back({i});
    }
    return result;
  }
};

TEST(NearbyKeyframes, AreThoseOfABruteForceSearch) {
  auto random = test::seeded_random();
  std::size_t found = 0;
  for (int run = 0; run < 20; ++run) {
    const Town town(60, run % 2 == 0, random);
    NearbyKeyframesParams params;
    params.count = 1 + run % 5;
    params.max_drift = run % 3 == 0 ? 0.08 : 0.15;
    params.spacing = run % 4 == 0 ? 0.0 : 1.5;
    NearbyKeyframes keyframes = town.keyframes(params);
    for (std::size_t source = 0; source < town.poses.size(); ++source) {
      std::vector<KeyframeId> nearby;
      const auto variance = town.variances(source);
      for (const auto& [id, drift] : keyframes.find({source}, town.poses)) {
        nearby.push_back(id);
        EXPECT_NEAR(drift, std::sqrt(variance[id.value]), 1e-9);
      }
      EXPECT_EQ(nearby, town.nearby(source, params)) << run << ", " << source;
      found += nearby.size();
    }
  }
  EXPECT_GT(found, 500U);
}

TEST(NearbyKeyframes, DriftIsThatOfTheSurestChain) {
  auto random = test::seeded_random();
  const Town town(60, true, random);
  NearbyKeyframes keyframes = town.keyframes({});
  for (std::size_t source = 0; source < town.poses.size(); source += 7) {
    const auto variance = town.variances(source);
    const auto drifts = keyframes.drifts({source}, town.poses);
    for (std::size_t target = 0; target < town.poses.size(); ++target) {
      const double expected = std::sqrt(variance[target]);
      const auto within = keyframes.drift({source}, {target}, town.poses, expected + 1e-9);
      ASSERT_TRUE(within) << source << ", " << target;
      EXPECT_NEAR(*within, expected, 1e-9);
      EXPECT_NEAR(drifts[target], expected, 1e-9);
      if (target != source) {
        EXPECT_FALSE(keyframes.drift({source}, {target}, town.poses, 0.99 * expected));
      }
    }
  }
}

TEST(NearbyKeyframes, AreNoneWithoutAConnection) {
  NearbyKeyframes keyframes;
  for (int i = 0; i < 2; ++i) keyframes.add(10.0 * i, true);
  const std::vector<Pose2> poses(2);
  EXPECT_TRUE(keyframes.find({1}, poses).empty());
  EXPECT_FALSE(keyframes.drift({0}, {1}, poses, 10.0));
  EXPECT_EQ(keyframes.drifts({0}, poses), (std::vector<double>{0.0, kFar}));
  keyframes.connect({0}, {1}, 1e-4 * Eigen::Matrix3d::Identity());
  ASSERT_EQ(keyframes.find({1}, poses).size(), 1U);
  EXPECT_EQ(keyframes.find({1}, poses)[0].id, KeyframeId{0});
}

TEST(NearbyKeyframesParams, NamesFieldAndValueOfWhatIsWrong) {
  NearbyKeyframesParams params;
  params.count = 0;
  try {
    NearbyKeyframes keyframes(params);
    FAIL() << "no error";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("count = 0"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace falko_slam
