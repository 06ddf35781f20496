// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "falko_slam/features/reflector_detector.hpp"
#include "falko_slam/sensor/scan_normalizer.hpp"

namespace falko_slam {
namespace cli {

struct ReflectorRunOptions {
  std::string recording;
  std::string topic;
  std::string json;  ///< empty: none; "-": the console
  ScanNormalizerParams scan;
  ReflectorDetectorParams detector;
};

/// Finds the reflectors in all scans of a recording and prints what it found. Throws
/// std::runtime_error where no scan has intensities.
void detect_reflectors(const ReflectorRunOptions& options);

}  // namespace cli
}  // namespace falko_slam
