// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "falko_slam/evaluation/posed_scan.hpp"

namespace falko_slam {

/// Area seen free by both scans over the area seen free by either, in [0, 1] (\cite kallasi2017,
/// section 3.3, "viewpoint").
///
/// A point is seen free by a scan if the beam nearest to it is valid and at least as long. The
/// areas are counted on a grid of `cell` [m], out to `max_range` [m] from the first scan.
double scan_overlap(const PosedScan& a, const PosedScan& b, double cell = 0.1,
                    double max_range = 12.0);

}  // namespace falko_slam
