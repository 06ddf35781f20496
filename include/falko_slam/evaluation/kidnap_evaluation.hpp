// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "falko_slam/evaluation/localization_evaluation.hpp"

namespace falko_slam {

/// A vehicle that is carried elsewhere without its odometry noticing: a piece of one drive, then a
/// piece of another.
struct Kidnap {
  Pose2 from, to;               ///< true poses
  double ok_until = 0.0;        ///< how long the wrong pose was still called kOk [s]
  double lost = -1.0;           ///< until no wrong pose is given any more; -1: never [s]
  double three = -1.0;          ///< until a scan shows three landmarks; -1: never [s]
  double pose = -1.0;           ///< until the right pose is given; -1: not within the time [s]
  double ok = -1.0;             ///< until that is kOk; -1: not within the time [s]
  std::size_t wrong_ok = 0;     ///< scans after `lost` after which a wrong pose was kOk
  std::size_t wrong_posed = 0;  ///< the same of any wrong pose that was given
};

struct KidnapParams {
  int count = 100;      ///< [1, 100000]
  double before = 4.0;  ///< of the first piece [s], [0.5, 1000]
  double after = 15.0;  ///< of the second one [s], [0.5, 1000]
  double least = 1.0;   ///< from the one place to the other [m], [0, 1000]
  std::uint64_t seed = 1;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const KidnapParams& params);

/// Kidnaps from random moments of the first drive to random ones of the second, which has the same
/// calibration as far as the localizer is told. Throws std::invalid_argument if the drives are too
/// short or never far enough apart.
std::vector<Kidnap> evaluate_kidnaps(const SimulatedDrive& first, const SimulatedDrive& second,
                                     LocalizerParams params, const LandmarkMap& map,
                                     const KidnapParams& kidnap, const RightPose& right = {});

}  // namespace falko_slam
