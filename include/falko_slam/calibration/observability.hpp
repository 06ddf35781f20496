// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "falko_slam/calibration/path_segment.hpp"
#include "falko_slam/calibration/vehicle_calibration.hpp"

namespace falko_slam {

/// What can be said of a calibration; the worse, the further down.
enum class CalibrationVerdict {
  kOk,
  kWeak,           ///< there are numbers, but some hang by little; the remarks name them
  kUnobservable,   ///< the drives do not determine the parameters: no number
  kContradictory,  ///< the drives are not those of a tricycle: no number
};
const char* name_of(CalibrationVerdict verdict);  ///< "OK", "WEAK", ...

/// Why a verdict is not OK, and what would help.
struct CalibrationRemark {
  CalibrationVerdict verdict = CalibrationVerdict::kWeak;
  std::vector<CalibrationParameter> parameters;
  std::string reason;
  std::string remedy;  ///< an arc to drive, or what to check
};

struct ObservabilityParams {
  double weak_condition = 5.0;           ///< worse conditioned is weak, [1, 1e6]
  double unobservable_condition = 50.0;  ///< worse conditioned is no data at all, [1, 1e9]
};
/// Throws std::invalid_argument with the field and its value.
void validate(const ObservabilityParams& params);

/// Condition numbers are infinite where there is nothing.
struct ObservabilityReport {
  CalibrationVerdict verdict = CalibrationVerdict::kOk;
  double forward_condition = 1.0;   ///< of A_psi (2.11); of all segments in the standard model
  double backward_condition = 1.0;  ///< the same of the lower block of (2.17)
  double laser_condition = 1.0;     ///< of M_phi (2.32) with columns of one length
  std::vector<CalibrationRemark> remarks;
};

/// Whether the drives determine the parameters, from what was driven alone: Propositions 2.4.1 to
/// 2.4.3 of \cite kallasi2017 and how near the drives are to not meeting them.
///
/// - Intrinsic: two steering angles that differ, in each direction that has its own offset. The
///   condition number is the ratio of the singular values of A_psi; for |steering| from 18 to 50
///   degrees it is 1.94.
/// - Laser: with rho = sqrt((m_2^2 + m_3^2) / (m_1 m_4)) the pivots of M_phi vanish where rho = 1,
///   which is where all arcs have one centre of rotation. The condition number is
///   sqrt((1 + rho) / (1 - rho)), times sqrt(n / m_1) where that is more than 1: l_pos is seen
///   through the turns only.
/// - Both sides. An error of the steering that all left arcs have in common looks like an offset
///   to who drove left arcs only; no honest interval can be given.
///
/// Deviation: (2.41) is the square of a condition number; Proposition 2.4.3 is not sufficient, as
/// several arcs at one steering angle leave M_phi singular.
ObservabilityReport check_observability(const std::vector<PathSegment>& segments,
                                        TricycleModel model,
                                        const ObservabilityParams& params = {});

}  // namespace falko_slam
