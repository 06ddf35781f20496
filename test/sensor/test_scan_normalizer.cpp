// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/sensor/scan_normalizer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// A scan message whose arrays live as long as it does.
struct Message {
  std::vector<float> ranges;
  std::vector<float> intensities;
  RawScan raw;

  explicit Message(std::vector<float> r) : ranges(std::move(r)) {
    raw.stamp = Time(std::chrono::seconds(100));
    raw.angle_min = -1.0;
    raw.angle_increment = 0.1;
    raw.angle_max = raw.angle_min + 0.1 * (static_cast<double>(ranges.size()) - 1.0);
    raw.time_increment = 0.001;
    raw.scan_time = 0.125;
    raw.range_min = 0.05;
    raw.range_max = 30.0;
  }

  ScanReport normalize(LaserScan& scan, const ScanNormalizerParams& params = {}) {
    raw.ranges = ranges.data();
    raw.range_count = ranges.size();
    raw.intensities = intensities.data();
    raw.intensity_count = intensities.size();
    return falko_slam::normalize(raw, params, scan);
  }
};

// Full circle, range i + 1 for beam i.
Message full_circle(std::size_t beams) {
  std::vector<float> ranges;
  for (std::size_t i = 0; i < beams; ++i) ranges.push_back(1.0F + 0.001F * static_cast<float>(i));
  Message message(std::move(ranges));
  message.raw.angle_min = -kPi;
  message.raw.angle_increment = kTwoPi / static_cast<double>(beams);
  message.raw.angle_max = kPi - message.raw.angle_increment;
  return message;
}

TEST(Normalize, KeepsAPlainScanAsItIs) {
  Message message({1.0F, 2.0F, 3.0F});
  LaserScan scan;
  const ScanReport report = message.normalize(scan);
  EXPECT_TRUE(report.usable());
  EXPECT_EQ(scan.ranges, (std::vector<double>{1.0, 2.0, 3.0}));
  EXPECT_FALSE(scan.closed);
  EXPECT_FALSE(scan.reversed);
  EXPECT_NEAR(scan.bearing(2), -0.8, 1e-12);
  EXPECT_EQ(scan.message_index(2), 2U);
  EXPECT_NEAR((scan.point(1) - 2.0 * Eigen::Vector2d(std::cos(-0.9), std::sin(-0.9))).norm(), 0.0,
              1e-12);
}

TEST(Normalize, TypesEveryKindOfInvalidRange) {
  Message message({kNaN, kInfinity, -kInfinity, 0.0F, -1.0F, 0.04F, 0.05F, 30.0F, 30.1F});
  LaserScan scan;
  const ScanReport report = message.normalize(scan);
  const std::vector<BeamStatus> expected = {
      BeamStatus::kErroneous, BeamStatus::kNoReturn, BeamStatus::kTooNear,
      BeamStatus::kZero,      BeamStatus::kTooNear,  BeamStatus::kTooNear,
      BeamStatus::kValid,     BeamStatus::kValid,    BeamStatus::kTooFar};
  // 0.05F is a little above the double 0.05 and counts as valid.
  EXPECT_EQ(scan.status, expected);
  for (std::size_t i = 0; i < scan.size(); ++i)
    EXPECT_EQ(std::isnan(scan.ranges[i]), !scan.valid(i));
  EXPECT_EQ(report.count(BeamStatus::kValid), 2U);
  EXPECT_EQ(report.count(BeamStatus::kTooNear), 3U);
}

TEST(Normalize, ZeroMeansNoReturnOnlyWhenTold) {
  Message message({0.0F, 1.0F});
  ScanNormalizerParams params;
  params.zero_is_no_return = true;
  LaserScan scan;
  message.normalize(scan, params);
  EXPECT_EQ(scan.status[0], BeamStatus::kNoReturn);
}

TEST(Normalize, TakesAMissingRangeMaxAsUnlimited) {
  for (const double range_max : {0.0, -1.0, std::nan(""), static_cast<double>(kInfinity)}) {
    Message message({1.0F, 500.0F, kInfinity});
    message.raw.range_max = range_max;
    LaserScan scan;
    message.normalize(scan);
    EXPECT_TRUE(scan.valid(1)) << range_max;
    EXPECT_FALSE(scan.valid(2)) << range_max;
  }
}

