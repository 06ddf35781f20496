// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam_run.hpp"

#include <ctime>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace cli {
namespace {

double processor_seconds() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

}  // namespace

void StageTimes::enter(const std::string& stage) {
  const double now = processor_seconds();
  if (!stage_.empty()) seconds_[stage_] += now - since_;
  stage_ = stage;
  since_ = now;
}

SlamRun::SlamRun(const SlamParams& params, double outliers, unsigned seed)
    : params_(params), slam_(params), outliers_(outliers), random_(seed) {
  times_.enter("reading");
  slam_.on_stage([this](SlamStage stage) {
    times_.enter(stage == SlamStage::kIdle ? "reading" : name_of(stage));
  });
}

void SlamRun::add(const RecordedScan& recorded) {
  ScanNormalizerParams scan = params_.scan;
  scan.upside_down = scan.upside_down || recorded.upside_down;
  if (!normalize(recorded.raw, scan, scan_).usable()) ++unusable_;
  const SlamScan input{recorded.raw.stamp, scan_, recorded.odom_T_base, recorded.base_T_laser};
  record_.add(recorded.raw.stamp, slam_.add(input));
  if (outliers_ > 0.0) inject_outliers();
}

// As if the loop detector had mistaken any keyframe for any other one.
void SlamRun::inject_outliers() {
  constexpr double kReach = 3.0;  // [m]
  const auto uniform = [&](double min, double max) {
    return std::uniform_real_distribution<double>(min, max)(random_);
  };
  const std::size_t end = slam_.closures().size();
  for (; seen_closures_ < end; ++seen_closures_) {
    const SlamClosure closure = slam_.closures()[seen_closures_];
    if (!closure.accepted || uniform(0.0, 1.0) >= outliers_) continue;
    const auto target =
        std::uniform_int_distribution<std::uint64_t>(0, closure.source.value - 1)(random_);
    PoseEstimate mistaken;
    mistaken.pose = Pose2(uniform(-kReach, kReach), uniform(-kReach, kReach), uniform(-kPi, kPi));
    mistaken.covariance = pose_covariance(0.02, 0.005);
    slam_.propose({target}, closure.source, mistaken);
  }
  seen_closures_ = slam_.closures().size();
}

void SlamRun::finish() { slam_.finish(); }

}  // namespace cli
}  // namespace falko_slam
