// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/posed_scan.hpp"

#include <optional>
#include <stdexcept>
#include <variant>

#include "falko_slam/sensor/scan_normalizer.hpp"

namespace falko_slam {

std::vector<PosedScan> load_posed_scans(const std::string& path, CarmenReport& report) {
  CarmenLogReader reader(path);
  std::vector<PosedScan> scans;
  std::optional<Pose2> map_T_robot;
  while (const auto record = reader.next()) {
    if (const auto* vertex = std::get_if<CarmenVertex>(&*record)) map_T_robot = vertex->map_T_robot;
    const auto* carmen = std::get_if<CarmenScan>(&*record);
    if (carmen == nullptr) continue;
    PosedScan posed;
    if (!normalize(carmen->raw(), {}, posed.scan).usable()) continue;
    posed.map_T_laser =
        map_T_robot ? *map_T_robot * (carmen->world_T_robot.inverse() * carmen->world_T_laser)
                    : carmen->world_T_laser;
    scans.push_back(std::move(posed));
    map_T_robot.reset();
  }
  report = reader.report();
  if (scans.empty()) throw std::runtime_error(path + ": no laser scan in " + describe(report));
  return scans;
}

}  // namespace falko_slam
