// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What must hold for any scan, on a real recording: fr079.log.gz of the FLIRT evaluation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "falko_slam/evaluation/posed_scan.hpp"
#include "falko_slam/features/falko.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

std::string recording() {
  const char* folder = std::getenv("FALKO_SLAM_DATA");
  return std::string(folder ? folder : FALKO_SLAM_SOURCE_DIR "/../shared/data") +
         "/benchmark/fr079.log.gz";
}

bool same_keypoint(const Keypoint& a, const Keypoint& b) {
  return a.beam == b.beam && a.position == b.position && a.orientation == b.orientation &&
         a.score == b.score && a.roughness == b.roughness;
}

class RecordedScans : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::ifstream(recording())) {
      GTEST_SKIP() << recording() << " is not there: set FALKO_SLAM_DATA to the folder that holds "
                   << "benchmark/fr079.log.gz";
    }
    scans_ = load_posed_scans(recording(), report_);
  }

  std::vector<PosedScan> scans_;
  CarmenReport report_;
};

TEST_F(RecordedScans, AreAllRead) {
  EXPECT_EQ(scans_.size(), 1464U);
  EXPECT_EQ(report_.vertices, 1464U);
  EXPECT_TRUE(report_.malformed_lines.empty());
}

TEST_F(RecordedScans, KeypointsLieAtTheirBeams) {
  FalkoDetector detector;
  const FalkoParams& params = detector.params();
  std::size_t count = 0;
  for (const auto& [scan, pose] : scans_) {
    for (const Keypoint& keypoint : detector.detect(scan)) {
      ++count;
      ASSERT_LT(keypoint.beam, scan.size());
      EXPECT_TRUE(scan.valid(keypoint.beam));
      EXPECT_GE(keypoint.radius, params.neighborhood.radius_scale);
      EXPECT_LE(keypoint.radius, params.neighborhood.max_radius);
      EXPECT_GE(keypoint.orientation, -kPi);
      EXPECT_LT(keypoint.orientation, kPi);
      EXPECT_TRUE(std::isfinite(keypoint.score) && std::isfinite(keypoint.roughness));
      EXPECT_LE(keypoint.position.norm(), scan.range_max + params.refinement_limit);
    }
  }
  EXPECT_GT(count, scans_.size());
}

// A candidate sees the points within its radius, and through their smoothing up to 50 beams more.
TEST_F(RecordedScans, LostBeamsChangeNothingFarFromThem) {
  constexpr std::size_t kSmoothed = 50;
  constexpr std::size_t kLost = 5;
  FalkoParams params;
  params.suppression_radius = 0.0;  // suppression reaches on from one candidate to the next
  params.merge_radius = 0.0;
  FalkoDetector detector(params);
  std::size_t compared = 0;
  for (std::size_t n = 0; n < scans_.size(); n += 20) {
    const LaserScan& scan = scans_[n].scan;
    const std::size_t first_lost = n % (scan.size() - kLost);
    LaserScan changed = scan;
    for (std::size_t i = first_lost; i < first_lost + kLost; ++i) {
      changed.ranges[i] = std::nan("");
      changed.status[i] = BeamStatus::kErroneous;
    }
    const auto found = detector.detect(changed);
    for (const Keypoint& keypoint : detector.detect(scan)) {
      std::size_t first = keypoint.beam;
      std::size_t last = keypoint.beam;
      for (std::size_t i = 0; i < scan.size(); ++i) {
        const double apart = (scan.point(i) - scan.point(keypoint.beam)).norm();
        if (!(apart <= 1.1 * keypoint.radius)) continue;
        first = std::min(first, i);
        last = std::max(last, i);
      }
      if (first < first_lost + kLost + kSmoothed && first_lost < last + 1 + kSmoothed) continue;
      ++compared;
      EXPECT_TRUE(
          std::any_of(found.begin(), found.end(),
                      [&](const Keypoint& other) { return same_keypoint(keypoint, other); }))
          << "scan " << n << ", beam " << keypoint.beam;
    }
  }
  EXPECT_GT(compared, 100U);
}

}  // namespace
}  // namespace falko_slam
