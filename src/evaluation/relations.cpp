// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/relations.hpp"

#include <cmath>
#include <locale>
#include <sstream>
#include <stdexcept>

#include "falko_slam/common/line_reader.hpp"
#include "falko_slam/geometry/trajectory_file.hpp"

namespace falko_slam {
namespace {

Relation parse_line(const std::string& line, const LineReader& file) {
  std::istringstream in(line);
  in.imbue(std::locale::classic());
  std::string first;
  std::string second;
  std::string rest;
  double x = 0.0, y = 0.0, z = 0.0, roll = 0.0, pitch = 0.0, yaw = 0.0;
  if (!(in >> first >> second >> x >> y >> z >> roll >> pitch >> yaw) || in >> rest) {
    file.fail("must be eight numbers: ts1 ts2 x y z roll pitch yaw");
  }
  const auto first_time = time_of(first);
  const auto second_time = time_of(second);
  if (!first_time || !second_time)
    file.fail("'" + first + " " + second + "' are no two timestamps");
  return {*first_time, *second_time, {x, y, yaw}};
}

}  // namespace

std::vector<Relation> read_relations(const std::string& path) {
  LineReader file(path);
  std::vector<Relation> relations;
  for (std::string line; file.next(line);) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos || line[first] == '#') continue;
    relations.push_back(parse_line(line, file));
  }
  if (relations.empty()) throw std::runtime_error(path + ": holds no relation");
  return relations;
}

RelationErrors evaluate_relations(const Trajectory& trajectory,
                                  const std::vector<Relation>& relations) {
  const TrajectoryIndex poses(trajectory);
  RelationErrors result;
  for (const Relation& relation : relations) {
    const auto map_T_first = poses.at(relation.first);
    const auto map_T_second = poses.at(relation.second);
    if (!map_T_first || !map_T_second) {
      ++result.missing;
      continue;
    }
    const Pose2 estimated = map_T_first->inverse() * *map_T_second;
    const Pose2 error = relation.first_T_second.inverse() * estimated;
    result.errors.translation.push_back(error.translation().norm());
    result.errors.rotation.push_back(std::abs(error.theta()));
    result.compared.push_back(relation);
  }
  if (result.compared.empty()) {
    throw std::runtime_error("none of " + std::to_string(relations.size()) +
                             " relations has both its stamps among the " +
                             std::to_string(trajectory.size()) + " poses of the trajectory");
  }
  return result;
}

}  // namespace falko_slam
