// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/signature_index.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <stdexcept>

#include "falko_slam/common/whole_file.hpp"
#include "falko_slam/place_recognition/glare.hpp"
#include "support/random_points.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

using test::random_points;

// Signatures of places seen several times: copies with noise, turned, some points missing.
class SignatureIndexTest : public ::testing::Test {
 protected:
  Signature next() {
    if (places_.size() < 60) places_.push_back(random_points(12, 8.0, random_));
    std::vector<Eigen::Vector2d> seen;
    const Pose2 turn(0.0, 0.0, test::uniform(random_, -3.0, 3.0));
    for (const auto& point : places_[random_() % places_.size()]) {
      if (random_() % 8 == 0) continue;
      seen.push_back(turn * point +
                     Eigen::Vector2d(test::normal(random_, 0.03), test::normal(random_, 0.03)));
    }
    return glare(seen);
  }

  void fill(SignatureIndex& index, std::uint64_t first, std::uint64_t count) {
    for (std::uint64_t id = first; id < first + count; ++id) index.add({id}, next());
  }

  void expect_exact(const SignatureIndex& index, std::size_t count,
                    const SignatureIndex::Admission& admits = {}) {
    const Signature query = next();
    const auto expected = index.nearest_by_brute_force(query, count, admits);
    const auto found = index.nearest(query, count, admits);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].id, expected[i].id);
      EXPECT_EQ(found[i].distance, expected[i].distance);
      EXPECT_EQ(found[i].shift, expected[i].shift);
    }
  }

  std::mt19937_64 random_ = test::seeded_random();
  std::vector<std::vector<Eigen::Vector2d>> places_;
};

TEST_F(SignatureIndexTest, FindsWhatASearchThroughAllFinds) {
  SignatureIndex index(8, 50);
  for (const std::uint64_t count : {1U, 10U, 116U, 1U, 1U, 500U, 1200U}) {
    fill(index, index.size(), count);
    for (const std::size_t wanted : {1U, 10U, 50U}) expect_exact(index, wanted);
  }
}

TEST_F(SignatureIndexTest, BruteForceIsInTheOrderOfDistances) {
  SignatureIndex index(8, 50);
  std::vector<Signature> all;
  for (std::uint64_t id = 0; id < 300; ++id) {
    all.push_back(next());
    index.add({id}, all.back());
  }
  const Signature query = next();
  std::multiset<std::uint32_t> distances;
  for (const Signature& signature : all) {
    distances.insert(shifted_distance(signature, query).distance);
  }
  auto expected = distances.begin();
  for (const SignatureMatch& match : index.nearest_by_brute_force(query, 20)) {
    EXPECT_EQ(match.distance, *expected++);
    const auto& found = all[static_cast<std::size_t>(match.id.value)];
    EXPECT_EQ(match.distance, shifted_distance(found, query).distance);
  }
}

TEST_F(SignatureIndexTest, LeavesOutWhatIsNotAdmitted) {
  SignatureIndex index(8, 50);
  fill(index, 0, 700);
  const auto outside_window = [](KeyframeId id) { return id.value < 200 || id.value > 450; };
  for (int i = 0; i < 10; ++i) expect_exact(index, 10, outside_window);
  for (const auto& match : index.nearest(next(), 700, outside_window)) {
    EXPECT_TRUE(outside_window(match.id));
  }
}

TEST_F(SignatureIndexTest, StaysExactWhileItGrowsAndShrinks) {
  SignatureIndex index(8, 50);
  std::set<std::uint64_t> alive;
  for (std::uint64_t id = 0; id < 3000; ++id) {
    index.add({id}, next());
    alive.insert(id);
    while (alive.size() > 400 || (id > 2500 && alive.size() > 20)) {
      auto victim = alive.begin();
      std::advance(victim, static_cast<std::ptrdiff_t>(random_() % alive.size()));
      EXPECT_TRUE(index.remove({*victim}));
      EXPECT_FALSE(index.contains({*victim}));
      alive.erase(victim);
    }
    EXPECT_EQ(index.size(), alive.size());
    if (id % 100 == 0) expect_exact(index, 10);
  }
  for (const auto& match : index.nearest(next(), 100)) EXPECT_EQ(alive.count(match.id.value), 1U);
}

