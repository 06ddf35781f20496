// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tf2/buffer_core.h>

#include <optional>
#include <string>

namespace falko_slam {

/// Who has sent the last transform of a frame, and below which one it hangs by it.
struct FrameSource {
  std::string parent;
  std::string broadcaster;
};
/// Empty if the frame hangs below none.
std::optional<FrameSource> source_of(const tf2::BufferCore& buffer, const std::string& frame);

}  // namespace falko_slam
