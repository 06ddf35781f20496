// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <sys/resource.h>

#include <map>
#include <sstream>

#include "console.hpp"
#include "falko_slam/common/number_text.hpp"
#include "falko_slam/common/whole_file.hpp"
#include "falko_slam/geometry/trajectory_file.hpp"
#include "falko_slam/map/map_file.hpp"
#include "falko_slam/map/png_file.hpp"
#include "falko_slam/pose_graph/g2o_file.hpp"
#include "slam_run.hpp"

namespace falko_slam {
namespace cli {
namespace {

std::string closures_text(const std::vector<SlamClosure>& closures) {
  std::ostringstream out;
  out << "stamp,source,target,origin,verdict,score,x,y,theta\n";
  for (const SlamClosure& closure : closures) {
    const Pose2& pose = closure.target_T_source;
    out << fixed_text(to_seconds(closure.stamp.time_since_epoch()), 6) << ","
        << closure.source.value << "," << closure.target.value << "," << name_of(closure.origin)
        << "," << closure.verdict << "," << fixed_text(closure.score, 4) << ","
        << fixed_text(pose.x(), 6) << "," << fixed_text(pose.y(), 6) << ","
        << fixed_text(pose.theta(), 6) << "\n";
  }
  return out.str();
}

nlohmann::json closures_json(const std::vector<SlamClosure>& closures) {
  std::map<std::string, std::size_t> accepted;
  std::map<std::string, std::map<std::string, std::size_t>> refused;
  for (const SlamClosure& closure : closures) {
    if (closure.accepted) {
      ++accepted[name_of(closure.origin)];
    } else {
      ++refused[name_of(closure.origin)][closure.verdict];
    }
  }
  return {{"accepted", accepted}, {"refused", refused}};
}

nlohmann::json report_of(SlamRun& run, const DriveRecordingReport& read,
                         const std::string& recording) {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return {{"recording", recording},
          {"read", read.description},
          {"scans", run.record().scans()},
          {"unusable_scans", run.unusable()},
          {"scans_without_odometry", read.without_odometry},
          {"lost_scans", run.record().lost()},
          {"searched_scans", run.record().searched()},
          {"keyframes", run.slam().keyframes()},
          {"optimizations", run.record().optimizations()},
          {"closures", closures_json(run.slam().closures())},
          {"processor_seconds", seconds(usage.ru_utime) + seconds(usage.ru_stime)},
          {"stage_seconds", run.times().seconds()},
          {"peak_memory_mb", static_cast<double>(usage.ru_maxrss) / 1024.0}};
}

}  // namespace

void write_slam(SlamRun& run, const DriveRecordingReport& read, const std::string& recording,
                const std::string& folder) {
  run.times().enter("map");
  const GridMap map = map_of(run.slam());
  run.times().enter("writing");
  const std::string base = folder + "/";
  write_tum(base + "trajectory.tum", run.record().final(run.slam()));
  write_tum(base + "trajectory_online.tum", run.record().online());
  if (map.width > 0) {
    write_map(base + "map.yaml", map);
    write_png(base + "map.png", trinary_image(map));
  }
  write_g2o(base + "graph.g2o", run.slam().state().graph);
  write_whole_file(base + "closures.csv", closures_text(run.slam().closures()));
  run.times().enter("reporting");
  write_whole_file(base + "report.json", report_of(run, read, recording).dump(2) + "\n");
}

}  // namespace cli
}  // namespace falko_slam
