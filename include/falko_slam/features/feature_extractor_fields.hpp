// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "falko_slam/common/enum_names.hpp"
#include "falko_slam/features/feature_extractor.hpp"

namespace falko_slam {

// The names of the parameters as they stand in files and on the parameter server: this is their one
// home. A visitor has
//     void field(const char* name, T& value)                              for double, int, bool
//     void choice(const char* name, Enum& value, const EnumNames<Enum>&)  for enumerations
// and, for groups, begin(const char* name) and end(). `Params` may be const.

inline const EnumNames<ScanNormalizerParams::StampAt>& stamp_at_names() {
  using StampAt = ScanNormalizerParams::StampAt;
  static const EnumNames<StampAt> names = {{"first", StampAt::kFirstBeam},
                                           {"middle", StampAt::kMiddleBeam},
                                           {"last", StampAt::kLastBeam}};
  return names;
}

inline const EnumNames<FalkoParams::Ranking>& ranking_names() {
  using Ranking = FalkoParams::Ranking;
  static const EnumNames<Ranking> names = {{"roughness", Ranking::kRoughness},
                                           {"sector_score", Ranking::kSectorScore}};
  return names;
}

template <class Params, class Visitor>
void visit_scan_fields(Params& params, Visitor& visitor) {
  visitor.choice("stamp_at", params.stamp_at, stamp_at_names());
  visitor.field("upside_down", params.upside_down);
  visitor.field("zero_is_no_return", params.zero_is_no_return);
  visitor.field("range_offset", params.range_offset);
  visitor.field("min_range", params.min_range);
  visitor.field("max_range", params.max_range);
}

template <class Params, class Visitor>
void visit_falko_fields(Params& params, Visitor& visitor) {
  visitor.field("radius_scale", params.neighborhood.radius_scale);
  visitor.field("radius_growth", params.neighborhood.radius_growth);
  visitor.field("max_radius", params.neighborhood.max_radius);
  visitor.field("sample_spacing", params.neighborhood.sample_spacing);
  visitor.field("smoothing_window", params.neighborhood.smoothing_window);
  visitor.field("min_incidence", params.neighborhood.min_incidence);
  visitor.field("min_points_per_side", params.neighborhood.min_points_per_side);
  visitor.field("triangle_ratio", params.triangle_ratio);
  visitor.field("sectors", params.sectors);
  visitor.field("suppression_radius", params.suppression_radius);
  visitor.field("refinement_limit", params.refinement_limit);
  visitor.field("merge_radius", params.merge_radius);
  visitor.choice("ranking", params.ranking, ranking_names());
}

template <class Params, class Visitor>
void visit_descriptor_fields(Params& params, Visitor& visitor) {
  visitor.field("radius", params.radius);
  visitor.field("rings", params.rings);
  visitor.field("sectors", params.sectors);
  visitor.field("cgh_sigma", params.cgh_sigma);
}

template <class Params, class Visitor>
void visit_feature_extractor_fields(Params& params, Visitor& visitor) {
  visitor.begin("scan");
  visit_scan_fields(params.scan, visitor);
  visitor.end();
  visitor.begin("falko");
  visit_falko_fields(params.falko, visitor);
  visitor.end();
  visitor.begin("descriptor");
  visit_descriptor_fields(params.descriptor, visitor);
  visitor.end();
}

}  // namespace falko_slam
