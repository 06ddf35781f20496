// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/map/map_file.hpp"

#include <filesystem>
#include <stdexcept>

#include "falko_slam/common/number_text.hpp"
#include "falko_slam/common/whole_file.hpp"
#include "map_description.hpp"
#include "pgm_image.hpp"

namespace falko_slam {
namespace {

namespace fs = std::filesystem;

constexpr const char* kYamlEnding = ".yaml";
// What map_saver writes: gray 205 of unknown cells is an occupancy just above the second one.
constexpr double kWrittenOccupied = 0.65;
constexpr double kWrittenFree = 0.196;

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

// Plain, as map_saver writes it, unless YAML needs quotes around it.
std::string quoted_if_needed(const std::string& name) {
  constexpr const char* kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.-";
  if (name.front() != '-' && name.find_first_not_of(kPlain) == std::string::npos) return name;
  std::string text = "'";
  for (const char c : name) text += c == '\'' ? std::string("''") : std::string(1, c);
  return text + "'";
}

std::string image_name(const fs::path& yaml_path) {
  std::string name = yaml_path.stem().string() + ".pgm";
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
  std::string yaml = "image: " + quoted_if_needed(image_file) + "\n";
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
  const MapDescription description = naming(yaml_path, [&] { return parse_map_description(text); });
  const std::string image_path = (fs::path(yaml_path).parent_path() / description.image).string();
  const std::string bytes = read_whole_file(image_path);
  return naming(image_path, [&] { return grid_of(parse_pgm(bytes), description); });
}

}  // namespace falko_slam
