// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/localizer.hpp"

namespace falko_slam {

class Localizer::Impl {
 public:
  Impl(const LocalizerParams& params, const LandmarkMap& map) : params_(params) { validate(map); }

  LocalizerParams params_;
  LocalizerReport report_;
};

Localizer::Localizer(const LocalizerParams& params, const LandmarkMap& map)
    : impl_(std::make_unique<Impl>(params, map)) {}
Localizer::~Localizer() = default;
Localizer::Localizer(Localizer&&) noexcept = default;
Localizer& Localizer::operator=(Localizer&&) noexcept = default;

InputVerdict Localizer::add_motion(Time, const PoseEstimate&) { return InputVerdict::kInOrder; }
const LocalizerReport& Localizer::add_scan(const LaserScan&) { return impl_->report_; }
const LocalizerReport& Localizer::add_reflectors(Time, std::vector<LandmarkObservation>) {
  return impl_->report_;
}
void Localizer::set_pose(Time, const std::optional<PoseEstimate>&) {}
void Localizer::globalize() {}
const LocalizerReport& Localizer::check(Time) { return impl_->report_; }
const LocalizerReport& Localizer::state() const { return impl_->report_; }
const LocalizerParams& Localizer::params() const { return impl_->params_; }

}  // namespace falko_slam
