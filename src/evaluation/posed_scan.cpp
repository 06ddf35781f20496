// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/posed_scan.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

#include "falko_slam/sensor/scan_normalizer.hpp"

namespace falko_slam {

namespace {

// Poses in logs are rounded, some of them to the millimetre.
constexpr double kRounding = 5e-3;

bool nearly_same(const Pose2& a, const Pose2& b) {
  const Pose2 difference = a.inverse() * b;
  return difference.translation().norm() < kRounding && std::abs(difference.theta()) < kRounding;
}

// Watches where the poses of the scans come from.
class PoseOrigin {
 public:
  void add(const Pose2& robot_T_laser, bool has_vertex) {
    if (!first_mount_) first_mount_ = robot_T_laser;
    mount_stays_ = mount_stays_ && nearly_same(*first_mount_, robot_T_laser);
    ++(has_vertex ? with_vertex_ : without_vertex_);
  }

  /// What is wrong with them; empty if nothing is.
  std::string fault() const {
    if (with_vertex_ > 0 && without_vertex_ > 0) {
      return std::to_string(without_vertex_) + " of " +
             std::to_string(with_vertex_ + without_vertex_) + " scans without a VERTEX2 line";
    }
    if (with_vertex_ == 0 && mount_stays_) {
      return "no corrected poses: no VERTEX2 lines, and those of the laser are odometry";
    }
    return "";
  }

 private:
  std::optional<Pose2> first_mount_;
  bool mount_stays_ = true;
  std::size_t with_vertex_ = 0;
  std::size_t without_vertex_ = 0;
};

}  // namespace

std::vector<PosedScan> load_posed_scans(const std::string& path, CarmenReport& report) {
  CarmenLogReader reader(path);
  std::vector<PosedScan> scans;
  PoseOrigin origin;
  std::optional<Pose2> next_vertex;
  while (const auto record = reader.next()) {
    if (const auto* vertex = std::get_if<CarmenVertex>(&*record)) next_vertex = vertex->map_T_robot;
    const auto* carmen = std::get_if<CarmenScan>(&*record);
    if (carmen == nullptr) continue;
    const std::optional<Pose2> map_T_robot = std::exchange(next_vertex, std::nullopt);
    PosedScan posed;
    if (!normalize(carmen->raw(), {}, posed.scan).usable()) continue;
    const Pose2 robot_T_laser = carmen->world_T_robot.inverse() * carmen->world_T_laser;
    origin.add(robot_T_laser, map_T_robot.has_value());
    posed.map_T_laser = map_T_robot ? *map_T_robot * robot_T_laser : carmen->world_T_laser;
    scans.push_back(std::move(posed));
  }
  report = reader.report();
  if (scans.empty()) throw std::runtime_error(path + ": no laser scan in " + describe(report));
  if (!origin.fault().empty()) throw std::runtime_error(path + ": " + origin.fault());
  return scans;
}

}  // namespace falko_slam
