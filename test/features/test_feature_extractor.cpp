// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/features/feature_extractor.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "support/seeds.hpp"
#include "support/synthetic_scans.hpp"

namespace {
std::atomic<std::size_t> allocations{0};
}

// Counts every allocation of this program. (Inlined, free() would look as if it took what it may
// not.)
void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t& /*tag*/) noexcept {
  ++allocations;
  return std::malloc(size);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  const auto step = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(step, (size + step - 1) / step * step)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace falko_slam {
namespace {

RawScan raw_scan(const std::vector<float>& ranges) {
  RawScan raw;
  raw.angle_min = -kPi;
  raw.angle_increment = kTwoPi / static_cast<double>(ranges.size());
  raw.angle_max = kPi - raw.angle_increment;
  raw.range_max = 100.0;
  raw.ranges = ranges.data();
  raw.range_count = ranges.size();
  return raw;
}

std::vector<float> office_ranges(const Pose2& pose, std::mt19937_64& random) {
  return simulate_ranges(office_scene(), pose, {}, random);
}

TEST(FeatureExtractor, GoesFromMessageToFeatures) {
  auto random = test::seeded_random();
  const auto ranges = office_ranges({-3.0, -1.0, 0.4}, random);
  FeatureExtractor extractor;
  const ScanReport report = extractor.extract(raw_scan(ranges));
  EXPECT_TRUE(report.usable());
  EXPECT_TRUE(extractor.scan().closed);
  EXPECT_GT(extractor.features().size(), 5U);
}

TEST(FeatureExtractor, AnUnusableScanLeavesNothingOfTheLastOne) {
  auto random = test::seeded_random();
  const auto ranges = office_ranges({-3.0, -1.0, 0.4}, random);
  FeatureExtractor extractor;
  extractor.extract(raw_scan(ranges));
  const ScanReport report = extractor.extract(raw_scan({}));
  EXPECT_FALSE(report.usable());
  EXPECT_TRUE(extractor.features().empty());
  EXPECT_EQ(extractor.scan().size(), 0U);
}

TEST(FeatureExtractor, AllocatesNothingInSteadyState) {
  auto random = test::seeded_random();
  std::vector<std::vector<float>> scans;
  for (double x = -7.0; x < 7.0; x += 0.5) scans.push_back(office_ranges({x, -1.0, x}, random));
  FeatureExtractor extractor;
  for (int warm_up = 0; warm_up < 2; ++warm_up) {
    for (const auto& scan : scans) extractor.extract(raw_scan(scan));
  }
  const std::size_t before = allocations;
  for (const auto& scan : scans) extractor.extract(raw_scan(scan));

  EXPECT_EQ(allocations - before, 0U);
}

}  // namespace
}  // namespace falko_slam
