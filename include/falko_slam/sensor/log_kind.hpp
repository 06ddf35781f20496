// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace falko_slam {

/// The logs in text that can be read.
enum class LogKind {
  kCarmen,    ///< see CarmenLogReader
  kTricycle,  ///< see TricycleLogReader
};

/// Tells logs (plain, .gz or .bz2 by their ending) apart by the first line that belongs to one of
/// them. Throws std::runtime_error with the file's name if it cannot be opened or unpacked, or if
/// it is neither.
LogKind recognize_log(const std::string& path);

}  // namespace falko_slam
