// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/features/beta_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "falko_slam/evaluation/scan_perturbation.hpp"
#include "falko_slam/features/falko.hpp"
#include "falko_slam/features/flirt.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "support/hand_made_scans.hpp"
#include "support/seeds.hpp"
#include "support/synthetic_scans.hpp"

namespace falko_slam {
namespace {

struct Cell {
  double inner, outer;  // [m]
  double begin, end;    // from the orientation [rad], in [0, 2 pi]

  bool contains(const Eigen::Vector2d& point) const {
    double angle = std::atan2(point.y(), point.x());
    if (angle < 0.0) angle += kTwoPi;
    return point.norm() >= inner && point.norm() < outer && angle >= begin && angle < end;
  }
};

// Whether the way from a to b is somewhere inside the cell: between each two of the places where it
// may cross a border it is inside or outside altogether.
bool crosses(const Cell& cell, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  std::vector<double> places = {0.0, 1.0};
  for (const double radius : {cell.inner, cell.outer}) {
    const double p = a.dot(along) / along.squaredNorm();
    const double q = (a.squaredNorm() - radius * radius) / along.squaredNorm();
    if (p * p < q) continue;
    places.push_back(-p - std::sqrt(p * p - q));
    places.push_back(-p + std::sqrt(p * p - q));
  }
  for (const double angle : {cell.begin, cell.end}) {
    const Eigen::Vector2d normal(-std::sin(angle), std::cos(angle));
    places.push_back(-a.dot(normal) / along.dot(normal));
  }
  std::sort(places.begin(), places.end());
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (!(places[i - 1] >= 0.0 && places[i] <= 1.0) || places[i] - places[i - 1] < 1e-12) continue;
    if (cell.contains(a + 0.5 * (places[i - 1] + places[i]) * along)) return true;
  }
  return false;
}

// The definition: every beam against every cell.
BetaGrid describe_naively(const LaserScan& scan, const Keypoint& keypoint,
                          const BetaGridParams& params) {
  const Pose2 grid_T_laser =
      Pose2(keypoint.position.x(), keypoint.position.y(), keypoint.orientation).inverse();
  const double width = (params.radius - params.min_radius) / params.rings;
  BetaGrid grid;
  for (int ring = 0; ring < params.rings; ++ring) {
    for (int sector = 0; sector < params.sectors; ++sector) {
      const Cell cell{params.min_radius + ring * width, params.min_radius + (ring + 1) * width,
                      kTwoPi * sector / params.sectors, kTwoPi * (sector + 1) / params.sectors};
      const double evidence =
          keypoint.position.norm() * scan.angle_increment / params.evidence_length;
      double a = 1.0;
      double b = 1.0;
      for (std::size_t i = 0; i < scan.size(); ++i) {
        if (!scan.valid(i)) continue;
        const Eigen::Vector2d point = grid_T_laser * scan.point(i);
        if (cell.contains(point)) {
          a += evidence;
        } else if (crosses(cell, grid_T_laser.translation(), point)) {
          b += evidence;
        }
      }
      grid.occupancy.push_back(static_cast<float>(a / (a + b)));
      grid.variance.push_back(static_cast<float>(a * b / ((a + b) * (a + b) * (a + b + 1.0))));
    }
  }
  return grid;
}

// In how many cells the grids tell something else. Where a beam touches a cell at its very corner
// rounding decides.
std::size_t differing_cells(const BetaGrid& a, const BetaGrid& b) {
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.occupancy.size(); ++i) {
    different += std::abs(a.occupancy[i] - b.occupancy[i]) > 1e-6F ||
                 std::abs(a.variance[i] - b.variance[i]) > 1e-6F;
  }
  return different;
}

class BetaGridExtraction : public ::testing::Test {
 protected:
  BetaGridExtraction() {
    auto random = test::seeded_random();
    scan_ = test::closed_scan(office_scene(), {-3.0, -1.0, 0.4}, 720, 0.01, random);
    keypoints_ = FalkoDetector().detect(scan_);
    const auto more = FlirtDetector().detect(scan_);
    keypoints_.insert(keypoints_.end(), more.begin(), more.end());
  }
  LaserScan scan_;
  std::vector<Keypoint> keypoints_;
};

TEST_F(BetaGridExtraction, FollowsTheDefinition) {
  ASSERT_GT(keypoints_.size(), 10U);
  std::vector<BetaGridParams> all(3);
  all[1].radius = 2.0;
  all[1].min_radius = 0.3;
  all[2].rings = 7;
  all[2].sectors = 5;
  for (const BetaGridParams& params : all) {
    const auto grids = BetaGridExtractor(params).extract(scan_, keypoints_);
    ASSERT_EQ(grids.size(), keypoints_.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < grids.size(); ++i) {
      different += differing_cells(grids[i], describe_naively(scan_, keypoints_[i], params));
    }
    EXPECT_LE(different, 1U);
  }
}

TEST_F(BetaGridExtraction, TurnsWithTheScan) {
  BetaGridExtractor extractor;
  const auto grids = extractor.extract(scan_, keypoints_);
  for (const std::size_t by : {1U, 250U, 719U}) {
    const LaserScan turned = with_beams_rotated(scan_, by);
    const double angle = static_cast<double>(by) * scan_.angle_increment;
    auto keypoints = keypoints_;
    for (Keypoint& keypoint : keypoints) {
      keypoint.position = Pose2(0.0, 0.0, -angle) * keypoint.position;
      keypoint.orientation = wrap_angle(keypoint.orientation - angle);
      keypoint.beam = (keypoint.beam + 720 - by) % 720;
    }
    const auto same = extractor.extract(turned, keypoints);
    std::size_t different = 0;
    for (std::size_t i = 0; i < grids.size(); ++i) different += differing_cells(grids[i], same[i]);
    EXPECT_LE(different, 1U) << by;
  }
}

