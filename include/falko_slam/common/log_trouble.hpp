// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace falko_slam {

/// What a reader of a log met beside what it read, in words that follow others: "; 2 stamps run
/// backward (file order kept); 1 malformed lines left out: 7". Empty if there was nothing.
std::string describe_trouble(std::size_t backward_stamps,
                             const std::vector<std::size_t>& malformed_lines);

}  // namespace falko_slam
