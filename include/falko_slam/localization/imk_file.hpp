// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "falko_slam/localization/landmark_map.hpp"

namespace falko_slam {

// Layouts of reflectors as SOPAS ET keeps them for SICK's NAV350, a reflector a line:
//     globID x_mm y_mm type subtype size_mm layer1 [layer2 ...]
// Whole numbers between blanks or tabs; empty lines, lines that begin with # and the heading, which
// begins with globID, are passed over. So has it sick_scan_xd's readNAVIMKfile
// (\cite sick2023scanxd); other than that driver we refuse lines that we cannot understand. The
// frame is that of the layout: x and y are not turned by the half turn of the driver's scans.

/// `deviation`: standard deviation of both coordinates, of which the file says nothing [m]. Throws
/// std::runtime_error, "plant.imk: line 4: x_mm: must be a whole number in [...]".
LandmarkMap read_imk(const std::string& path, double deviation = 0.01);

/// Places are rounded to millimetres; names, hits and covariances have no place in the file.
/// Returns how many features of the map were left out. Throws std::invalid_argument if there is no
/// reflector or one with a number that the file cannot hold, std::runtime_error that names the file
/// if it cannot be written; then the old one is still there.
std::size_t write_imk(const std::string& path, const LandmarkMap& map);

}  // namespace falko_slam
