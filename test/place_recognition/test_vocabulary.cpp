// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/vocabulary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "support/seeds.hpp"

namespace falko_slam {
namespace {

using Descriptors = std::vector<Vocabulary::Descriptor>;

// `count` descriptors around each of three places far from each other.
Descriptors three_clouds(int count, std::mt19937_64& random) {
  Descriptors descriptors;
  for (const auto& center : Descriptors{{0.0F, 0.0F}, {10.0F, 0.0F}, {0.0F, 10.0F}}) {
    for (int i = 0; i < count; ++i) {
      descriptors.push_back(center);
      for (float& number : descriptors.back()) {
        number += static_cast<float>(test::normal(random, 0.5));
      }
    }
  }
  return descriptors;
}

VocabularyParams words(int count) {
  VocabularyParams params;
  params.words = count;
  return params;
}

TEST(Vocabulary, LearnsTheMeansOfClouds) {
  auto random = test::seeded_random();
  const Descriptors descriptors = three_clouds(200, random);
  const auto vocabulary = Vocabulary::learned(descriptors, words(3));
  ASSERT_EQ(vocabulary.size(), 3U);
  for (std::size_t cloud = 0; cloud < 3; ++cloud) {
    const std::size_t word = vocabulary.word_of(descriptors[200 * cloud]);
    float x = 0.0F;
    for (std::size_t i = 200 * cloud; i < 200 * cloud + 200; ++i) {
      EXPECT_EQ(vocabulary.word_of(descriptors[i]), word);
      x += descriptors[i][0] / 200.0F;
    }
    EXPECT_NEAR(vocabulary.words()[word][0], x, 1e-4);
  }
}

TEST(Vocabulary, IsTheSameForTheSameDescriptorsAndSeed) {
  auto random = test::seeded_random();
  const Descriptors descriptors = three_clouds(50, random);
  VocabularyParams params = words(12);
  params.samples = 100;
  EXPECT_EQ(Vocabulary::learned(descriptors, params).words(),
            Vocabulary::learned(descriptors, params).words());
}

TEST(Vocabulary, TakesTheNearestWord) {
  auto random = test::seeded_random();
  const auto vocabulary = Vocabulary::learned(three_clouds(50, random), words(20));
  for (int i = 0; i < 100; ++i) {
    const Vocabulary::Descriptor descriptor = {static_cast<float>(test::uniform(random, -2, 12)),
                                               static_cast<float>(test::uniform(random, -2, 12))};
    const auto square = [&](const Vocabulary::Descriptor& word) {
      return (word[0] - descriptor[0]) * (word[0] - descriptor[0]) +
             (word[1] - descriptor[1]) * (word[1] - descriptor[1]);
    };
    const auto nearest =
        std::min_element(vocabulary.words().begin(), vocabulary.words().end(),
                         [&](const auto& a, const auto& b) { return square(a) < square(b); });
    EXPECT_EQ(&vocabulary.words()[vocabulary.word_of(descriptor)], &*nearest);
  }
}

TEST(Vocabulary, HasNoMoreWordsThanThereAreDifferentDescriptors) {
  const Descriptors twice = {{1.0F}, {2.0F}, {1.0F}, {2.0F}};
  EXPECT_EQ(Vocabulary::learned(twice, words(10)).size(), 2U);
  EXPECT_EQ(Vocabulary::learned({{1.0F}}, words(10)).size(), 1U);
  EXPECT_EQ(Vocabulary::learned({}, words(10)).size(), 0U);
}

TEST(Vocabulary, SaysWhatIsWrong) {
  const auto complaint = [](const auto& work) -> std::string {
    try {
      work();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(complaint([] {
              Vocabulary::learned({{1.0F}, {1.0F, 2.0F}});
            }),
            "descriptors of 1 and of 2 numbers");
  EXPECT_EQ(complaint([] { Vocabulary(Descriptors()).word_of({1.0F}); }),
            "vocabulary: it has no words");
  EXPECT_EQ(complaint([] { Vocabulary(Descriptors{{1.0F}}).word_of({}); }),
            "descriptor of 0 numbers; those of the words have 1");
  EXPECT_EQ(complaint([] { Vocabulary::learned({}, words(0)); }),
            "words = 0: must be in [1, 10000]");
}

}  // namespace
}  // namespace falko_slam
