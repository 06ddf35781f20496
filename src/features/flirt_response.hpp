// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "box_smoothing.hpp"
#include "falko_slam/features/flirt.hpp"
#include "scan_trace.hpp"

namespace falko_slam {

/// A maximum of the response over the points of a piece, at one scale.
struct FlirtPeak {
  std::size_t point;  ///< of the trace
  double x, y;        ///< in the frame of the trace [m]
  double axis_x, axis_y;
  double response;
  double radius;  ///< [m]
};

/// The response of FLIRT to the contour; see FlirtDetector.
class CurvatureResponse {
 public:
  explicit CurvatureResponse(const FlirtParams& params) : params_(params) {}

  /// Appends the peaks of the piece at all scales.
  void find_peaks(const ScanTrace& trace, const ScanTrace::Piece& piece,
                  std::vector<FlirtPeak>& peaks);

 private:
  void take_contour(const ScanTrace& trace, const ScanTrace::Piece& piece);
  void find_edges(const ScanTrace& trace, const ScanTrace::Piece& piece,
                  std::vector<FlirtPeak>& peaks) const;
  void respond(double sigma);

  FlirtParams params_;
  BoxSmoothing smoothing_;
  std::vector<double> length_;  // along the contour [m]
  std::vector<double> x_, y_;   // contour
  std::vector<double> smooth_x_, smooth_y_;
  std::vector<double> response_;
};

/// The response of FLIRT to the ranges; see FlirtDetector.
class RangeResponse {
 public:
  explicit RangeResponse(const FlirtParams& params) : params_(params) {}

  void find_peaks(const ScanTrace& trace, const ScanTrace::Piece& piece, double angle_increment,
                  std::vector<FlirtPeak>& peaks);

 private:
  void respond(const ScanTrace& trace, const ScanTrace::Piece& piece, double sigma);

  FlirtParams params_;
  BoxSmoothing smoothing_;
  std::vector<double> smooth_;
  std::vector<double> response_;
};

}  // namespace falko_slam
