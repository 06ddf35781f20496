// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/geometric_phrases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "support/seeds.hpp"

namespace falko_slam {
namespace {

PhraseBag phrases(const std::vector<std::size_t>& words, bool closed, int reach) {
  PhraseParams params;
  params.reach = reach;
  return geometric_phrases(words, closed, params);
}

TEST(GeometricPhrases, ArePairsInOrderWithinReach) {
  const PhraseBag expected = {{{7, 8}, 1}, {{7, 9}, 1}, {{8, 9}, 1}, {{8, 7}, 1}, {{9, 7}, 1}};
  EXPECT_EQ(phrases({7, 8, 9, 7}, false, 2), expected);
}

TEST(GeometricPhrases, GoOverTheSeamOfAClosedScan) {
  const PhraseBag expected = {{{1, 2}, 1}, {{2, 3}, 1}, {{3, 1}, 1}};
  EXPECT_EQ(phrases({1, 2, 3}, true, 1), expected);
}

TEST(GeometricPhrases, OfAClosedScanDoNotDependOnWhereItStarts) {
  auto random = test::seeded_random();
  for (int run = 0; run < 50; ++run) {
    std::vector<std::size_t> words(12);
    for (std::size_t& word : words) word = random() % 5;
    const PhraseBag bag = phrases(words, true, 4);
    std::rotate(words.begin(), words.begin() + 5, words.end());
    EXPECT_EQ(phrases(words, true, 4), bag);
  }
}

TEST(GeometricPhrases, CountPairsOfWordsInCommonOrder) {
  // All six words in the same order, others in between: 6 * 5 / 2 phrases are shared.
  const PhraseBag one = phrases({1, 2, 3, 4, 5, 6}, false, 20);
  const PhraseBag other = phrases({1, 11, 2, 3, 12, 4, 5, 13, 6}, false, 20);
  std::size_t shared = 0;
  for (const auto& [phrase, times] : one) shared += other.count(phrase);
  EXPECT_EQ(shared, 15U);
}

TEST(GeometricPhrases, MeetEachPairOfAClosedScanOnce) {
  // Each word with every other one, none with itself.
  const PhraseBag bag = phrases({1, 2, 3, 4}, true, 1000);
  EXPECT_EQ(bag.size(), 12U);
  EXPECT_EQ(bag.count({1, 1}), 0U);
}

TEST(GeometricPhrases, OfFewerThanTwoWordsAreNone) {
  for (const bool closed : {false, true}) {
    EXPECT_TRUE(phrases({}, closed, 5).empty());
    EXPECT_TRUE(phrases({3}, closed, 5).empty());
  }
}

TEST(PhraseParams, NameFieldAndValueOfWhatIsWrong) {
  try {
    phrases({}, false, 0);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "reach = 0: must be in [1, 1000]");
  }
}

}  // namespace
}  // namespace falko_slam
