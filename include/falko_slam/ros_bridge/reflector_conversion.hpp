// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <falko_slam/ReflectorArray.h>

#include "falko_slam/calibration/segment_recorder.hpp"

namespace falko_slam {

/// Positions that are not finite are left out.
ReflectorObservation from_message(const ReflectorArray& message);

}  // namespace falko_slam
