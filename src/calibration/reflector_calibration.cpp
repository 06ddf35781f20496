// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/reflector_calibration.hpp"

#include <algorithm>
#include <cmath>

#include "shared_halt.hpp"

namespace falko_slam {
namespace {

// What reflectors that look displaced by `noise` at both ends do to the motion between: of n of
// them, `spread` from their middle (root mean square), it displaces by sqrt(2 / n) of it and turns
// by the same over the spread.
void add_lasting_noise(const std::vector<ReflectorMotion>& motions, double noise,
                       CalibrationNoise& calibration) {
  double position = 0.0, turn = 0.0;  // mean variances
  for (const ReflectorMotion& motion : motions) {
    const auto count = static_cast<double>(motion.pairs.size());
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const PointPair& pair : motion.pairs) middle += pair.point_in_target / count;
    double spread2 = 0.0;
    for (const PointPair& pair : motion.pairs) {
      spread2 += (pair.point_in_target - middle).squaredNorm() / count;
    }
    const double variance = 2.0 * noise * noise / count;
    position += variance / static_cast<double>(motions.size());
    turn += variance / std::max(1e-6, spread2) / static_cast<double>(motions.size());
  }
  calibration.common_position = std::max(calibration.common_position, std::sqrt(position));
  calibration.common_turn = std::max(calibration.common_turn, std::sqrt(turn));
}

}  // namespace

ReflectorCalibration calibrate_recorded(const std::vector<RecordedSegment>& recorded,
                                        const CalibratorParams& params, double lasting_noise) {
  ReflectorCalibration calibration;
  std::vector<ReflectorMotion> motions;
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    if (!recorded[i].complaint.empty()) continue;
    calibration.recorded.push_back(i);
    motions.push_back(recorded[i].motion);
  }
  calibration.range_offset = estimate_range_offset(motions);
  std::vector<PathSegment> segments;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    motions[i] = with_range_offset(motions[i], calibration.range_offset.offset);
    PathSegment segment = recorded[calibration.recorded[i]].segment;
    segment.start_T_end = motions[i].start_T_end;
    segment.turn = motions[i].turn;
    segments.push_back(segment);
  }
  for (std::size_t i = 0; i + 1 < segments.size(); ++i) {
    if (calibration.recorded[i] + 1 != calibration.recorded[i + 1]) continue;
    segments[i].covariance_with_next =
        covariance_at_halt(motions[i], motions[i + 1], lasting_noise);
  }
  CalibratorParams with_reflectors = params;
  add_lasting_noise(motions, lasting_noise, with_reflectors.noise);
  calibration.result = calibrate(segments, with_reflectors);
  return calibration;
}

}  // namespace falko_slam
