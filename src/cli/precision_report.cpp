// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "precision_report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "falko_slam/evaluation/vehicle_knowledge.hpp"

#include "falko_slam/evaluation/thesis_calibration.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace cli {
namespace {

using PrecisionRuns = std::vector<PrecisionRun>;

void print_parameters(const char* what, const VehicleCalibration& calibration) {
  std::printf("  %-12s %8.2f %8.2f   %.6f %8.2f %7.2f %8.2f\n", what,
              100.0 * radians_to_degrees(calibration.tricycle.steer_offset_forward),
              100.0 * radians_to_degrees(calibration.tricycle.steer_offset_backward),
              1e3 * calibration.tricycle.driving_scale, 1e3 * calibration.base_T_laser.x(),
              1e3 * calibration.base_T_laser.y(),
              100.0 * radians_to_degrees(calibration.base_T_laser.theta()));
}

void print_vehicles(const PrecisionRuns& runs) {
  std::printf("                alpha_F  alpha_B        s_w      l_x     l_y  l_theta\n");
  std::printf("                 [cdeg]   [cdeg]  [mm/tick]     [mm]    [mm]   [cdeg]\n");
  for (const PrecisionRun& run : runs) {
    std::printf("%s, %s\n", run.vehicle.name.c_str(),
                run.vehicle.calibrated ? name_of(run.verdict) : "not calibrated");
    print_parameters("true", true_calibration(run.vehicle.model));
    print_parameters("taken for", run.believed);
  }
}

void print_drives(const PrecisionRuns& runs) {
  std::printf("\n%-16s halts  seconds  scans OK [%%]  cross-track, own pose [mm]\n", "");
  for (const PrecisionRun& run : runs) {
    const double scans = static_cast<double>(std::max<std::size_t>(1, run.drive.scans));
    std::printf("%-16s %5zu %8.0f %12.1f %27.1f  %s\n", run.vehicle.name.c_str(),
                run.drive.halts.size(), run.drive.seconds,
                100.0 * static_cast<double>(run.drive.status[0]) / scans,
                1e3 * run.drive.cross_track_rmse, run.drive.trouble.c_str());
  }
}

void print_halts(const PrecisionRuns& runs, const std::vector<LocalHalt>& halts) {
  std::printf("\nhalting points from the mean of the calibrated vehicles; *: after a curve\n");
  std::printf("point  vehicle              x       y    dist  heading  from planned\n");
  std::printf("                         [mm]    [mm]    [mm]    [deg]          [mm]\n");
  std::vector<std::string> points;
  for (const LocalHalt& halt : halts) {
    if (std::find(points.begin(), points.end(), halt.point) == points.end()) {
      points.push_back(halt.point);
    }
  }
  for (const std::string& point : points) {
    for (const LocalHalt& halt : halts) {
      if (halt.point != point) continue;
      std::printf("%-4s%c  %-16s %7.1f %7.1f %7.1f %8.3f %13.1f\n", point.c_str(),
                  halt.after_curve ? '*' : ' ', runs[halt.run].vehicle.name.c_str(), 1e3 * halt.x,
                  1e3 * halt.y, 1e3 * halt.distance(), radians_to_degrees(halt.heading),
                  1e3 * halt.planned);
    }
  }
}

struct Distances {
  double mean = 0.0, worst = 0.0, planned = 0.0;
  std::size_t count = 0;

  void add(const LocalHalt& halt) {
    ++count;
    mean += (halt.distance() - mean) / static_cast<double>(count);
    planned += (halt.planned - planned) / static_cast<double>(count);
    worst = std::max(worst, halt.distance());
  }
};

void print_distances(const char* what, const Distances& of) {
  std::printf("%-28s %5zu %8.1f %8.1f %14.1f\n", what, of.count, 1e3 * of.mean, 1e3 * of.worst,
              1e3 * of.planned);
}

void print_summary(const PrecisionRuns& runs, const std::vector<LocalHalt>& halts) {
  Distances smooth, curves;
  std::vector<Distances> each(runs.size());
  for (const LocalHalt& halt : halts) {
    each[halt.run].add(halt);
    if (runs[halt.run].vehicle.calibrated) (halt.after_curve ? curves : smooth).add(halt);
  }
  std::printf("\n%-28s halts  mean [mm]  worst  from planned\n", "distance from the mean");
  for (std::size_t i = 0; i < runs.size(); ++i) {
    print_distances(runs[i].vehicle.name.c_str(), each[i]);
  }
  print_distances("calibrated, smooth points", smooth);
  print_distances("calibrated, after a curve", curves);
}

}  // namespace

void print_precision(const PrecisionRuns& runs) {
  const std::vector<LocalHalt> halts = local_halts(runs);
  print_vehicles(runs);
  print_drives(runs);
  print_halts(runs, halts);
  print_summary(runs, halts);
}

nlohmann::json as_json(const PrecisionRuns& runs) {
  nlohmann::json document = nlohmann::json::array();
  for (const PrecisionRun& run : runs) {
    document.push_back({{"vehicle", run.vehicle.name},
                        {"calibrated", run.vehicle.calibrated},
                        {"trouble", run.drive.trouble},
                        {"halts", nlohmann::json::array()}});
  }
  for (const LocalHalt& halt : local_halts(runs)) {
    document[halt.run]["halts"].push_back({{"point", halt.point},
                                           {"after_curve", halt.after_curve},
                                           {"x", halt.x},
                                           {"y", halt.y},
                                           {"heading", halt.heading},
                                           {"from_planned", halt.planned}});
  }
  return document;
}

}  // namespace cli
}  // namespace falko_slam
