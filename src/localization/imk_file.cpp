// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/imk_file.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <unordered_map>

#include "falko_slam/common/line_reader.hpp"
#include "falko_slam/common/validation.hpp"
#include "falko_slam/common/whole_file.hpp"

namespace falko_slam {
namespace {

constexpr const char* kColumns = "globID x_mm y_mm type subtype size_mm layer1 [layer2 ...]";
constexpr std::size_t kFewestColumns = 7;
constexpr std::int64_t kMostId = 65534;  // 65535 is "unknown" on the device
constexpr std::int64_t kMostShort = 65535;
constexpr std::int64_t kFar = 100000000;  // [mm]: what a map admits
constexpr double kMillimetre = 1e-3;

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

std::int64_t number_in(const LineReader& reader, const std::string& word, const std::string& column,
                       std::int64_t min, std::int64_t max) {
  std::int64_t value = 0;
  const char* begin = word.data() + (word.size() > 1 && word[0] == '+' ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, word.data() + word.size(), value);
  const bool whole = error == std::errc() && end == word.data() + word.size();
  if (!whole || value < min || value > max) {
    reader.fail(column + ": must be a whole number in [" + std::to_string(min) + ", " +
                std::to_string(max) + "]");
  }
  return value;
}

MapLandmark landmark_of(const LineReader& reader, const std::vector<std::string>& words,
                        double deviation) {
  if (words.size() < kFewestColumns) reader.fail(std::string("must be ") + kColumns);
  const auto number = [&](std::size_t column, const char* name, std::int64_t min,
                          std::int64_t max) {
    return static_cast<int>(number_in(reader, words[column], name, min, max));
  };
  MapLandmark landmark;
  landmark.id = number(0, "globID", 0, kMostId);
  landmark.position.x() = kMillimetre * number(1, "x_mm", -kFar, kFar);
  landmark.position.y() = kMillimetre * number(2, "y_mm", -kFar, kFar);
  landmark.covariance = deviation * deviation * Eigen::Matrix2d::Identity();
  landmark.layout.type = number(3, "type", 0, 255);
  landmark.layout.subtype = number(4, "subtype", 0, kMostShort);
  landmark.layout.diameter = kMillimetre * number(5, "size_mm", 0, kMostShort);
  landmark.layout.layers.clear();
  for (std::size_t i = kFewestColumns - 1; i < words.size(); ++i) {
    const std::string name = "layer" + std::to_string(i - kFewestColumns + 2);
    landmark.layout.layers.push_back(number(i, name.c_str(), 0, kMostShort));
  }
  return landmark;
}

std::int64_t millimetres(double metres) { return std::llround(metres / kMillimetre); }

std::string imk_line(const MapLandmark& landmark) {
  std::ostringstream line;
  line << landmark.id << ' ' << millimetres(landmark.position.x()) << ' '
       << millimetres(landmark.position.y()) << ' ' << landmark.layout.type << ' '
       << landmark.layout.subtype << ' ' << millimetres(landmark.layout.diameter);
  for (const int layer : landmark.layout.layers) line << ' ' << layer;
  return line.str() + "\n";
}

}  // namespace

LandmarkMap read_imk(const std::string& path, double deviation) {
  require_in_range("deviation", deviation, 0.0, 100.0);
  LineReader reader(path);
  LandmarkMap map;
  std::unordered_map<int, std::size_t> line_of_id;
  for (std::string line; reader.next(line);) {
    const std::vector<std::string> words = words_of(line);
    if (words.empty() || words[0][0] == '#' || words[0].rfind("globID", 0) == 0) continue;
    map.landmarks.push_back(landmark_of(reader, words, deviation));
    const auto [first, is_new] = line_of_id.emplace(map.landmarks.back().id, reader.lines());
    if (!is_new) {
      reader.fail("globID: " + words[0] + " is that of line " + std::to_string(first->second));
    }
  }
  if (map.landmarks.empty()) throw std::runtime_error(path + ": holds no reflector");
  return map;
}

std::size_t write_imk(const std::string& path, const LandmarkMap& map) {
  validate(map);
  std::string text = "globID x_mm y_mm type subtype size_mm layer1\n";
  std::size_t left_out = 0;
  for (std::size_t i = 0; i < map.landmarks.size(); ++i) {
    if (map.landmarks[i].kind != LandmarkKind::kReflector) {
      ++left_out;
      continue;
    }
    const std::string name = "landmarks[" + std::to_string(i) + "].id";
    require_in_range<std::int64_t>(name.c_str(), map.landmarks[i].id, 0, kMostId);
    text += imk_line(map.landmarks[i]);
  }
  if (left_out == map.landmarks.size()) {
    throw std::invalid_argument("landmarks: there is no reflector among them");
  }
  write_whole_file(path, text);
  return left_out;
}

}  // namespace falko_slam
