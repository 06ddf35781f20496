// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "map_inspection.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "console.hpp"
#include "falko_slam/localization/map_format.hpp"
#include "output_files.hpp"

namespace falko_slam {
namespace cli {
namespace {

// Least, middle and greatest of some numbers.
struct Spread {
  double min = 0.0, median = 0.0, max = 0.0;
};

Spread spread_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  return {values.front(), values[values.size() / 2], values.back()};
}

nlohmann::json json_of(const Spread& spread) {
  return {{"min", spread.min}, {"median", spread.median}, {"max", spread.max}};
}

// Of the landmarks of one kind.
struct KindSummary {
  std::size_t count = 0;
  Spread x, y;       // [m]
  Spread deviation;  // the greater one of each [m]
  Spread hits;
  std::size_t without_covariance = 0;
};

double greater_deviation(const Eigen::Matrix2d& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(covariance, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, solver.eigenvalues()(1)));
}

KindSummary summary_of(const LandmarkMap& map, LandmarkKind kind) {
  std::vector<double> x, y, deviations, hits;
  KindSummary summary;
  for (const MapLandmark& landmark : map.landmarks) {
    if (landmark.kind != kind) continue;
    ++summary.count;
    if (landmark.covariance.isZero(0.0)) ++summary.without_covariance;
    x.push_back(landmark.position.x());
    y.push_back(landmark.position.y());
    deviations.push_back(greater_deviation(landmark.covariance));
    hits.push_back(landmark.hits);
  }
  summary.x = spread_of(x);
  summary.y = spread_of(y);
  summary.deviation = spread_of(deviations);
  summary.hits = spread_of(hits);
  return summary;
}

// The two landmarks that stand closest.
double least_distance(const LandmarkMap& map) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < map.landmarks.size(); ++i) {
    for (std::size_t j = i + 1; j < map.landmarks.size(); ++j) {
      least =
          std::min(least, (map.landmarks[i].position - map.landmarks[j].position).squaredNorm());
    }
  }
  return std::sqrt(least);
}

void print(const char* kind, const KindSummary& summary) {
  std::printf("%zu %s\n", summary.count, kind);
  if (summary.count == 0) return;
  std::printf("  x from %.3f to %.3f m, y from %.3f to %.3f m\n", summary.x.min, summary.x.max,
              summary.y.min, summary.y.max);
  std::printf("  standard deviation, each one's greater: %.1f to %.1f mm, median %.1f mm\n",
              1e3 * summary.deviation.min, 1e3 * summary.deviation.max,
              1e3 * summary.deviation.median);
  if (summary.without_covariance > 0) {
    std::printf("  %zu of them claim no error at all\n", summary.without_covariance);
  }
  std::printf("  hits: %.0f to %.0f, median %.0f\n", summary.hits.min, summary.hits.max,
              summary.hits.median);
}

nlohmann::json json_of(const KindSummary& summary) {
  return {{"count", summary.count},
          {"x", json_of(summary.x)},
          {"y", json_of(summary.y)},
          {"deviation", json_of(summary.deviation)},
          {"without_covariance", summary.without_covariance},
          {"hits", json_of(summary.hits)}};
}

void say_what_imk_loses(const LandmarkMap& map, std::size_t features) {
  std::size_t names = 0;
  for (const MapLandmark& landmark : map.landmarks) {
    if (landmark.kind == LandmarkKind::kReflector && !landmark.name.empty()) ++names;
  }
  std::printf(
      "lost: %zu features, %zu names, all covariances and hits, and what places have below "
      "a millimetre\n",
      features, names);
}

}  // namespace

void inspect_map(const std::string& path, const std::string& json) {
  const LandmarkMap map = read_map_of_any_format(path);
  const KindSummary reflectors = summary_of(map, LandmarkKind::kReflector);
  const KindSummary features = summary_of(map, LandmarkKind::kFeature);
  if (json != "-") {
    print("reflectors", reflectors);
    print("features", features);
    if (map.landmarks.size() > 1) {
      std::printf("the two that stand closest: %.3f m\n", least_distance(map));
    }
  }
  if (!json.empty()) {
    write_json(json, {{"reflectors", json_of(reflectors)}, {"features", json_of(features)}});
  }
}

void convert_map(const std::string& in, const std::string& out, bool replace) {
  require_new(out, replace);
  const LandmarkMap map = read_map_of_any_format(in);
  const std::size_t features = write_map_of_any_format(out, map);
  std::printf("wrote %s: %zu landmarks\n", out.c_str(), map.landmarks.size() - features);
  if (is_imk(out) && !is_imk(in)) say_what_imk_loses(map, features);
  if (is_imk(in) && !is_imk(out)) {
    std::printf("the layout tells no errors: 10 mm is taken for the standard deviation of each\n");
  }
}

}  // namespace cli
}  // namespace falko_slam
