// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>

namespace falko_slam {

/// A keyframe's name: counted up in the order in which they were made.
struct KeyframeId {
  std::uint64_t value = 0;

  friend bool operator==(KeyframeId a, KeyframeId b) { return a.value == b.value; }
  friend bool operator!=(KeyframeId a, KeyframeId b) { return a.value != b.value; }
  friend bool operator<(KeyframeId a, KeyframeId b) { return a.value < b.value; }
};

}  // namespace falko_slam

// doxygen knows no std.
/// \cond
template <>
struct std::hash<falko_slam::KeyframeId> {
  std::size_t operator()(falko_slam::KeyframeId id) const noexcept {
    return std::hash<std::uint64_t>()(id.value);
  }
};
/// \endcond
