// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "falko_slam/common/enum_names.hpp"
#include "falko_slam/features/reflector_detector.hpp"

namespace falko_slam {

// The names of the parameters as they stand in files; a visitor as in feature_extractor_fields.hpp.

inline const EnumNames<ReflectorDetectorParams::Shape>& reflector_shape_names() {
  static const EnumNames<ReflectorDetectorParams::Shape> names = {
      {"cylinder", ReflectorDetectorParams::Shape::kCylinder},
      {"flat", ReflectorDetectorParams::Shape::kFlat}};
  return names;
}

template <class Params, class Visitor>
void visit_reflector_detector_fields(Params& params, Visitor& visitor) {
  visitor.choice("shape", params.shape, reflector_shape_names());
  visitor.field("diameter", params.diameter);
  visitor.field("min_visible", params.min_visible);
  visitor.field("min_hits", params.min_hits);
  visitor.field("max_range", params.max_range);
  visitor.field("beam_diameter", params.beam_diameter);
  visitor.field("beam_divergence", params.beam_divergence);
  visitor.field("range_noise", params.range_noise);
  visitor.field("range_bias", params.range_bias);
  visitor.field("bearing_noise", params.bearing_noise);
  visitor.field("threshold", params.threshold);
  visitor.field("threshold_falloff", params.threshold_falloff);
  visitor.field("contrast", params.contrast);
  visitor.field("memory", params.memory);
}

}  // namespace falko_slam
