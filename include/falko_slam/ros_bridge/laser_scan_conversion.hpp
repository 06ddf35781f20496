// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/LaserScan.h>

#include <string>

#include "falko_slam/sensor/scan_normalizer.hpp"

namespace falko_slam {

/// Borrows the arrays of the message.
RawScan as_raw_scan(const sensor_msgs::LaserScan& message);

/// Copies the arrays.
sensor_msgs::LaserScan to_message(const RawScan& raw, const std::string& frame);

/// Without intensities and frame. What is not valid is written by REP-117: +Inf no return or too
/// far, -Inf too near, NaN erroneous; 0 where zero was ambiguous.
sensor_msgs::LaserScan to_message(const LaserScan& scan, Time stamp);

}  // namespace falko_slam
