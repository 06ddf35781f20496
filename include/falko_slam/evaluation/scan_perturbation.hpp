// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <random>

#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

/// The changed scans of \cite kallasi2017, section 3.3; all stay in the frame of the original.

/// Gaussian noise of `standard_deviation` [m] on every valid range; those that fall below 1 mm are
/// set to it.
LaserScan with_noise(const LaserScan& scan, double standard_deviation, std::mt19937_64& random);

/// Leaves `removed` beams out between any two that stay.
LaserScan subsampled(const LaserScan& scan, std::size_t removed);

/// Adds `added` beams between any two neighbours, their ranges interpolated linearly; invalid where
/// either neighbour is. On a closed scan also between the last and the first beam.
LaserScan oversampled(const LaserScan& scan, std::size_t added);

/// The same ranges from a laser turned by `angle` [rad].
LaserScan with_start_angle_turned(const LaserScan& scan, double angle);

/// What the laser of a closed scan would see turned by `beams` increments: beam i has the range
/// and intensity that beam i + beams has in the original.
LaserScan with_beams_rotated(const LaserScan& scan, std::size_t beams);

}  // namespace falko_slam
