// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "flirt_response.hpp"

#include <algorithm>
#include <cmath>

namespace falko_slam {
namespace {

// The response at the end of a straight surface, of which the Gaussian sees one half:
// 2 sqrt(2 / pi).
constexpr double kEdgeResponse = 1.5957691216057308;
// Surfaces shorter than this have no ends worth telling, and no shape [m].
constexpr double kShortestSurface = 0.1;
// A surface looks into the direction from its end to the second point after it.
constexpr std::size_t kEdgePoints = 2;
constexpr std::size_t kFewestPoints = 5;
// So near to an end the windows hold too few points to tell a bend from noise.
constexpr std::size_t kUnsurePoints = 2;
// Points within this distance on the same surface have a say in its normal [m].
constexpr double kNormalRadius = 0.3;

std::ptrdiff_t offset(std::size_t index) { return static_cast<std::ptrdiff_t>(index); }

void smooth(BoxSmoothing& smoothing, std::vector<double>& values) {
  for (int pass = 0; pass < 3; ++pass) smoothing(values.data());
}

// Calls visit(i) for the peaks among the own points of the piece; i counts from its beginning.
template <class Visit>
void for_each_peak(const std::vector<double>& response, const ScanTrace::Piece& piece,
                   const FlirtParams& params, Visit&& visit) {
  const std::size_t end = std::min(response.size() - kUnsurePoints, piece.last - piece.begin);
  for (std::size_t i = std::max(kUnsurePoints, piece.first - piece.begin); i < end; ++i) {
    if (response[i] > params.min_peak && response[i] - response[i - 1] > params.min_difference &&
        response[i] - response[i + 1] > params.min_difference) {
      visit(i);
    }
  }
}

// Sums of the points about one of them.
struct Scatter {
  double count = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;

