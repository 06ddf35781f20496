// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/features/face_detector.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/sensor/unrolled_scan.hpp"
#include "line_break.hpp"

namespace falko_slam {
namespace {

constexpr double kBeyondNoise = 3.5;     // deviations of a beam
constexpr double kBeyondStraight = 2.0;  // and of a face's shape
constexpr double kSure = 25.0;           // fall of chi-square that chance does not explain
constexpr double kMostGrazing = 0.05;    // sine of the angle between beam and face

class FaceSplitter {
 public:
  FaceSplitter(const UnrolledScan& scan, const FaceDetectorParams& params)
      : scan_(scan), params_(params) {}

  std::vector<DetectedFace> run() {
    scan_.for_each_surface([this](std::size_t first, std::size_t last) { split(first, last); });
    return std::move(faces_);
  }

 private:
  double variance_across(std::size_t k, const Eigen::Vector2d& normal) const {
    const Eigen::Vector2d sight = scan_.point(k) / scan_.range(k);
    const double along = params_.range_noise * normal.dot(sight);
    const double turned =
        params_.bearing_noise * scan_.range(k) * (normal.y() * sight.x() - normal.x() * sight.y());
    return along * along + turned * turned + 1e-10;
  }

  Line2 fitted(std::size_t first, std::size_t last, Eigen::Vector2d normal) const {
    Line2 line;
    for (int round = 0; round < 2; ++round) {
      LineMoments moments;
      const Eigen::Vector2d origin = scan_.point(first);
      for (std::size_t k = first; k <= last; ++k) {
        const Eigen::Vector2d point = scan_.point(k) - origin;
        moments.add(point.x(), point.y(), 1.0 / variance_across(k, normal));
      }
      line = moments.fit().line;
      line.offset += line.normal.dot(origin);
      normal = line.normal;
    }
    return line.offset < 0.0 ? Line2{-line.normal, -line.offset} : line;
  }

  bool is_straight(std::size_t first, std::size_t last, const Line2& line) const {
    for (std::size_t k = first; k <= last; ++k) {
      const double allowed = kBeyondStraight * params_.straightness +
                             kBeyondNoise * std::sqrt(variance_across(k, line.normal));
      if (std::abs(line.signed_distance(scan_.point(k))) > allowed) return false;
    }
    return true;
  }

  LineBreak best_break(std::size_t first, std::size_t last, const Line2& line) const {
    const Eigen::Vector2d along(-line.normal.y(), line.normal.x());
    LineBreakSearch search;
    for (std::size_t k = first; k <= last; ++k) {
      const Eigen::Vector2d point = scan_.point(k) - scan_.point(first);
      search.add(along.dot(point), line.normal.dot(point), 1.0 / variance_across(k, line.normal));
    }
    return search.best();
  }

  bool is_one(const LineBreak& best) const {
    return best.gain < kSure || best.gain < best.weight * std::pow(params_.straightness, 2);
  }

  void split(std::size_t first, std::size_t last) {
    const auto end = static_cast<std::size_t>(params_.end_beams);
    if (last + 1 - first < static_cast<std::size_t>(params_.min_beams) + 2 * end) return;
    const Eigen::Vector2d chord = scan_.point(last) - scan_.point(first);
    const Eigen::Vector2d across = Eigen::Vector2d(-chord.y(), chord.x()).stableNormalized();
    const Line2 line = fitted(first, last, across);
    if (is_straight(first + end, last - end, line)) {
      const LineBreak found = best_break(first + end, last - end, line);
      if (is_one(found)) return add(first + end, last - end);
      split(first, first + end + found.second - 1);
      return split(first + end + found.second, last);
    }
    double farthest = 0.0;
    std::size_t corner = first;
    for (std::size_t k = first + 1; k < last; ++k) {
      const double distance = std::abs(across.dot(scan_.point(k) - scan_.point(first))) /
                              std::sqrt(variance_across(k, across));
      if (distance <= farthest) continue;
      farthest = distance;
      corner = k;
    }
    if (corner == first) return;
    split(first, corner);
    split(corner, last);
  }

