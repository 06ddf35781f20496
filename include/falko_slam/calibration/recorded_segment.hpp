// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "falko_slam/calibration/path_segment.hpp"
#include "falko_slam/calibration/reflector_motion.hpp"
#include "falko_slam/calibration/scan_motion.hpp"
#include "falko_slam/common/time.hpp"

namespace falko_slam {

/// What tells how the laser moved.
enum class EgomotionSource { kReflectors, kScans };

/// "reflectors", "scans".
const char* name_of(EgomotionSource source);

/// A drive from halt to halt.
struct RecordedSegment {
  Time begin{}, end{};         ///< of the motion, by the encoders
  PathSegment segment;         ///< only if there is no complaint
  ReflectorMotion motion;      ///< the same; of reflectors
  std::string complaint;       ///< why it is no segment
  std::size_t lost_scans = 0;  ///< on the way, that fitted nowhere
  EgomotionSource egomotion = EgomotionSource::kReflectors;
  ScanMotion scan_motion;  ///< only if there is no complaint; of scans
};

}  // namespace falko_slam
