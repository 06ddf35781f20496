// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/validation.hpp"
#include "falko_slam/features/reflector_detector.hpp"

namespace falko_slam {

void validate(const ReflectorDetectorParams& params) {
  require_in_range("diameter", params.diameter, 0.01, 1.0);
  require_in_range("min_visible", params.min_visible, 0.1, 1.0);
  require_in_range("min_hits", params.min_hits, 1, 100);
  require_in_range("max_range", params.max_range, 0.0, 1000.0);
  require_in_range("beam_diameter", params.beam_diameter, 0.0, 0.5);
  require_in_range("beam_divergence", params.beam_divergence, 0.0, 0.1);
  require_in_range("range_noise", params.range_noise, 1e-4, 1.0);
  require_in_range("range_bias", params.range_bias, 0.0, 0.1);
  require_in_range("bearing_noise", params.bearing_noise, 0.0, 0.1);
  require_in_range("threshold", params.threshold, 0.0, 1e9);
  require_in_range("threshold_falloff", params.threshold_falloff, 0.0, 4.0);
  require_in_range("contrast", params.contrast, 1.05, 1000.0);
  require_in_range("memory", params.memory, 0, 1000000);
}

std::string describe(IntensityFault fault) {
  switch (fault) {
    case IntensityFault::kNone:
      return "";
    case IntensityFault::kMissing:
      return "the scan has no intensities: without them no reflector is found; let the driver of "
             "the scanner publish them";
    case IntensityFault::kAllZero:
      return "all intensities are 0: without them no reflector is found; the driver of the scanner "
             "fills the field with nothing";
    case IntensityFault::kAllTheSame:
      return "all intensities are the same: without them no reflector is found; the driver of the "
             "scanner fills the field with a constant";
  }
  return "";
}

}  // namespace falko_slam
