// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/recorded_calibration.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

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

// The same of walls: what of each covariance does not average out.
void add_lasting_noise(const std::vector<ScanMotion>& motions, CalibrationNoise& calibration) {
  double position = 0.0, turn = 0.0;  // mean variances
  for (const ScanMotion& motion : motions) {
    const Eigen::Matrix3d& lasting = motion.lasting_covariance;
    position += 0.5 * (lasting(0, 0) + lasting(1, 1)) / static_cast<double>(motions.size());
    turn += lasting(2, 2) / static_cast<double>(motions.size());
  }
  calibration.common_position = std::max(calibration.common_position, std::sqrt(position));
  calibration.common_turn = std::max(calibration.common_turn, std::sqrt(turn));
}

// A segment, and what its reflectors say with their ranges mended; empty if scans were used.
struct MendedSegment {
  PathSegment segment;
  std::optional<ReflectorMotion> reflectors;
};

MendedSegment mended(const RecordedSegment& recorded, double range_offset) {
  MendedSegment result{recorded.segment, std::nullopt};
  if (recorded.egomotion == EgomotionSource::kScans) return result;
  result.reflectors = with_range_offset(recorded.motion, range_offset);
  result.segment.start_T_end = result.reflectors->start_T_end;
  result.segment.turn = result.reflectors->turn;
  return result;
}

// Neighbours share what reflectors look displaced by at the halt between them.
std::vector<PathSegment> connected(const std::vector<MendedSegment>& mended,
                                   const std::vector<std::size_t>& numbers, double lasting_noise) {
  std::vector<PathSegment> segments;
  for (std::size_t i = 0; i < mended.size(); ++i) {
    segments.push_back(mended[i].segment);
    const bool neighbours = i + 1 < mended.size() && numbers[i] + 1 == numbers[i + 1];
    if (!neighbours || !mended[i].reflectors || !mended[i + 1].reflectors) continue;
    segments.back().covariance_with_next =
        covariance_at_halt(*mended[i].reflectors, *mended[i + 1].reflectors, lasting_noise);
  }
  return segments;
}

// Arcs would be no remedy where none of those that were driven can be used.
void say_that_none_counts(const std::vector<RecordedSegment>& recorded, CalibrationResult& result) {
  result.remarks = {
      {CalibrationVerdict::kUnobservable,
       {},
       "none of " + std::to_string(recorded.size()) +
           " segments can be used, the first one because of this: " + recorded.front().complaint,
       "check what is believed of the laser's place, wheelbase and driving scale, in m and rad"}};
}

}  // namespace

RecordedCalibration calibrate_recorded(const std::vector<RecordedSegment>& recorded,
                                       const CalibratorParams& params, double lasting_noise) {
  RecordedCalibration calibration;
  std::vector<ReflectorMotion> motions;
  std::vector<ScanMotion> scan_motions;
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    if (!recorded[i].complaint.empty()) continue;
    calibration.recorded.push_back(i);
    if (recorded[i].egomotion == EgomotionSource::kScans) {
      scan_motions.push_back(recorded[i].scan_motion);
    } else {
      motions.push_back(recorded[i].motion);
    }
  }
  calibration.range_offset = estimate_range_offset(motions);
  std::vector<MendedSegment> segments;
  for (const std::size_t i : calibration.recorded) {
    segments.push_back(mended(recorded[i], calibration.range_offset.offset));
  }
  CalibratorParams with_lasting = params;
  if (!motions.empty()) add_lasting_noise(motions, lasting_noise, with_lasting.noise);
  if (!scan_motions.empty()) add_lasting_noise(scan_motions, with_lasting.noise);
  calibration.result =
      calibrate(connected(segments, calibration.recorded, lasting_noise), with_lasting);
  if (calibration.recorded.empty() && !recorded.empty()) {
    say_that_none_counts(recorded, calibration.result);
  }
  return calibration;
}

}  // namespace falko_slam