TEST(Normalize, AppliesTheRangeLimitsOfItsParameters) {
  Message message({1.0F, 5.0F, 9.0F});
  ScanNormalizerParams params;
  params.min_range = 2.0;
  params.max_range = 8.0;
  LaserScan scan;
  message.normalize(scan, params);
  EXPECT_EQ(scan.status, (std::vector<BeamStatus>{BeamStatus::kTooNear, BeamStatus::kValid,
                                                  BeamStatus::kTooFar}));
}

TEST(Normalize, AddsTheRangeOffset) {
  Message message({1.0F, 0.06F});
  ScanNormalizerParams params;
  params.range_offset = -0.1;
  LaserScan scan;
  message.normalize(scan, params);
  EXPECT_NEAR(scan.ranges[0], 0.9, 1e-6);
  EXPECT_EQ(scan.status[1], BeamStatus::kTooNear);  // nothing left of it
}

TEST(Normalize, TurnsAClockwiseScan) {
  Message message({1.0F, 2.0F, 3.0F});
  message.intensities = {10.0F, 20.0F, 30.0F};
  message.raw.angle_min = 1.0;
  message.raw.angle_increment = -0.1;
  message.raw.angle_max = 0.8;
  LaserScan scan;
  message.normalize(scan);
  EXPECT_TRUE(scan.reversed);
  EXPECT_EQ(scan.ranges, (std::vector<double>{3.0, 2.0, 1.0}));
  EXPECT_EQ(scan.intensities, (std::vector<float>{30.0F, 20.0F, 10.0F}));
  EXPECT_NEAR(scan.bearing(0), 0.8, 1e-12);
  EXPECT_NEAR(scan.bearing(2), 1.0, 1e-12);
  EXPECT_EQ(scan.message_index(0), 2U);
  // Beam 2 was the first one measured.
  EXPECT_EQ(scan.beam_time(2), message.raw.stamp);
  EXPECT_EQ(scan.beam_time(0) - scan.beam_time(2), std::chrono::milliseconds(2));
}

TEST(Normalize, MirrorsAnUpsideDownLaser) {
  Message message({1.0F, 2.0F, 3.0F});
  ScanNormalizerParams params;
  params.upside_down = true;
  LaserScan scan;
  message.normalize(scan, params);
  // Bearings -1.0, -0.9, -0.8 become 1.0, 0.9, 0.8.
  EXPECT_EQ(scan.ranges, (std::vector<double>{3.0, 2.0, 1.0}));
  EXPECT_NEAR(scan.bearing(0), 0.8, 1e-12);
  EXPECT_GT(scan.angle_increment, 0.0);
  EXPECT_EQ(scan.beam_time(2), message.raw.stamp);
}

TEST(Normalize, AnUpsideDownClockwiseScanKeepsItsOrder) {
  Message message({1.0F, 2.0F, 3.0F});
  message.raw.angle_min = 1.0;
  message.raw.angle_increment = -0.1;
  ScanNormalizerParams params;
  params.upside_down = true;
  LaserScan scan;
  message.normalize(scan, params);
  EXPECT_FALSE(scan.reversed);
  EXPECT_EQ(scan.ranges, (std::vector<double>{1.0, 2.0, 3.0}));
  EXPECT_NEAR(scan.bearing(0), -1.0, 1e-12);
}

TEST(Normalize, SeesThatAFullCircleIsClosed) {
  LaserScan scan;
  Message message = full_circle(1440);
  message.normalize(scan);
  EXPECT_TRUE(scan.closed);
  EXPECT_EQ(scan.size(), 1440U);
}

TEST(Normalize, AFullCircleInSinglePrecisionIsClosed) {
  LaserScan scan;
  Message message = full_circle(1440);
  message.raw.angle_increment = static_cast<double>(0.00436332F);
  message.normalize(scan);
  EXPECT_TRUE(scan.closed);
}

