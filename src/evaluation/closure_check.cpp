// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/closure_check.hpp"

#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>
#include <unordered_map>
#include <vector>

#include "falko_slam/common/line_reader.hpp"
#include "falko_slam/common/number_text.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

constexpr double kFarOff = 0.5;                          // [m]
constexpr double kFarTurned = degrees_to_radians(10.0);  // [rad]

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

// A line's cells by the names in the first line.
class Table {
 public:
  explicit Table(const std::string& path) : in_(path) {
    std::string line;
    if (in_.next(line)) {
      for (const std::string& name : cells_of(line)) column_.emplace(name, column_.size());
    }
    for (const char* name : {"source", "target", "verdict", "x", "y", "theta"}) {
      if (column_.count(name) == 0) in_.fail(std::string("has no column ") + name);
    }
  }

  bool next() {
    std::string line;
    if (!in_.next(line)) return false;
    cells_ = cells_of(line);
    if (cells_.size() != column_.size()) fail("has as many cells as the first line");
    return true;
  }
  const std::string& text(const std::string& name) const { return cells_[column_.at(name)]; }
  double number(const std::string& name) const {
    const auto value = number_of(text(name));
    if (!value) fail("has a number as " + name);
    return *value;
  }
  [[noreturn]] void fail(const std::string& needed) const { in_.fail("no line that " + needed); }

 private:
  LineReader in_;
  std::map<std::string, std::size_t> column_;
  std::vector<std::string> cells_;
};

}  // namespace

ClosureCheck check_closures(const std::string& closures_csv, const PoseGraph& graph) {
  std::unordered_map<std::string, Pose2> poses;
  for (const GraphNode& node : graph.nodes) {
    poses.emplace(std::to_string(node.id.value), node.map_T_node);
  }
  ClosureCheck check;
  Table table(closures_csv);
  while (table.next()) {
    if (table.text("verdict") != "accepted") {
      ++check.refused;
      continue;
    }
    ++check.accepted;
    const auto target = poses.find(table.text("target"));
    const auto source = poses.find(table.text("source"));
    if (target == poses.end() || source == poses.end()) table.fail("names keyframes of the graph");
    const Pose2 measured(table.number("x"), table.number("y"), table.number("theta"));
    const Pose2 error = measured.inverse() * target->second.inverse() * source->second;
    const double distance = error.translation().norm();
    const double turn = std::abs(error.theta());
    check.errors.translation.push_back(distance);
    check.errors.rotation.push_back(turn);
    if (distance >= kFarOff || turn >= kFarTurned) ++check.far_off;
  }
  return check;
}

}  // namespace falko_slam
