// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace falko_slam {

/// The path of a file that somebody else has named, below a folder and nowhere else: neither
/// absolute, nor by "..", nor by a symbolic link. Throws std::invalid_argument that says why not.
std::string file_below(const std::string& folder, const std::string& name);

}  // namespace falko_slam
