// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

namespace falko_slam {

/// The machine's steady clock, which nobody sets [s].
inline double steady_now() { return ros::SteadyTime::now().toSec(); }

}  // namespace falko_slam
