// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/localization_status.hpp"

#include <array>
#include <cstddef>

namespace falko_slam {
namespace {

struct ReasonText {
  const char* name;
  const char* text;
};
// By LocalizationReason.
constexpr std::array<ReasonText, kLocalizationReasonCount> kReasons = {{
    {"none", "scans agree with the map"},
    {"no pose", "no pose was given and none is searched for"},
    {"carried away", "the scene changed at once, and nothing fits the map since"},
    {"contradicted", "what is seen does not fit the map at the pose that was believed"},
    {"too uncertain", "too long without landmarks: the pose may be anywhere"},
    {"no sensors", "neither motions nor scans come"},
    {"searching", "no place of the map fits what is seen yet"},
    {"ambiguous", "several places of the map fit about as well"},
    {"confirming", "a place fits; more scans must agree"},
    {"clock set back", "stamps went back: the motion in between is not known"},
    {"no motions", "no motions come: the way is guessed"},
    {"odometry disagrees", "scans show a motion that the odometry does not"},
    {"no scans", "no scans come that can be used"},
    {"unconfirmed", "too few scans have agreed with this pose so far"},
    {"misfit", "landmarks lie beside their places by more than the noises explain"},
    {"map disagrees", "much of what is seen is not in the map, or much of the map is not seen"},
    {"few landmarks", "too few landmarks are seen"},
    {"uncertain", "the pose is less certain than asked for"},
}};

const ReasonText& text_of(LocalizationReason reason) {
  return kReasons.at(static_cast<std::size_t>(reason));
}

}  // namespace

const char* name_of(LocalizationStatus status) {
  switch (status) {
    case LocalizationStatus::kOk:
      return "ok";
    case LocalizationStatus::kDegraded:
      return "degraded";
    case LocalizationStatus::kLost:
      return "lost";
    case LocalizationStatus::kRecovering:
      return "recovering";
  }
  return "?";
}

const char* name_of(LocalizationReason reason) { return text_of(reason).name; }

std::string describe(LocalizationReason reason) { return text_of(reason).text; }

}  // namespace falko_slam
