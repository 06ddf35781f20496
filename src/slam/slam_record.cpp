// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/slam/slam_record.hpp"

#include "falko_slam/map/occupancy_grid.hpp"

namespace falko_slam {

void SlamRecord::add(Time stamp, const SlamStep& step) {
  scans_.push_back({stamp, step.map_T_base, step.keyframe, step.keyframe_T_base});
  lost_ += step.lost ? 1U : 0U;
  searched_ += step.searched ? 1U : 0U;
  optimizations_ += step.optimized ? 1U : 0U;
}

Trajectory SlamRecord::online() const {
  Trajectory result;
  for (const Scan& scan : scans_) result.push_back({scan.stamp, scan.map_T_base});
  return result;
}

Trajectory SlamRecord::final(const FeatureSlam& slam) const {
  Trajectory result;
  for (const Scan& scan : scans_) {
    result.push_back({scan.stamp, scan.keyframe
                                      ? slam.map_T_laser(*scan.keyframe) * scan.keyframe_T_base
                                      : scan.map_T_base});
  }
  return result;
}

GridMap map_of(const FeatureSlam& slam) {
  std::vector<ScanAtPose> scans;
  for (std::size_t i = 0; i < slam.keyframes(); ++i) {
    if (!slam.is_mapped({i})) continue;
    scans.push_back({&slam.record({i}).scan, slam.map_T_laser({i})});
  }
  return build_occupancy_grid(scans, slam.params().map);
}

}  // namespace falko_slam
