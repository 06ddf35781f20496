// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/localizer.hpp"

#include "localizer_core.hpp"

namespace falko_slam {

Localizer::Localizer(const LocalizerParams& params, const LandmarkMap& map)
    : impl_(std::make_unique<Impl>(params, map)) {}
Localizer::~Localizer() = default;
Localizer::Localizer(Localizer&&) noexcept = default;
Localizer& Localizer::operator=(Localizer&&) noexcept = default;

InputVerdict Localizer::add_motion(Time stamp, const PoseEstimate& motion) {
  return impl_->add_motion(stamp, motion);
}

const LocalizerReport& Localizer::add_scan(const LaserScan& scan) {
  impl_->add_scan(scan);
  return impl_->report_;
}

const LocalizerReport& Localizer::add_reflectors(
    Time stamp, const std::vector<LandmarkObservation>& observations) {
  ScanLandmarks landmarks;
  landmarks.instant = stamp;
  for (const LandmarkObservation& observation : observations) {
    if (!is_usable(observation)) continue;
    landmarks.seen.push_back({observation, Duration::zero()});
  }
  impl_->add_landmarks(landmarks, nullptr);
  return impl_->report_;
}

void Localizer::set_pose(Time stamp, const std::optional<PoseEstimate>& map_T_base) {
  impl_->set_pose(stamp, map_T_base);
}

void Localizer::globalize() { impl_->forget_pose(true); }

const LocalizerReport& Localizer::check(Time now) {
  impl_->check(now);
  return impl_->report_;
}

const LocalizerReport& Localizer::state() const { return impl_->report_; }
std::vector<ActiveLandmark> Localizer::landmarks() const { return impl_->landmarks(); }
const LocalizerParams& Localizer::params() const { return impl_->params_; }

}  // namespace falko_slam
