// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/features/flirt.hpp"

#include <algorithm>
#include <cmath>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/geometry/pose2.hpp"
#include "flirt_response.hpp"
#include "non_maximum_suppression.hpp"
#include "scan_trace.hpp"

namespace falko_slam {
namespace {

CornerCandidate candidate_of(const FlirtPeak& peak, const ScanTrace& trace) {
  CornerCandidate candidate;
  candidate.position = {peak.x, peak.y};
  candidate.axis = {peak.axis_x, peak.axis_y};
  candidate.rank = static_cast<float>(1.0 / peak.response);
  candidate.roughness_square = 0.0;  // nothing is merged
  candidate.range = trace.range[peak.point];
  candidate.slope = peak.axis_y * peak.x - peak.axis_x * peak.y;
  candidate.beam = peak.point;
  return candidate;
}

}  // namespace

struct FlirtDetector::Workspace {
  explicit Workspace(const FlirtParams& params) : curvature(params), range(params) {}

  ScanTrace trace;
  CurvatureResponse curvature;
  RangeResponse range;
  std::vector<FlirtPeak> peaks;
  std::vector<CornerCandidate> candidates;
  NonMaximumSuppression suppression;
};

FlirtDetector::FlirtDetector(const FlirtParams& params) : params_(params) {
  validate(params_);
  workspace_ = std::make_unique<Workspace>(params_);
}
FlirtDetector::~FlirtDetector() = default;
FlirtDetector::FlirtDetector(FlirtDetector&&) noexcept = default;
FlirtDetector& FlirtDetector::operator=(FlirtDetector&&) noexcept = default;

void FlirtDetector::detect(const LaserScan& scan, std::vector<Keypoint>& keypoints) {
  keypoints.clear();
  if (scan.size() < 2 || !(scan.angle_increment > 0.0)) return;
  Workspace& work = *workspace_;
  work.trace.assign(scan, params_.max_gap);
  work.peaks.clear();
  for (const ScanTrace::Piece& piece : work.trace.pieces()) {
    if (params_.signal == FlirtParams::Signal::kCurvature) {
      work.curvature.find_peaks(work.trace, piece, work.peaks);
    } else {
      work.range.find_peaks(work.trace, piece, scan.angle_increment, work.peaks);
    }
  }
  work.candidates.clear();
  for (const FlirtPeak& peak : work.peaks) {
    work.candidates.push_back(candidate_of(peak, work.trace));
  }
  const Pose2 laser_T_trace(0.0, 0.0, work.trace.start_bearing());
  for (const KeptCorner& kept :
       work.suppression(work.candidates, params_.suppression_radius, 0.0)) {
    const FlirtPeak& peak = work.peaks[kept.index];
    Keypoint keypoint;
    keypoint.position = laser_T_trace * kept.position;
    keypoint.orientation =
        wrap_angle(std::atan2(peak.axis_y, peak.axis_x) + work.trace.start_bearing());
    keypoint.radius = peak.radius;
    keypoint.score = 1.0 / peak.response;
    keypoint.beam = work.trace.beam[peak.point];
    keypoints.push_back(keypoint);
  }
  std::sort(keypoints.begin(), keypoints.end(),
            [](const Keypoint& a, const Keypoint& b) { return a.beam < b.beam; });
}

std::vector<Keypoint> FlirtDetector::detect(const LaserScan& scan) {
  std::vector<Keypoint> keypoints;
  detect(scan, keypoints);
  return keypoints;
}

FlirtParams flirt_range_params() {
  FlirtParams params;
  params.signal = FlirtParams::Signal::kRange;
  params.scales = 3;
  params.base_sigma = 0.006;
  params.min_peak = 0.05;
  params.max_gap = 1000.0;
  return params;
}

void validate(const FlirtParams& params) {
  const bool contour = params.signal == FlirtParams::Signal::kCurvature;
  require_in_range("scales", params.scales, 1, 16);
  require_in_range("base_sigma", params.base_sigma, contour ? 0.01 : 1e-4, contour ? 10.0 : 1.0);
  require_in_range("sigma_step", params.sigma_step, 1.01, 4.0);
  require_in_range("min_peak", params.min_peak, 0.0, 100.0);
  require_in_range("min_difference", params.min_difference, 0.0, 100.0);
  require_in_range("noise_window", params.noise_window, 0.0, 10.0);
  require_in_range("max_gap", params.max_gap, 0.01, 1000.0);
  require_in_range("suppression_radius", params.suppression_radius, 0.0, 10.0);
}

}  // namespace falko_slam
