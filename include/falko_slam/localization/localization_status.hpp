// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace falko_slam {

/// What a pose is good for.
enum class LocalizationStatus {
  kOk,          ///< recent scans fit the map and the covariance is within its limits
  kDegraded,    ///< nothing contradicts the pose, but it is not sure enough to be kOk
  kLost,        ///< no pose: there is none yet, or scans contradict the one that there was
  kRecovering,  ///< no pose: places that fit are being compared
};
const char* name_of(LocalizationStatus status);

/// Why it is that status. Of several reasons the first one in this list is given.
enum class LocalizationReason {
  kNone,  ///< of kOk

  // kLost
  kNoPose,        ///< none was set, none was searched for
  kCarried,       ///< a scan showed quite another scene than the one before, none fitted since
  kContradicted,  ///< what is seen does not fit the map there
  kTooUncertain,  ///< the covariance is beyond the limits of a usable pose
  kNoSensors,     ///< neither motions nor scans for too long

  // kRecovering
  kSearching,   ///< no place fits yet
  kAmbiguous,   ///< several places fit about as well
  kConfirming,  ///< one place fits; more scans must agree

  // kDegraded
  kClockSetBack,       ///< stamps went back: what happened in between is not known
  kNoMotions,          ///< none for a while; the way is guessed
  kOdometryDisagrees,  ///< scans show a motion that the odometry does not
  kNoScans,            ///< none for a while, or none that can be used
  kUnconfirmed,        ///< too few scans have agreed with a pose that is new
  kMisfit,             ///< residuals are greater than the noises explain
  kMapDisagrees,       ///< too much of what is seen is not in the map, or the other way round
  kFewLandmarks,       ///< too few landmarks for a while
  kUncertain,          ///< the covariance is beyond the limits of kOk
};
constexpr std::size_t kLocalizationReasonCount = 18;
const char* name_of(LocalizationReason reason);

/// A sentence for people.
std::string describe(LocalizationReason reason);

}  // namespace falko_slam