TEST(Normalize, DropsABeamThatRepeatsTheFirst) {
  LaserScan scan;
  Message message = full_circle(1440);
  message.ranges.push_back(77.0F);
  const ScanReport report = message.normalize(scan);
  EXPECT_TRUE(scan.closed);
  EXPECT_EQ(scan.size(), 1440U);
  EXPECT_EQ(report.surplus_beams, 1U);
  EXPECT_EQ(report.beam_count, 1441U);
  EXPECT_NEAR(scan.ranges[1439], 1.0 + 1.439, 1e-5);
}

TEST(Normalize, AThreeQuarterCircleIsOpen) {
  LaserScan scan;
  Message message = full_circle(1440);
  message.ranges.resize(1081);
  message.normalize(scan);
  EXPECT_FALSE(scan.closed);
}

TEST(Normalize, AngleMaxOnePastTheLastBeamIsNoDisagreement) {
  LaserScan scan;
  Message message = full_circle(1440);
  message.raw.angle_max = kPi;  // as the SICK driver has it
  const ScanReport report = message.normalize(scan);
  EXPECT_FALSE(report.angles_disagree());
  EXPECT_NEAR(report.angle_max_excess, 1.0, 1e-6);
}

TEST(Normalize, TellsWhenAnglesAndBeamsDisagree) {
  for (const int extra : {-20, 20}) {
    Message message({1.0F, 2.0F, 3.0F});
    message.raw.angle_max += 0.1 * extra;
    LaserScan scan;
    const ScanReport report = message.normalize(scan);
    EXPECT_TRUE(report.usable());
    EXPECT_TRUE(report.angles_disagree());
    EXPECT_EQ(scan.size(), 3U);  // the number of ranges is the truth
    EXPECT_NEAR(report.angle_max_excess, extra, 1e-6);
  }
}

TEST(Normalize, DerivesAMissingAngleIncrement) {
  Message message({1.0F, 2.0F, 3.0F});
  message.raw.angle_increment = 0.0;
  message.raw.angle_max = 1.0;
  LaserScan scan;
  const ScanReport report = message.normalize(scan);
  EXPECT_TRUE(report.angle_increment_derived);
  EXPECT_NEAR(scan.angle_increment, 1.0, 1e-12);
}

TEST(Normalize, DerivesAMissingTimeIncrementFromTheScanTime) {
  for (const double stated : {0.0, -1.0, std::nan(""), 1e12}) {
    LaserScan scan;
    Message message = full_circle(1440);
    message.raw.time_increment = stated;
    const ScanReport report = message.normalize(scan);
    EXPECT_TRUE(report.time_increment_derived) << stated;
    EXPECT_NEAR(to_seconds(scan.time_increment), 0.125 / 1440.0, 1e-9) << stated;
  }
}

TEST(Normalize, WithoutAnyTimesAllBeamsAreOfOneInstant) {
  Message message({1.0F, 2.0F});
  message.raw.time_increment = 0.0;
  message.raw.scan_time = 0.0;
  LaserScan scan;
  message.normalize(scan);
  EXPECT_EQ(scan.beam_time(1), message.raw.stamp);
}

TEST(Normalize, PutsTheStampOnTheBeamItIsToldTo) {
  Message message({1.0F, 2.0F, 3.0F});
  using StampAt = ScanNormalizerParams::StampAt;
  for (const auto& [stamp_at, beam] :
       {std::make_pair(StampAt::kFirstBeam, 0U), std::make_pair(StampAt::kMiddleBeam, 1U),
        std::make_pair(StampAt::kLastBeam, 2U)}) {
    ScanNormalizerParams params;
    params.stamp_at = stamp_at;
    LaserScan scan;
    message.normalize(scan, params);
    EXPECT_EQ(scan.beam_time(beam), message.raw.stamp);
  }
}

TEST(Normalize, FillsShortIntensitiesAndCountsThem) {
  Message message({1.0F, 2.0F, 3.0F});
  message.intensities = {5.0F};
  LaserScan scan;
  const ScanReport report = message.normalize(scan);
  ASSERT_EQ(scan.intensities.size(), 3U);
  EXPECT_EQ(scan.intensities[0], 5.0F);
  EXPECT_TRUE(std::isnan(scan.intensities[2]));
  EXPECT_EQ(report.missing_intensities, 2U);
}

