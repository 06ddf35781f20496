// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/driven_scan.hpp"

#include <map>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

#include "falko_slam/sensor/scan_normalizer.hpp"

namespace falko_slam {
namespace {

// map_T_robot of the scans that have a vertex.
std::map<Time, Pose2> corrected_poses(const std::string& path) {
  CarmenLogReader reader(path);
  std::map<Time, Pose2> poses;
  std::optional<Pose2> vertex;
  while (const auto record = reader.next()) {
    if (const auto* found = std::get_if<CarmenVertex>(&*record)) vertex = found->map_T_robot;
    const auto* scan = std::get_if<CarmenScan>(&*record);
    if (scan == nullptr) continue;
    if (vertex) poses[scan->stamp] = *vertex;
    vertex.reset();
  }
  return poses;
}

// From one scan of known truth to the next.
void spread_error(std::vector<DrivenScan>& scans, std::size_t from, std::size_t to) {
  const auto truth_by = [&](std::size_t known, std::size_t i) {
    return scans[known].map_T_laser * (scans[known].odom_T_laser.inverse() * scans[i].odom_T_laser);
  };
  for (std::size_t i = from + 1; i < to; ++i) {
    const Pose2 forward = truth_by(from, i);
    const double share = static_cast<double>(i - from) / static_cast<double>(to - from);
    scans[i].map_T_laser =
        forward * Pose2::exp(share * (forward.inverse() * truth_by(to, i)).log());
  }
}

}  // namespace

std::vector<DrivenScan> load_driven_scans(const std::string& raw, const std::string& corrected,
                                          CarmenReport& report) {
  const std::map<Time, Pose2> truth = corrected_poses(corrected);
  CarmenLogReader reader(raw);
  std::vector<DrivenScan> scans;
  std::optional<std::size_t> last_known;
  std::size_t known = 0;
  while (const auto record = reader.next()) {
    const auto* carmen = std::get_if<CarmenScan>(&*record);
    if (carmen == nullptr) continue;
    const auto found = truth.find(carmen->stamp);
    if (!last_known && found == truth.end()) continue;
    DrivenScan driven;
    if (!normalize(carmen->raw(), {}, driven.scan).usable()) continue;
    driven.odom_T_laser = carmen->world_T_laser;
    scans.push_back(std::move(driven));
    if (found == truth.end()) continue;
    const Pose2 robot_T_laser = carmen->world_T_robot.inverse() * carmen->world_T_laser;
    scans.back().map_T_laser = found->second * robot_T_laser;
    if (last_known) spread_error(scans, *last_known, scans.size() - 1);
    last_known = scans.size() - 1;
    ++known;
  }
  report = reader.report();
  if (known < 2) {
    throw std::runtime_error(raw + ": " + std::to_string(known) + " of its scans are in " +
                             corrected + ", need two");
  }
  scans.resize(*last_known + 1);
  return scans;
}

}  // namespace falko_slam
