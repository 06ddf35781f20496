// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "falko_slam/evaluation/simulated_drive.hpp"
#include "falko_slam/localization/localizer_params.hpp"

namespace falko_slam {

/// What carries the pose where reflectors are hidden.
enum class PathMethod {
  kState,  ///< Localizer with corners and faces in its state
  /// Localizer with the corners of its map, without any reflectors; with landmarks in its state
  /// beside them if the parameters say so.
  kMap,
  kExternalMap,  ///< ExternalMapFilter, \cite kallasi2017 Algorithm 1
  kOdometry,     ///< nothing
};
const char* name_of(PathMethod method);

/// How far an estimate is off, in the frame of the true base_link.
struct PathError {
  double way = 0.0;      ///< driven since the path began [m]
  double along = 0.0;    ///< [m]
  double across = 0.0;   ///< [m]
  double heading = 0.0;  ///< [rad]
};

/// One run of a path, \cite kallasi2017 Figs. 5.10 to 5.14.
struct PathRun {
  std::string path;
  std::vector<PathError> errors;  ///< after each scan with a pose
  bool arrived = false;           ///< there is a pose at the operation point: the last of `errors`
  double nees = 0.0;              ///< there; 3 degrees of freedom
};

/// The requirement of the plant, \cite kallasi2017 5.6.
struct OperationPoint {
  double position = 0.02;                  ///< [m]
  double heading = 0.0017453292519943296;  ///< 0.1 degrees [rad]
};
bool is_within(const PathRun& run, const OperationPoint& limits = {});

/// The paths of a drive, that is its legs that have a name. Reflectors are hidden beyond
/// DriveLeg::reflectors_until, and seen again after the path's end. Starts at the true first pose.
std::vector<PathRun> evaluate_paths(const SimulatedDrive& drive, PathMethod method,
                                    LocalizerParams params, const LandmarkMap& map);

}  // namespace falko_slam
