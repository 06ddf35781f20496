// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "thing_copies.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "support/poses.hpp"

namespace falko_slam {
namespace {

std::vector<Pose2> copies_of(const std::string& text, std::uint64_t seed = 1,
                             std::uint64_t number = 0) {
  const YamlFields fields = YamlFields::of_text(text, "w.yaml");
  std::vector<Pose2> copies = read_copies(fields, {1.0, 2.0, 0.5}, 1.0, seed, number);
  fields.refuse_unknown();
  return copies;
}

std::string complaint_about(const std::string& text) {
  try {
    copies_of(text);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

TEST(ThingCopies, AreTheThingAloneIfNothingIsSaid) {
  const auto copies = copies_of("{}");
  ASSERT_EQ(copies.size(), 1U);
  test::expect_near(copies[0], {1.0, 2.0, 0.5}, 1e-12);
}

TEST(ThingCopies, StandInRowsAndBlocks) {
  const auto row = copies_of("repeat: {count: 3, step: [1, -2, 0.1]}");
  ASSERT_EQ(row.size(), 3U);
  test::expect_near(row[2], {3.0, -2.0, 0.7}, 1e-12);
  const auto block = copies_of("repeat: [{count: 3, step: [1, 0]}, {count: 2, step: [0, 5]}]");
  ASSERT_EQ(block.size(), 6U);
  test::expect_near(block[1], {2.0, 2.0, 0.5}, 1e-12);
  test::expect_near(block[3], {1.0, 7.0, 0.5}, 1e-12);
  test::expect_near(block[5], {3.0, 7.0, 0.5}, 1e-12);
}

TEST(ThingCopies, ScatterButEachAlwaysAlike) {
  const std::string text = "{repeat: {count: 50, step: [0, 0]}, scatter: [0.1, 0.2, 0.01]";
  const auto copies = copies_of(text + "}");
  const auto fewer = copies_of(text + ", without: [0, 7]}");
  ASSERT_EQ(fewer.size(), 48U);
  test::expect_near(fewer[0], {copies[1].x(), copies[1].y(), copies[1].theta()}, 1e-12);
  test::expect_near(fewer[47], {copies[49].x(), copies[49].y(), copies[49].theta()}, 1e-12);
  EXPECT_NE(copies[0].x(), copies_of(text + "}", 2)[0].x());
  EXPECT_NE(copies[0].x(), copies_of(text + "}", 1, 1)[0].x());
  for (const Pose2& copy : copies) {
    EXPECT_LE(std::abs(copy.x() - 1.0), 0.3 + 1e-12);
    EXPECT_LE(std::abs(copy.y() - 2.0), 0.6 + 1e-12);
    EXPECT_LE(std::abs(copy.theta() - 0.5), 0.03 + 1e-12);
  }
}

TEST(ThingCopies, ScatterNormally) {
  constexpr int kCount = 20000;
  double sum = 0.0;
  double squares = 0.0;
  int within_one = 0;
  for (int i = 0; i < kCount; ++i) {
    const double value = scattered(7, 3, static_cast<std::uint64_t>(i));
    sum += value;
    squares += value * value;
    within_one += std::abs(value) < 1.0 ? 1 : 0;
  }
  EXPECT_NEAR(sum / kCount, 0.0, 0.03);
  EXPECT_NEAR(squares / kCount, 1.0, 0.04);
  EXPECT_NEAR(1.0 * within_one / kCount, 0.6827, 0.01);
}

// scripts/plot_scenario draws the same numbers.
TEST(ThingCopies, ScatterByTheseNumbersForEver) {
  EXPECT_NEAR(scattered(1, 0, 0), 1.1522560424818, 1e-12);
  EXPECT_NEAR(scattered(1, 2, 3), 1.65199656498027, 1e-12);
  EXPECT_NEAR(scattered(123456789, 40, 5), -1.16150237836528, 1e-12);
}

TEST(ThingCopies, AreRefusedWithTheirPath) {
  EXPECT_EQ(complaint_about("repeat: {count: 2}"), "w.yaml: line 1: repeat: step is missing");
  EXPECT_EQ(complaint_about("repeat: {step: [1, 2]}"), "w.yaml: line 1: repeat: count is missing");
  EXPECT_EQ(complaint_about("repeat: {count: 0, step: [1, 2]}"),
            "w.yaml: line 1: repeat.count: must be a whole number in [1, 10000]");
  EXPECT_EQ(complaint_about("repeat:\n- {count: 200, step: [1, 2]}\n- {count: 60, step: [1, 2]}"),
            "w.yaml: line 3: repeat[1].count: must be a whole number in [1, 50]");
  EXPECT_EQ(complaint_about("repeat: {count: 2, step: [1]}"),
            "w.yaml: line 1: repeat.step: must be [x, y, heading] or [x, y]");
  EXPECT_EQ(complaint_about("repeat: {count: 2, step: [1, 2], x: 1}"),
            "w.yaml: line 1: repeat.x: nobody knows this; known are count and step");
  EXPECT_EQ(complaint_about("without: [1]"),
            "w.yaml: line 1: without[0]: must be a whole number in [0, 0]");
  EXPECT_EQ(complaint_about("scatter: [1, 2]"), "w.yaml: line 1: scatter: must be three numbers");
  EXPECT_EQ(complaint_about("scatter: [1, 2, -1]"),
            "w.yaml: line 1: scatter[2]: must be a number in [0, 10]");
}

}  // namespace
}  // namespace falko_slam
