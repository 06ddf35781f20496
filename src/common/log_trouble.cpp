// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/log_trouble.hpp"

#include <sstream>

namespace falko_slam {

std::string describe_trouble(std::size_t backward_stamps,
                             const std::vector<std::size_t>& malformed_lines) {
  constexpr std::size_t kListed = 5;
  std::ostringstream text;
  if (backward_stamps > 0) {
    text << "; " << backward_stamps << " stamps run backward (file order kept)";
  }
  if (!malformed_lines.empty()) {
    text << "; " << malformed_lines.size() << " malformed lines left out:";
    for (std::size_t i = 0; i < malformed_lines.size() && i < kListed; ++i) {
      text << ' ' << malformed_lines[i];
    }
    if (malformed_lines.size() > kListed) text << " ...";
  }
  return text.str();
}

}  // namespace falko_slam
