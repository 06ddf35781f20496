// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "falko_slam/sensor/scan_report.hpp"

namespace falko_slam {
namespace test {

/// What the normaliser says of ten beams, all of them valid.
inline ScanReport good_scan() {
  ScanReport report;
  report.beam_count = 10;
  report.status_count[static_cast<std::size_t>(BeamStatus::kValid)] = 10;
  return report;
}

}  // namespace test
}  // namespace falko_slam