TEST(Normalize, EmptyIntensitiesStayEmpty) {
  Message message({1.0F, 2.0F});
  LaserScan scan;
  scan.intensities = {1.0F, 2.0F};  // of the scan before
  const ScanReport report = message.normalize(scan);
  EXPECT_TRUE(scan.intensities.empty());
  EXPECT_EQ(report.missing_intensities, 0U);
}

TEST(Normalize, IgnoresSurplusIntensities) {
  Message message({1.0F, 2.0F});
  message.intensities = {1.0F, 2.0F, 3.0F};
  LaserScan scan;
  message.normalize(scan);
  EXPECT_EQ(scan.intensities.size(), 2U);
}

TEST(Normalize, AnEmptyScanIsAFaultNotACrash) {
  Message message({});
  LaserScan scan;
  scan.ranges = {1.0};
  const ScanReport report = message.normalize(scan);
  EXPECT_EQ(report.fault, ScanFault::kNoBeams);
  EXPECT_EQ(scan.size(), 0U);
}

TEST(Normalize, OneBeamIsAScan) {
  Message message({2.0F});
  message.raw.angle_increment = 0.0;
  LaserScan scan;
  EXPECT_TRUE(message.normalize(scan).usable());
  EXPECT_EQ(scan.size(), 1U);
  EXPECT_FALSE(scan.closed);
}

TEST(Normalize, RefusesAnglesThatAreNone) {
  for (const double bad : {std::nan(""), static_cast<double>(kInfinity), 1e9}) {
    Message message({1.0F, 2.0F});
    message.raw.angle_min = bad;
    LaserScan scan;
    EXPECT_EQ(message.normalize(scan).fault, ScanFault::kBadAngles) << bad;
    EXPECT_EQ(scan.size(), 0U);
  }
  Message message({1.0F, 2.0F});
  message.raw.angle_increment = std::nan("");
  message.raw.angle_max = std::nan("");
  LaserScan scan;
  EXPECT_EQ(message.normalize(scan).fault, ScanFault::kBadAngles);
}

// The beams of a turn would be more than any number counts.
TEST(Normalize, TakesAnAngleIncrementOfNearlyNothingForNone) {
  Message message({1.0F, 2.0F, 3.0F});
  message.raw.angle_increment = 1e-38;
  message.raw.angle_min = -0.1;
  message.raw.angle_max = 0.1;
  LaserScan scan;
  EXPECT_TRUE(message.normalize(scan).angle_increment_derived);
  EXPECT_NEAR(scan.angle_increment, 0.1, 1e-12);
  message.raw.angle_max = message.raw.angle_min + 1e-38;
  EXPECT_EQ(message.normalize(scan).fault, ScanFault::kBadAngles);
}

TEST(Normalize, CutsAScanOfManyTurnsToOne) {
  Message message(std::vector<float>(100000, 2.0F));
  message.raw.angle_increment = 0.01;
  LaserScan scan;
  const ScanReport report = message.normalize(scan);
  EXPECT_EQ(scan.size(), 628U);
  EXPECT_EQ(report.surplus_beams, 100000U - 628U);
  EXPECT_TRUE(scan.closed);
}

TEST(Normalize, AllInvalidIsUsableAndSaysSo) {
  Message message(std::vector<float>(10, kNaN));
  LaserScan scan;
  const ScanReport report = message.normalize(scan);
  EXPECT_TRUE(report.usable());
  EXPECT_EQ(report.count(BeamStatus::kValid), 0U);
  EXPECT_EQ(describe(report), "10 beams: 0 valid, 10 NaN");
}

TEST(ValidateScanNormalizerParams, NamesFieldAndValue) {
  ScanNormalizerParams params;
  params.max_range = -3.0;
  try {
    validate(params);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("max_range = -3"), std::string::npos) << error.what();
  }
  params = {};
  params.min_range = std::nan("");
  EXPECT_THROW(validate(params), std::invalid_argument);
  params = {};
  params.range_offset = static_cast<double>(kInfinity);
  EXPECT_THROW(validate(params), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