TEST_F(BetaGridExtraction, DistanceIsZeroToItselfAndSymmetric) {
  const auto grids = BetaGridExtractor().extract(scan_, keypoints_);
  for (const BetaGrid& a : grids) {
    EXPECT_EQ(distance(a, a), 0.0);
    for (const BetaGrid& b : grids) {
      EXPECT_EQ(distance(a, b), distance(b, a));
      EXPECT_GE(distance(a, b), 0.0);
      EXPECT_LT(distance(a, b), 1.0);
    }
  }
}

TEST_F(BetaGridExtraction, InvalidBeamsTellNothing) {
  const auto valid = static_cast<std::size_t>(
      std::count(scan_.status.begin(), scan_.status.end(), BeamStatus::kValid));
  ASSERT_GT(valid, 0U);
  for (std::size_t i = 0; i < scan_.size(); ++i) {
    scan_.ranges[i] = test::kNoRange;
    scan_.status[i] = BeamStatus::kErroneous;
  }
  for (const BetaGrid& grid : BetaGridExtractor().extract(scan_, keypoints_)) {
    for (const float occupancy : grid.occupancy) EXPECT_EQ(occupancy, 0.5F);
    for (const float variance : grid.variance) EXPECT_EQ(variance, 1.0F / 12.0F);
  }
}

// One beam along the x axis to a keypoint at its end, which looks back to the laser: with one ring
// of four sectors the beam comes in through sector 0 and ends in the hole in the middle.
TEST(BetaGrid, OfOneBeam) {
  LaserScan scan = test::scan_of({2.0}, 0.001, 0.1);
  Keypoint keypoint;
  keypoint.position = scan.point(0);
  keypoint.orientation = wrap_angle(kPi - 0.1);
  BetaGridParams params;
  params.rings = 1;
  params.sectors = 4;
  params.evidence_length = 0.2;  // the distance of the beams at the keypoint
  BetaGridExtractor extractor(params);
  const BetaGrid before = extractor.extract(scan, {keypoint})[0];
  EXPECT_EQ(before.occupancy, (std::vector<float>{1.0F / 3.0F, 0.5F, 0.5F, 0.5F}));
  EXPECT_FLOAT_EQ(before.variance[0], 2.0F / (9.0F * 4.0F));
  // 0.2 m farther it leaves the hole again and ends behind it.
  scan.ranges[0] = 2.2;
  const BetaGrid behind = extractor.extract(scan, {keypoint})[0];
  EXPECT_EQ(behind.occupancy, (std::vector<float>{1.0F / 3.0F, 0.5F, 2.0F / 3.0F, 0.5F}));
}

// Twice as many beams see the same.
TEST_F(BetaGridExtraction, DoesNotDependOnTheResolution) {
  BetaGridExtractor extractor;
  auto keypoints = FlirtDetector().detect(scan_);
  const auto grids = extractor.extract(scan_, keypoints);
  for (Keypoint& keypoint : keypoints) keypoint.beam *= 2;
  const auto dense = extractor.extract(oversampled(scan_, 1), keypoints);
  for (std::size_t i = 0; i < grids.size(); ++i) {
    for (std::size_t j = 0; j < grids.size(); ++j) {
      if (i != j) {
        EXPECT_LT(distance(grids[i], dense[i]), distance(grids[i], dense[j])) << i << " " << j;
      }
    }
  }
}

TEST(BetaGrid, DistanceWeighsWhatIsWellKnown) {
  const BetaGrid a = {{0.8F, 0.5F}, {0.01F, 0.08F}};
  const BetaGrid b = {{0.2F, 0.5F}, {0.03F, 0.08F}};
  const double known = 1.0 / 0.04;
  const double unknown = 1.0 / 0.16;
  EXPECT_NEAR(distance(a, b), known * 0.36 / (known + unknown), 1e-6);
}

TEST(BetaGrid, GridsOfDifferentSizesAreNotCompared) {
  EXPECT_THROW(distance(BetaGrid{{0.5F}, {0.08F}}, BetaGrid{}), std::invalid_argument);
}

TEST(BetaGridParams, RefusesWhatIsOutOfRangeAndNamesIt) {
  const auto refuses = [](auto&& change, const std::string& text) {
    BetaGridParams params;
    change(params);
    try {
      BetaGridExtractor extractor(params);
      ADD_FAILURE() << text;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
  };
  refuses([](BetaGridParams& p) { p.radius = 0.01; }, "radius = 0.01");
  refuses([](BetaGridParams& p) { p.min_radius = 0.4; }, "min_radius = 0.4");
  refuses([](BetaGridParams& p) { p.min_radius = std::nan(""); }, "min_radius = nan");
  refuses([](BetaGridParams& p) { p.rings = 0; }, "rings = 0");
  refuses([](BetaGridParams& p) { p.sectors = 1; }, "sectors = 1");
  refuses([](BetaGridParams& p) { p.evidence_length = 0.0; }, "evidence_length = 0");
}

}  // namespace
}  // namespace falko_slam
