// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "keypoint_clusters.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "support/seeds.hpp"

namespace falko_slam {
namespace {

std::vector<PlacedKeypoint> scattered(const std::vector<Eigen::Vector2d>& middles, double noise,
                                      std::size_t count) {
  std::mt19937_64 random = test::seeded_random();
  std::vector<PlacedKeypoint> keypoints;
  for (std::size_t i = 0; i < count; ++i) {
    for (const Eigen::Vector2d& middle : middles) {
      const Eigen::Vector2d off(test::normal(random, noise), test::normal(random, noise));
      keypoints.push_back({middle + off, 1e-4, i, i});
    }
  }
  return keypoints;
}

// Where the points of each cluster lie, whatever their order.
std::set<std::set<std::pair<double, double>>> places_of(
    const std::vector<PlacedKeypoint>& keypoints) {
  std::set<std::set<std::pair<double, double>>> places;
  for (const auto& members : cluster_keypoints(keypoints, 0.06)) {
    std::set<std::pair<double, double>> cluster;
    for (const std::size_t member : members) {
      cluster.insert({keypoints[member].point.x(), keypoints[member].point.y()});
    }
    places.insert(cluster);
  }
  return places;
}

TEST(KeypointClusters, PartWhatStandsApart) {
  const std::vector<Eigen::Vector2d> middles = {{0.0, 0.0}, {0.14, 0.0}, {-3.0, 700.0}};

  const auto clusters = cluster_keypoints(scattered(middles, 0.01, 200), 0.06);

  ASSERT_EQ(clusters.size(), 3U);
  for (const auto& members : clusters) {
    EXPECT_EQ(members.size(), 200U);
    for (const std::size_t member : members) EXPECT_EQ(member % 3, members.front() % 3);
  }
}

TEST(KeypointClusters, HoldEachKeypointOnce) {
  const auto keypoints = scattered({{0.0, 0.0}, {0.05, 0.02}, {0.12, 0.0}}, 0.05, 300);

  std::multiset<std::size_t> seen;
  for (const auto& members : cluster_keypoints(keypoints, 0.06)) {
    EXPECT_FALSE(members.empty());
    seen.insert(members.begin(), members.end());
  }

  EXPECT_EQ(seen.size(), keypoints.size());
  EXPECT_EQ(std::set<std::size_t>(seen.begin(), seen.end()).size(), keypoints.size());
}

TEST(KeypointClusters, AreTheSameInAnyOrder) {
  auto keypoints = scattered({{0.0, 0.0}, {0.05, 0.02}, {0.12, 0.0}}, 0.03, 100);
  const auto before = places_of(keypoints);
  std::mt19937_64 random = test::seeded_random();

  std::shuffle(keypoints.begin(), keypoints.end(), random);

  EXPECT_EQ(places_of(keypoints), before);
}

TEST(KeypointClusters, ThousandScansFromOnePlaceDoNotOutvoteManyPlaces) {
  std::vector<PlacedKeypoint> keypoints;
  for (std::size_t i = 0; i < 1000; ++i) keypoints.push_back({{0.05, 0.0}, 1e-4, i, 0});
  for (std::size_t i = 0; i < 20; ++i) keypoints.push_back({{-0.02, 0.0}, 1e-4, 1000 + i, 1 + i});

  const auto clusters = cluster_keypoints(keypoints, 0.06);

  ASSERT_EQ(clusters.size(), 2U);
  EXPECT_EQ(clusters.front().size(), 20U);
}

TEST(KeypointClusters, OfNothingAreNone) { EXPECT_TRUE(cluster_keypoints({}, 0.06).empty()); }

}  // namespace
}  // namespace falko_slam
