// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace falko_slam {

/// Writes beside the file and renames when all of it is on the disk: an old file is replaced by a
/// whole new one or not at all. Throws std::runtime_error that names the file.
void write_whole_file(const std::string& path, const std::string& content);

/// Throws std::runtime_error that names the file.
std::string read_whole_file(const std::string& path);

}  // namespace falko_slam
