// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/phrase_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/seeds.hpp"

namespace falko_slam {
namespace {

std::vector<PhraseBag> random_bags(std::size_t count, std::mt19937_64& random) {
  std::vector<PhraseBag> bags(count);
  for (PhraseBag& bag : bags) {
    for (int i = 0; i < 8; ++i) ++bag[{random() % 4, random() % 4}];
  }
  return bags;
}

// Straight from the definition.
double similarity(const PhraseBag& a, const PhraseBag& b, const std::vector<PhraseBag>& all) {
  const auto weight = [&](const PhraseBag& bag, const Phrase& phrase) {
    const auto found = bag.find(phrase);
    const auto n = std::count_if(all.begin(), all.end(),
                                 [&](const PhraseBag& other) { return other.count(phrase) > 0; });
    if (found == bag.end() || n == 0) return 0.0;
    return found->second * std::log(static_cast<double>(all.size()) / static_cast<double>(n));
  };
  double product = 0.0, a_square = 0.0, b_square = 0.0;
  for (std::size_t first = 0; first < 4; ++first) {
    for (std::size_t second = 0; second < 4; ++second) {
      const double x = weight(a, {first, second});
      const double y = weight(b, {first, second});
      product += x * y;
      a_square += x * x;
      b_square += y * y;
    }
  }
  return product > 0.0 ? product / std::sqrt(a_square * b_square) : 0.0;
}

TEST(PhraseIndex, RanksAsTheDefinitionSays) {
  auto random = test::seeded_random();
  for (int run = 0; run < 20; ++run) {
    const auto bags = random_bags(12, random);
    const PhraseIndex index(bags);
    const PhraseBag query = random_bags(1, random).front();
    const auto found = index.nearest(query, 100);
    EXPECT_EQ(found.size(), static_cast<std::size_t>(
                                std::count_if(bags.begin(), bags.end(), [&](const PhraseBag& bag) {
                                  return similarity(query, bag, bags) > 0.0;
                                })));
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_NEAR(found[i].similarity, similarity(query, bags[found[i].scan], bags), 1e-12);
      EXPECT_GE(found[i > 0 ? i - 1 : 0].similarity, found[i].similarity);
    }
  }
}

TEST(PhraseIndex, FindsAScanItselfFirst) {
  auto random = test::seeded_random();
  const auto bags = random_bags(30, random);
  const PhraseIndex index(bags);
  for (const PhraseBag& bag : bags) {
    const auto found = index.nearest(bag, 1);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(bags[found.front().scan], bag);
    EXPECT_NEAR(found.front().similarity, 1.0, 1e-12);
  }
}

TEST(PhraseIndex, IsSymmetric) {
  auto random = test::seeded_random();
  const auto bags = random_bags(10, random);
  const PhraseIndex index(bags);
  const auto between = [&](std::size_t a, std::size_t b) {
    const auto found = index.nearest(bags[a], 1, [&](std::size_t scan) { return scan == b; });
    return found.empty() ? 0.0 : found.front().similarity;
  };
  for (std::size_t a = 0; a < 10; ++a) {
    for (std::size_t b = 0; b < a; ++b) EXPECT_NEAR(between(a, b), between(b, a), 1e-12);
  }
}

TEST(PhraseIndex, GivesTheFirstOfEqualsAndNoMoreThanAskedFor) {
  const PhraseBag bag = {{{1, 2}, 1}};
  const PhraseIndex index({{{{5, 6}, 1}}, bag, bag, bag});
  const auto found = index.nearest(bag, 2);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].scan, 1U);
  EXPECT_EQ(found[1].scan, 2U);
}

TEST(PhraseIndex, IgnoresPhrasesThatAllScansHave) {
  const PhraseBag everywhere = {{{1, 2}, 3}};
  const PhraseIndex index({everywhere, everywhere});
  EXPECT_TRUE(index.nearest(everywhere, 10).empty());
}

TEST(PhraseIndex, FindsNothingInNothing) {
  EXPECT_TRUE(PhraseIndex({}).nearest({{{1, 2}, 1}}, 10).empty());
  const PhraseIndex index({{}, {{{1, 2}, 1}}});
  EXPECT_EQ(index.size(), 2U);
  EXPECT_TRUE(index.nearest({}, 10).empty());
  EXPECT_TRUE(index.nearest({{{3, 4}, 1}}, 10).empty());
}

}  // namespace
}  // namespace falko_slam
