// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "map_description.hpp"

#include <yaml-cpp/yaml.h>

#include <optional>
#include <stdexcept>

#include "falko_slam/common/enum_names.hpp"
#include "falko_slam/common/number_text.hpp"

namespace falko_slam {
namespace {

// The parser goes deeper with each bracket.
constexpr std::size_t kMaxYamlBytes = 8192;

const EnumNames<MapMode>& mode_names() {
  static const EnumNames<MapMode> names = {
      {"trinary", MapMode::kTrinary}, {"scale", MapMode::kScale}, {"raw", MapMode::kRaw}};
  return names;
}

[[noreturn]] void fail(const YAML::Mark& mark, const std::string& what) {
  const bool known = mark.line >= 0;
  throw std::runtime_error((known ? "line " + std::to_string(mark.line + 1) + ": " : "") + what);
}

double number_in(const YAML::Node& node, const std::string& name, double min, double max) {
  const auto value = node.IsScalar() ? number_of(node.Scalar()) : std::nullopt;
  if (!value || *value < min || *value > max) {
    fail(node.Mark(),
         name + " must be a number in [" + exact_text(min) + ", " + exact_text(max) + "]");
  }
  return *value;
}

YAML::Node field_of(const YAML::Node& document, const char* name) {
  const YAML::Node node = document[name];
  if (!node) throw std::runtime_error(std::string(name) + " is missing");
  return node;
}

Pose2 origin_of(const YAML::Node& node) {
  if (!node.IsSequence() || node.size() != 3) fail(node.Mark(), "origin must be [x, y, yaw]");
  constexpr double kFar = 1e9;
  return {number_in(node[0], "x of origin", -kFar, kFar),
          number_in(node[1], "y of origin", -kFar, kFar),
          number_in(node[2], "yaw of origin", -kFar, kFar)};
}

MapMode mode_of(const YAML::Node& node) {
  const auto mode = node.IsScalar() ? value_of<MapMode>(node.Scalar(), mode_names()) : std::nullopt;
  if (!mode) fail(node.Mark(), "mode must be " + list_names(mode_names()));
  return *mode;
}

bool flag_of(const YAML::Node& node, const char* name) {
  const std::string text = node.IsScalar() ? node.Scalar() : "";
  if (text == "1" || text == "true") return true;
  if (text != "0" && text != "false") fail(node.Mark(), std::string(name) + " must be 0 or 1");
  return false;
}

MapDescription described(const YAML::Node& document) {
  if (!document.IsMap()) throw std::runtime_error("is not a map's YAML file");
  MapDescription map;
  const YAML::Node image = field_of(document, "image");
  if (!image.IsScalar() || image.Scalar().empty()) fail(image.Mark(), "image must name a file");
  map.image = image.Scalar();
  map.resolution = number_in(field_of(document, "resolution"), "resolution", 1e-6, 1e6);
  map.origin = origin_of(field_of(document, "origin"));
  map.negate = flag_of(field_of(document, "negate"), "negate");
  map.occupied = number_in(field_of(document, "occupied_thresh"), "occupied_thresh", 0.0, 1.0);
  map.free = number_in(field_of(document, "free_thresh"), "free_thresh", 0.0, map.occupied);
  if (document["mode"]) map.mode = mode_of(document["mode"]);
  return map;
}

}  // namespace

MapDescription parse_map_description(const std::string& text) {
  if (text.size() > kMaxYamlBytes) throw std::runtime_error("is too long for a map's YAML file");
  try {
    return described(YAML::Load(text));
  } catch (const YAML::Exception& error) {
    throw std::runtime_error(error.what());
  }
}

}  // namespace falko_slam
