// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace falko_slam {
namespace cli {

/// Throws std::runtime_error that names `path` if there is such a file and it is not to be
/// replaced.
void require_new(const std::string& path, bool replace);

/// Makes the folder that a command writes its report.json and other files to. Throws
/// std::runtime_error if it cannot be made, or holds the report of an earlier run that is not to
/// be replaced.
void make_output_folder(const std::string& folder, bool replace);

}  // namespace cli
}  // namespace falko_slam
