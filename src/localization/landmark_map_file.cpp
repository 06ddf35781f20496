// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>
#include <unordered_map>

#include "falko_slam/common/number_text.hpp"
#include "falko_slam/common/whole_file.hpp"
#include "falko_slam/common/yaml_fields.hpp"
#include "falko_slam/common/yaml_value.hpp"
#include "landmark_fields.hpp"

namespace falko_slam {
namespace {

constexpr int kMapVersion = 1;
constexpr std::size_t kMostBytes = std::size_t{1} << 20U;  // that YamlFields reads

std::string list_of(const std::vector<int>& numbers) {
  std::string text;
  for (const int number : numbers) text += (text.empty() ? "" : ", ") + std::to_string(number);
  return "[" + text + "]";
}

std::string line_of(const MapLandmark& landmark) {
  const Eigen::Matrix2d& c = landmark.covariance;
  std::string text = "- {id: " + std::to_string(landmark.id) +
                     ", kind: " + name_of(landmark.kind, landmark_kind_names()) + ", position: [" +
                     exact_text(landmark.position.x()) + ", " + exact_text(landmark.position.y()) +
                     "], covariance: [" + exact_text(c(0, 0)) + ", " + exact_text(c(0, 1)) + ", " +
                     exact_text(c(1, 1)) + "], hits: " + std::to_string(landmark.hits) +
                     ", name: " + quoted(landmark.name);
  if (landmark.kind == LandmarkKind::kReflector) {
    const ReflectorLayout& layout = landmark.layout;
    text += ", diameter: " + exact_text(layout.diameter) +
            ", type: " + std::to_string(layout.type) +
            ", subtype: " + std::to_string(layout.subtype) + ", layers: " + list_of(layout.layers);
  }
  return text + "}\n";
}

void read_layout(const YamlFields& fields, ReflectorLayout& layout) {
  fields.field("diameter", layout.diameter);
  fields.field("type", layout.type);
  fields.field("subtype", layout.subtype);
  const auto layers = fields.find("layers");
  if (!layers) return;
  layout.layers.clear();
  for (const YamlValue& layer : layers->items()) {
    layout.layers.push_back(static_cast<int>(layer.integer(0, kMostLayer)));
  }
  if (layout.layers.empty()) layers->fail("must have at least one");
}

MapLandmark landmark_in(const YamlValue& value) {
  const YamlFields fields(value);
  MapLandmark landmark;
  landmark.id = static_cast<int>(fields.at("id").integer(0, kMostLandmarkId));
  landmark.kind = fields.at("kind").choice(landmark_kind_names());
  const auto position = fields.at("position").numbers(2, {-kFarthestLandmark, kFarthestLandmark});
  landmark.position = {position[0], position[1]};
  const YamlValue covariance = fields.at("covariance");
  const auto c = covariance.numbers(3);
  landmark.covariance << c[0], c[1], c[1], c[2];
  if (!is_covariance(landmark.covariance)) {
    covariance.fail("must be [xx, xy, yy] of a positive semidefinite matrix");
  }
  fields.field("hits", landmark.hits);
  fields.field("name", landmark.name);
  if (landmark.kind == LandmarkKind::kReflector) read_layout(fields, landmark.layout);
  fields.check([&] { validate(landmark); });
  fields.refuse_unknown();
  return landmark;
}

}  // namespace

void write_landmark_map(const std::string& path, const LandmarkMap& map) {
  validate(map);
  std::string text =
      "# A map of landmarks of falko_slam, in metres; covariance: [xx, xy, yy].\n"
      "landmark_map_version: " +
      std::to_string(kMapVersion) + "\nlandmarks:\n";
  for (const MapLandmark& landmark : map.landmarks) text += line_of(landmark);
  text += "complete: true\n";
  if (text.size() > kMostBytes) {
    throw std::invalid_argument("landmarks: " + std::to_string(map.landmarks.size()) +
                                " are too many for a file of 1 MiB");
  }
  write_whole_file(path, text);
}

LandmarkMap read_landmark_map(const std::string& path) {
  const YamlFields file(path);
  file.at("landmark_map_version").integer(kMapVersion, kMapVersion);
  LandmarkMap map;
  std::unordered_map<int, std::string> path_of;
  for (const YamlValue& value : file.at("landmarks").items()) {
    map.landmarks.push_back(landmark_in(value));
    const int id = map.landmarks.back().id;
    const auto [first, is_new] = path_of.emplace(id, value.path());
    if (!is_new) value.fail("id " + std::to_string(id) + " is that of " + first->second);
  }
  if (!file.at("complete").flag()) file.at("complete").fail("must be true");
  file.refuse_unknown();
  return map;
}

}  // namespace falko_slam
