// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/map/map_file.hpp"

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "falko_slam/common/enum_names.hpp"
#include "falko_slam/common/number_text.hpp"
#include "falko_slam/common/whole_file.hpp"
#include "pgm_image.hpp"

namespace falko_slam {
namespace {

namespace fs = std::filesystem;

// The parser goes deeper with each bracket.
constexpr std::size_t kMaxYamlBytes = 8192;
constexpr const char* kYamlEnding = ".yaml";
// What map_saver writes: gray 205 of unknown cells is an occupancy just above the second one.
constexpr double kWrittenOccupied = 0.65;
constexpr double kWrittenFree = 0.196;

const EnumNames<MapMode>& mode_names() {
  static const EnumNames<MapMode> names = {
      {"trinary", MapMode::kTrinary}, {"scale", MapMode::kScale}, {"raw", MapMode::kRaw}};
  return names;
}

struct MapDescription {
  std::string image;
  double resolution = 0.0;
  Pose2 origin;
  bool negate = false;
  double occupied = 0.0;
  double free = 0.0;
  MapMode mode = MapMode::kTrinary;
};

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

MapDescription parse_description(const std::string& text) {
  if (text.size() > kMaxYamlBytes) throw std::runtime_error("is too long for a map's YAML file");
  const YAML::Node document = YAML::Load(text);
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

std::int8_t cell_of(std::uint8_t gray, const MapDescription& map) {
  if (map.negate) gray = static_cast<std::uint8_t>(255 - gray);
  if (map.mode == MapMode::kRaw) {
    if (gray == 255) return kUnknownCell;
    if (gray > 100)
      throw std::runtime_error("holds the value " + std::to_string(gray) + " in raw mode");
    return static_cast<std::int8_t>(gray);
  }
  const double occupied = (255 - gray) / 255.0;
  if (occupied > map.occupied) return 100;
  if (occupied < map.free) return 0;
  if (map.mode == MapMode::kTrinary || map.occupied == map.free) return kUnknownCell;
  return static_cast<std::int8_t>(1.0 + 98.0 * (occupied - map.free) / (map.occupied - map.free));
}

GridMap grid_of(const GrayImage& image, const MapDescription& description) {
  GridMap map{image.width, image.height, description.resolution, description.origin, {}};
  map.cells.reserve(image.pixels.size());
  for (std::size_t row = image.height; row-- > 0;) {
    for (std::size_t column = 0; column < image.width; ++column) {
      map.cells.push_back(cell_of(image.pixels[row * image.width + column], description));
    }
  }
  return map;
}

// As YAML wants a name that is more than letters.
std::string quoted(const std::string& name) {
  std::string text = "'";
  for (const char c : name) text += c == '\'' ? std::string("''") : std::string(1, c);
  return text + "'";
}

std::string image_name(const fs::path& yaml_path) {
  const std::string name = yaml_path.stem().string() + ".pgm";
  if (yaml_path.extension() != kYamlEnding || yaml_path.stem().empty()) {
    throw std::invalid_argument(yaml_path.string() + ": the name of a map must end in .yaml");
  }
  for (const char c : name) {
    if (static_cast<unsigned char>(c) < ' ') {
      throw std::invalid_argument(yaml_path.string() +
                                  ": no control characters in the name of a map");
    }
  }
  return name;
}

// Runs what reads a file and puts its name in front of what went wrong.
template <class Work>
auto naming(const std::string& path, Work work) {
  try {
    return work();
  } catch (const YAML::Exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace

void write_map(const std::string& yaml_path, const GridMap& map, const MapFileParams& params) {
  if (params.mode == MapMode::kScale)
    throw std::invalid_argument("maps of mode scale cannot be written");
  validate(map);
  const fs::path path(yaml_path);
  const std::string image_file = image_name(path);
  const bool raw = params.mode == MapMode::kRaw;
  const GrayImage image = raw ? raw_image(map) : trinary_image(map, params.thresholds);
  const Pose2& origin = map.map_T_origin;
  std::string yaml = "image: " + quoted(image_file) + "\n";
  yaml += "resolution: " + exact_text(map.resolution) + "\n";
  yaml += "origin: [" + exact_text(origin.x()) + ", " + exact_text(origin.y()) + ", " +
          exact_text(origin.theta()) + "]\n";
  yaml += "negate: 0\noccupied_thresh: " + exact_text(kWrittenOccupied) +
          "\nfree_thresh: " + exact_text(kWrittenFree) + "\n";
  if (raw) yaml += "mode: raw\n";
  write_whole_file(
      (path.parent_path() / image_file).string(),
      pgm_bytes(image, "CREATOR: falko_slam " + exact_text(map.resolution) + " m/pix"));
  write_whole_file(yaml_path, yaml);
}

GridMap read_map(const std::string& yaml_path) {
  const std::string text = read_whole_file(yaml_path);
  const MapDescription description = naming(yaml_path, [&] { return parse_description(text); });
  const std::string image_path = (fs::path(yaml_path).parent_path() / description.image).string();
  const std::string bytes = read_whole_file(image_path);
  return naming(image_path, [&] { return grid_of(parse_pgm(bytes), description); });
}

}  // namespace falko_slam
