// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sstream>
#include <stdexcept>

namespace falko_slam {

/// Throws std::invalid_argument, "name = value: must be in [min, max]", unless it is. NaN is not.
template <class Number>
void require_in_range(const char* name, Number value, Number min, Number max) {
  if (value >= min && value <= max) return;
  std::ostringstream text;
  text << name << " = " << value << ": must be in [" << min << ", " << max << "]";
  throw std::invalid_argument(text.str());
}

}  // namespace falko_slam