  void add(double dx, double dy) {
    count += 1.0;
    x += dx;
    y += dy;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
  }
  // Direction of the greatest spread.
  double direction() const {
    const double covariance = xy - x * y / count;
    const double difference = (xx - x * x / count) - (yy - y * y / count);
    return 0.5 * std::atan2(2.0 * covariance, difference);
  }
};

// Normal of the surface at a point of the trace, towards the laser.
Eigen::Vector2d normal_at(const ScanTrace& trace, const ScanTrace::Piece& piece,
                          std::size_t point) {
  Scatter scatter;
  scatter.add(0.0, 0.0);
  const auto add = [&](std::size_t i, std::size_t before) {
    const double dx = trace.x[i] - trace.x[point];
    const double dy = trace.y[i] - trace.y[point];
    const double step = std::hypot(trace.x[i] - trace.x[before], trace.y[i] - trace.y[before]);
    const bool near = dx * dx + dy * dy < kNormalRadius * kNormalRadius && step < kNormalRadius;
    if (near) scatter.add(dx, dy);
    return near;
  };
  for (std::size_t i = point; i > piece.begin && add(i - 1, i);) --i;
  for (std::size_t i = point; i + 1 < piece.end && add(i + 1, i);) ++i;
  Eigen::Vector2d to_laser(-trace.x[point], -trace.y[point]);
  if (scatter.count < 3.0) return to_laser;
  const double direction = scatter.direction();
  const Eigen::Vector2d normal(-std::sin(direction), std::cos(direction));
  return normal.dot(to_laser) < 0.0 ? Eigen::Vector2d(-normal) : normal;
}

// Of the points within `reach` of point i of the piece that at which the ranges bend most.
std::size_t sharpest_bend(const ScanTrace& trace, const ScanTrace::Piece& piece, std::size_t i,
                          double reach) {
  const auto bend = [&](std::size_t k) {
    return trace.range[k - 1] - 2.0 * trace.range[k] + trace.range[k + 1];
  };
  std::size_t best = i;
  const auto consider = [&](std::size_t k) {
    if (std::abs(trace.bearing[k] - trace.bearing[i]) > reach) return false;
    if (bend(k) > bend(best)) best = k;
    return true;
  };
  for (std::size_t k = i; k > piece.begin + 1 && consider(k - 1);) --k;
  for (std::size_t k = i; k + 2 < piece.end && consider(k + 1);) ++k;
  return best;
}

}  // namespace

// The contour averaged against noise, and the length along it. The window is measured across the
// beams, where noise does not lengthen it.
void CurvatureResponse::take_contour(const ScanTrace& trace, const ScanTrace::Piece& piece) {
  const std::size_t points = piece.end - piece.begin;
  x_.assign(trace.x.begin() + offset(piece.begin), trace.x.begin() + offset(piece.end));
  y_.assign(trace.y.begin() + offset(piece.begin), trace.y.begin() + offset(piece.end));
  length_.assign(points, 0.0);
  if (params_.noise_window > 0.0) {
    for (std::size_t i = 1; i < points; ++i) {
      const std::size_t k = piece.begin + i;
      length_[i] = length_[i - 1] + 0.5 * (trace.bearing[k] - trace.bearing[k - 1]) *
                                        (trace.range[k] + trace.range[k - 1]);
    }
    smoothing_.assign(length_.data(), length_.data() + points, params_.noise_window);
    smoothing_(x_.data());
    smoothing_(y_.data());
  }
  for (std::size_t i = 1; i < points; ++i) {
    length_[i] = length_[i - 1] + std::hypot(x_[i] - x_[i - 1], y_[i] - y_[i - 1]);
  }
}

void CurvatureResponse::find_edges(const ScanTrace& trace, const ScanTrace::Piece& piece,
                                   std::vector<FlirtPeak>& peaks) const {
  const std::size_t last = length_.size() - 1;
  const auto examine = [&](std::size_t end, std::size_t inwards,
                           const ScanTrace::Neighbor& beyond) {
    const std::size_t point = piece.begin + end;
    if (!(beyond.range > trace.range[point])) return;
    peaks.push_back({point, x_[end], y_[end], x_[inwards] - x_[end], y_[inwards] - y_[end],
                     kEdgeResponse, 2.0 * params_.base_sigma});
  };
  if (piece.before.exists) examine(0, kEdgePoints, piece.before);
  if (piece.after.exists) examine(last, last - kEdgePoints, piece.after);
}

void CurvatureResponse::respond(double sigma) {
  smooth_x_ = x_;
  smooth_y_ = y_;
  smoothing_.assign(length_.data(), length_.data() + length_.size(), sigma);
  smooth(smoothing_, smooth_x_);
  smooth(smoothing_, smooth_y_);
  response_.resize(x_.size());
  for (std::size_t i = 0; i < x_.size(); ++i) {
    const double dx = smooth_x_[i] - x_[i];
    const double dy = smooth_y_[i] - y_[i];
    response_[i] = 2.0 / sigma * std::sqrt(dx * dx + dy * dy);
  }
}

void CurvatureResponse::find_peaks(const ScanTrace& trace, const ScanTrace::Piece& piece,
                                   std::vector<FlirtPeak>& peaks) {
  if (piece.last - piece.first < kFewestPoints) return;
  take_contour(trace, piece);
  if (length_.back() < kShortestSurface) return;
  if (params_.edges) find_edges(trace, piece, peaks);
  double sigma = params_.base_sigma;
  for (int scale = 0; scale < params_.scales; ++scale) {
    respond(sigma);
    for_each_peak(response_, piece, params_, [&](std::size_t i) {
      peaks.push_back({piece.begin + i, x_[i], y_[i], smooth_x_[i] - x_[i], smooth_y_[i] - y_[i],
                       response_[i], 2.0 * sigma});
    });
    sigma *= params_.sigma_step;
  }
}

// A further window of half-width sigma adds sigma^2 / 6 of the second derivative.
void RangeResponse::respond(const ScanTrace& trace, const ScanTrace::Piece& piece, double sigma) {
  smooth_.assign(trace.range.begin() + offset(piece.begin),
                 trace.range.begin() + offset(piece.end));
  smoothing_.assign(trace.bearing.data() + piece.begin, trace.bearing.data() + piece.end, sigma);
  smooth(smoothing_, smooth_);
  response_ = smooth_;
  smoothing_(response_.data());
  for (std::size_t i = 0; i < smooth_.size(); ++i) response_[i] = 6.0 * (response_[i] - smooth_[i]);
}

void RangeResponse::find_peaks(const ScanTrace& trace, const ScanTrace::Piece& piece,
                               double angle_increment, std::vector<FlirtPeak>& peaks) {
  if (piece.last - piece.first < kFewestPoints) return;
  double nominal = params_.base_sigma;
  for (int scale = 0; scale < params_.scales; ++scale) {
    const double sigma = std::max(nominal, angle_increment);
    respond(trace, piece, sigma);
    const double reach = sigma + 1e-6 * angle_increment;
    for_each_peak(response_, piece, params_, [&](std::size_t i) {
      const std::size_t point = sharpest_bend(trace, piece, piece.begin + i, reach);
      const Eigen::Vector2d normal = normal_at(trace, piece, point);
      const double radius = std::max(params_.suppression_radius, 2.0 * sigma * trace.range[point]);
      peaks.push_back(
          {point, trace.x[point], trace.y[point], normal.x(), normal.y(), response_[i], radius});
    });
    nominal *= params_.sigma_step;
  }
}

}  // namespace falko_slam