  // Half of the way to the beams on either side.
  double stretch_of(std::size_t k, std::size_t first, std::size_t last) const {
    const std::size_t before = std::max(k, first + 1) - 1, after = std::min(k + 1, last);
    return 0.5 * (scan_.point(after) - scan_.point(before)).norm();
  }

  // Every stretch of the face counts alike, however many beams it got: bent as faces are, the part
  // next to the laser would else lead, another one from every place. Least squares in (turn about
  // the middle, shift across) with these weights; its covariance from the noise of the beams, and
  // what the face's own shape adds to all of them in common.
  void add(std::size_t first, std::size_t last) {
    LineMoments moments;
    const Eigen::Vector2d origin = scan_.point(first);
    for (std::size_t k = first; k <= last; ++k) {
      const Eigen::Vector2d point = scan_.point(k) - origin;
      moments.add(point.x(), point.y(), stretch_of(k, first, last));
    }
    Line2 line = moments.fit().line;
    line.offset += line.normal.dot(origin);
    if (line.offset < 0.0) line = {-line.normal, -line.offset};
    const Eigen::Vector2d along(-line.normal.y(), line.normal.x());
    const double from = along.dot(scan_.point(first)), to = along.dot(scan_.point(last));
    const double middle = 0.5 * (from + to), length = std::abs(to - from);
    if (length < params_.min_length || std::abs(line.offset) < 1e-3) return;
    const Eigen::Vector2d sight = scan_.point((first + last) / 2).normalized();
    if (std::abs(sight.dot(line.normal)) < kMostGrazing) return;
    Eigen::Matrix2d normal_matrix = Eigen::Matrix2d::Zero(), noise = Eigen::Matrix2d::Zero();
    for (std::size_t k = first; k <= last; ++k) {
      const Eigen::Vector2d slope(along.dot(scan_.point(k)) - middle, 1.0);
      const double weight = stretch_of(k, first, last);
      normal_matrix += weight * slope * slope.transpose();
      noise += weight * weight * variance_across(k, line.normal) * slope * slope.transpose();
    }
    const Eigen::Matrix2d inverse = normal_matrix.inverse();
    DetectedFace face;
    face.line = line;
    face.covariance = inverse * noise * inverse;
    face.covariance(0, 0) += std::pow(2.0 * params_.straightness / length, 2);
    face.covariance(1, 1) += std::pow(params_.straightness, 2);
    face.middle = line.offset * line.normal + middle * along;
    face.half_length = 0.5 * length;
    face.first_beam = scan_.beam_of(first);
    face.last_beam = scan_.beam_of(last);
    faces_.push_back(face);
  }

  const UnrolledScan& scan_;
  const FaceDetectorParams& params_;
  std::vector<DetectedFace> faces_;
};

}  // namespace

void validate(const FaceDetectorParams& params) {
  require_in_range("max_range", params.max_range, 0.1, 1e5);
  require_in_range("range_noise", params.range_noise, 1e-4, 1.0);
  require_in_range("bearing_noise", params.bearing_noise, 0.0, 0.1);
  require_in_range("straightness", params.straightness, 1e-4, 0.1);
  require_in_range("end_beams", params.end_beams, 0, 100);
  require_in_range("min_beams", params.min_beams, 3, 1000);
  require_in_range("min_length", params.min_length, 0.01, 100.0);
  validate(params.surface);
}

std::vector<DetectedFace> detect_faces(const LaserScan& scan, const FaceDetectorParams& params) {
  if (scan.size() == 0 || !(scan.angle_increment > 0.0)) return {};
  const UnrolledScan unrolled(scan, params.max_range, params.surface);
  return FaceSplitter(unrolled, params).run();
}

}  // namespace falko_slam
