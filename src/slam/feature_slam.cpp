// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/slam/feature_slam.hpp"

#include <stdexcept>
#include <utility>

#include "feature_slam_impl.hpp"

namespace falko_slam {

const char* name_of(ClosureOrigin origin) {
  switch (origin) {
    case ClosureOrigin::kNearby:
      return "nearby";
    case ClosureOrigin::kPlace:
      return "place";
    case ClosureOrigin::kProposed:
      return "proposed";
  }
  return "?";
}

const char* name_of(SlamStage stage) {
  switch (stage) {
    case SlamStage::kIdle:
      return "idle";
    case SlamStage::kTracking:
      return "tracking";
    case SlamStage::kKeyframe:
      return "keyframes";
    case SlamStage::kLinks:
      return "links";
    case SlamStage::kLoops:
      return "loops";
    case SlamStage::kOptimization:
      return "optimization";
  }
  return "?";
}

FeatureSlam::FeatureSlam(const SlamParams& params, const SlamState& state)
    : impl_((validate(params), std::make_unique<Impl>(params, state))) {}
FeatureSlam::~FeatureSlam() = default;
FeatureSlam::FeatureSlam(FeatureSlam&&) noexcept = default;
FeatureSlam& FeatureSlam::operator=(FeatureSlam&&) noexcept = default;

SlamStep FeatureSlam::add(const SlamScan& scan) { return impl_->add(scan); }
void FeatureSlam::begin_drive() { impl_->begin_drive(); }

SlamClosure FeatureSlam::propose(KeyframeId target, KeyframeId source,
                                 const PoseEstimate& target_T_source) {
  if (target.value >= keyframes() || source.value >= keyframes()) {
    throw std::invalid_argument("closure of keyframes " + std::to_string(target.value) + " and " +
                                std::to_string(source.value) + ": there are " +
                                std::to_string(keyframes()));
  }
  SlamClosure closure{record(source).stamp, source, target, target_T_source.pose,
                      ClosureOrigin::kProposed};
  impl_->propose(closure, target_T_source);
  return impl_->closures.back();
}

void FeatureSlam::finish() {
  if (keyframes() > 0) impl_->finish();
}

std::size_t FeatureSlam::keyframes() const { return impl_->graph.poses().size(); }

bool FeatureSlam::anchored() const {
  return keyframes() > 0 && !impl_->new_drive && impl_->graph.is_mapped({keyframes() - 1});
}

bool FeatureSlam::is_mapped(KeyframeId id) const { return impl_->graph.is_mapped(id); }
Pose2 FeatureSlam::map_T_laser(KeyframeId id) const { return impl_->graph.poses().at(id.value); }
const KeyframeRecord& FeatureSlam::record(KeyframeId id) const { return impl_->memory.record(id); }
const std::vector<SlamClosure>& FeatureSlam::closures() const { return impl_->closures; }
PoseGraph FeatureSlam::graph() const { return impl_->graph.graph(); }
SlamState FeatureSlam::state() const { return impl_->state(); }
void FeatureSlam::on_stage(StageListener listener) { impl_->listener = std::move(listener); }
const SlamParams& FeatureSlam::params() const { return impl_->params; }

}  // namespace falko_slam