TEST_F(SignatureIndexTest, KnowsEqualSignaturesApartByTheirIds) {
  SignatureIndex index(8, 50);
  const Signature same = next();
  for (std::uint64_t id = 500; id > 0; --id) index.add({id}, same);
  const auto found = index.nearest(same, 3);
  ASSERT_EQ(found.size(), 3U);
  for (std::uint64_t i = 0; i < 3; ++i) EXPECT_EQ(found[i].id.value, i + 1);
}

TEST_F(SignatureIndexTest, GivesFewerWhenThereAreFewer) {
  SignatureIndex index(8, 50);
  EXPECT_TRUE(index.nearest(next(), 10).empty());
  fill(index, 0, 3);
  EXPECT_EQ(index.nearest(next(), 10).size(), 3U);
  EXPECT_TRUE(index.nearest(next(), 0).empty());
}

TEST_F(SignatureIndexTest, RefusesOtherShapesAndIdsTwice) {
  SignatureIndex index(8, 50);
  fill(index, 0, 1);
  EXPECT_THROW(index.add({0}, next()), std::invalid_argument);
  EXPECT_THROW(index.add({1}, (Signature{1, 1, {0}})), std::invalid_argument);
  EXPECT_THROW(index.nearest((Signature{1, 1, {0}}), 1), std::invalid_argument);
  EXPECT_THROW(SignatureIndex(0, 50), std::invalid_argument);
  EXPECT_THROW(SignatureIndex(65, 50), std::invalid_argument);
  EXPECT_FALSE(index.remove({7}));
  EXPECT_EQ(index.size(), 1U);
}

TEST_F(SignatureIndexTest, ComesBackFromItsFile) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("places.sig");
  SignatureIndex index(8, 50);
  fill(index, 0, 600);
  for (std::uint64_t id = 0; id < 600; id += 3) index.remove({id});
  index.save(path);
  const SignatureIndex loaded = SignatureIndex::load(path);

  EXPECT_EQ(loaded.size(), 400U);
  const Signature query = next();
  const auto expected = index.nearest(query, 20);
  const auto found = loaded.nearest(query, 20);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].id, expected[i].id);
}

TEST_F(SignatureIndexTest, TellsWhatIsWrongWithAFile) {
  const test::TemporaryFolder folder;
  SignatureIndex index(8, 50);
  fill(index, 0, 20);
  index.save(folder.file("good"));
  const std::string good = read_whole_file(folder.file("good"));
  const auto error_of = [&](const std::string& content) {
    std::ofstream(folder.file("bad"), std::ios::binary) << content;
    try {
      SignatureIndex::load(folder.file("bad"));
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };

  std::string flipped = good;
  flipped[good.size() / 2] = static_cast<char>(flipped[good.size() / 2] ^ 1);
  EXPECT_EQ(error_of(flipped),
            folder.file("bad") + ": damaged or cut short: the checksum does not fit");
  EXPECT_EQ(error_of(good.substr(0, good.size() - 100)),
            folder.file("bad") + ": damaged or cut short: the checksum does not fit");
  EXPECT_EQ(error_of(good.substr(0, 15)), folder.file("bad") + ": ends too early");
  EXPECT_EQ(error_of(""), folder.file("bad") + ": no file of signatures");
  EXPECT_EQ(error_of("something else"), folder.file("bad") + ": no file of signatures");
  EXPECT_THROW(SignatureIndex::load(folder.file("none")), std::runtime_error);
  EXPECT_THROW(index.save(folder.file("no/such/folder")), std::runtime_error);
}

}  // namespace
}  // namespace falko_slam
