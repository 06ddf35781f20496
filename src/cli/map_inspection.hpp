// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace falko_slam {
namespace cli {

/// Prints what a map holds: counts, extent, deviations, hits. `json`: empty: none; "-": the
/// console.
void inspect_map(const std::string& map, const std::string& json);

/// From one format to the other, by their endings, and says what is lost on the way. Throws
/// std::runtime_error for a file that exists, unless it may be replaced.
void convert_map(const std::string& in, const std::string& out, bool replace);

}  // namespace cli
}  // namespace falko_slam
