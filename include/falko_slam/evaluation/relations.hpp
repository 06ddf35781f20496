// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "falko_slam/evaluation/error_summary.hpp"
#include "falko_slam/geometry/trajectory.hpp"

namespace falko_slam {

/// Where the vehicle stood at one time, seen from where it stood at another one: ground truth that
/// a person has checked.
struct Relation {
  Time first{};
  Time second{};
  Pose2 first_T_second;
};

/// Reads lines `ts1 ts2 x y z roll pitch yaw` [s, m, rad], plain, .gz or .bz2, with comments behind
/// #; z, roll and pitch are not used. Throws std::runtime_error that names the file and the line,
/// or the file if it holds no relation.
std::vector<Relation> read_relations(const std::string& path);

struct RelationErrors {
  PoseErrors errors;  ///< of the relations whose stamps the trajectory has, in their order
  std::vector<Relation> compared;  ///< those
  std::size_t missing = 0;         ///< relations with a stamp that the trajectory has not
};

/// How far a trajectory's relative poses are from the true ones, \cite kuemmerle2009, Eqs. (3),
/// (4):
///
///     error = first_T_second^-1 * (map_T_first^-1 * map_T_second)
///
/// split in the length of its translation and the size of its rotation. Where the map lies, and
/// how far it is bent as a whole, does not count. Stamps are found as in TrajectoryIndex.
/// Throws std::runtime_error if no relation can be compared.
RelationErrors evaluate_relations(const Trajectory& trajectory,
                                  const std::vector<Relation>& relations);

}  // namespace falko_slam
