// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "falko_slam/calibration/trajectory_calibration.hpp"
#include "stretch_fit.hpp"

namespace falko_slam {

/// What the wheel did until each record since the one before, steered by the mean of both.
std::vector<ArcControl> controls_of(const std::vector<DriveRecord>& records,
                                    const EncoderParams& encoders);

/// The drive cut into windows of so many ticks; what is left at the end counts from half of that.
std::vector<DriveWindow> windows_of(const std::vector<ArcControl>& controls, double ticks);

/// The windows as measurements.
StretchSet stretches_of(const std::vector<DriveWindow>& windows,
                        const std::vector<DriveRecord>& records,
                        const std::vector<ArcControl>& controls,
                        const TrajectoryCalibratorParams& params);

}  // namespace falko_slam
