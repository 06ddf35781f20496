// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "sampled_scan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "falko_slam/geometry/angles.hpp"
#include "simd_lanes.hpp"

namespace falko_slam {
namespace {

// More beams are not averaged on either side: a hundred of them take the noise away well enough.
constexpr double kMaxHalfWindow = 50.0;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

// Resolution of the table over the range [m]: the radius is taken at the middle of the bin and is
// right to 0.04 % with the default growth.
constexpr double kBinSize = 0.01;
constexpr std::size_t kMaxBins = 20000;  // farther beams are treated as if they were at 200 m

// Neighbouring beams whose ranges differ by more than this share of the radius are not of one
// surface and are not averaged.
constexpr float kMaxJump = 0.5F;

std::ptrdiff_t as_offset(std::size_t index) { return static_cast<std::ptrdiff_t>(index); }

}  // namespace

SampledScan::SampledScan(const NeighborhoodParams& params) : params_(params) {}

void SampledScan::assign(const LaserScan& scan) {
  build_tables(scan);
  look_up_ranges(scan);
  make_blocks();
  raw_.resize(scan.size() + 2 * margin_);
  std::transform(scan.ranges.begin(), scan.ranges.end(), raw_.begin() + as_offset(margin_),
                 [](double range) { return static_cast<float>(range); });
  fill_margins(raw_);
  smooth_ = raw_;
  if (params_.smoothing_window > 0.0) average_ranges();
}

void SampledScan::build_tables(const LaserScan& scan) {
  directions_.assign(scan);
  if (scan.angle_increment == angle_increment_ && scan.closed == closed_ &&
      scan.size() == cosine_.size()) {
    return;
  }
  angle_increment_ = scan.angle_increment;
  closed_ = scan.closed;
  cosine_.clear();
  sine_.clear();
  for (std::size_t lag = 0; lag < scan.size(); ++lag) {
    const double angle = static_cast<double>(lag) * angle_increment_;
    cosine_.push_back(static_cast<float>(std::cos(angle)));
    sine_.push_back(static_cast<float>(std::sin(angle)));
  }
  bins_.assign(kMaxBins, RangeBin{});  // filled when first asked for
}

SampledScan::RangeBin SampledScan::range_bin(double range) const {
  // On a closed scan the two sides must not meet behind the sensor.
  const std::size_t max_lag = closed_ ? (cosine_.size() - 1) / 2 : cosine_.size() - 1;
  const auto beams = [&](double count) {
    return static_cast<std::int32_t>(std::min(count, static_cast<double>(max_lag)));
  };
  const double middle = range + 0.5 * kBinSize;
  const double radius =
      std::min(params_.max_radius, params_.radius_scale * std::exp(params_.radius_growth * middle));
  const double beams_in_radius = radius / (middle * angle_increment_);
  // Seen from the sensor, points within the radius lie within this angle. The near edge of the bin
  // gives the greatest one; the share on top covers rounding.
  const double angle = radius < range ? 1.001 * std::asin(radius / range) : kPi;
  RangeBin bin{};
  bin.radius_square = static_cast<float>(radius * radius);
  bin.stride = std::max(1, beams(params_.sample_spacing * beams_in_radius + 0.5));
  bin.steps = beams(angle / angle_increment_) / bin.stride;
  bin.half_window =
      beams(std::min(kMaxHalfWindow, 0.5 * params_.smoothing_window * beams_in_radius));
  return bin;
}

void SampledScan::look_up_ranges(const LaserScan& scan) {
  bin_.resize(scan.size());
  constexpr auto kLast = static_cast<double>(kMaxBins - 1);
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const double position = scan.ranges[i] * (1.0 / kBinSize);
    bin_[i] = static_cast<std::int32_t>(position < kLast ? position : kLast);  // also for NaN
    RangeBin& bin = bins_[static_cast<std::size_t>(bin_[i])];
    if (bin.stride == 0) bin = range_bin(kBinSize * bin_[i]);
  }
}

void SampledScan::make_blocks() {
  radius_square_.resize(size() + kLanes);
  blocks_.clear();
  BeamBlock block{0, 0, bin(0).stride, 0};
  std::int32_t reach = 0;
  const auto finish = [&] {
    blocks_.push_back(block);
    reach = std::max(reach, block.stride * std::max(1, block.steps));
  };
  for (std::size_t i = 0; i < size(); ++i) {
    const RangeBin& now = bin(i);
    radius_square_[i] = now.radius_square;
    reach = std::max(reach, now.half_window);
    if (now.stride != block.stride || block.count == kLanes) {
      finish();
      block = {i, 0, now.stride, 0};
    }
    ++block.count;
    block.steps = std::max(block.steps, now.steps);
  }
  finish();
  // A block of fewer than kLanes beams reads on behind its last one.
  margin_ = static_cast<std::size_t>(reach) + kLanes;
}

void SampledScan::fill_margins(std::vector<float>& ranges) const {
  const std::size_t beams = size();
  for (std::size_t i = 0; i < margin_; ++i) {
    ranges[margin_ + beams + i] = closed_ ? ranges[margin_ + i % beams] : kNaN;
    ranges[margin_ - 1 - i] = closed_ ? ranges[margin_ + beams - 1 - i % beams] : kNaN;
  }
}

// The mean over a window that grows on both sides alike, until the surface ends on either.
void SampledScan::average_ranges() {
  for (std::size_t i = 0; i < size(); ++i) {
    const std::int32_t half = bin(i).half_window;
    if (half == 0) continue;
    const float* center = raw_.data() + margin_ + i;
    const float max_jump = kMaxJump * std::sqrt(radius_square_[i]);
    double sum = *center;
    int count = 1;
    for (std::ptrdiff_t k = 1; k <= half; ++k) {
      const bool same_surface = std::abs(center[k] - center[k - 1]) <= max_jump &&
                                std::abs(center[-k] - center[1 - k]) <= max_jump;
      if (!same_surface) break;
      sum += static_cast<double>(center[k]) + static_cast<double>(center[-k]);
      count += 2;
    }
    if (count > 1) smooth_[margin_ + i] = static_cast<float>(sum / count);
  }
  fill_margins(smooth_);
}

}  // namespace falko_slam
