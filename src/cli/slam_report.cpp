// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam_report.hpp"

#include <cstdio>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {

static void to_json(nlohmann::json& json, const ErrorSummary& summary) {
  json = {{"count", summary.count},
          {"mean", summary.mean},
          {"standard_deviation", summary.standard_deviation},
          {"median", summary.median},
          {"max", summary.max},
          {"rms", summary.rms},
          {"mean_square", summary.mean_square},
          {"square_standard_deviation", summary.square_standard_deviation},
          {"max_square", summary.max_square}};
}

namespace cli {
namespace {

ErrorSummary rotation_in_degrees(const PoseErrors& errors) {
  std::vector<double> degrees;
  for (const double rotation : errors.rotation) degrees.push_back(radians_to_degrees(rotation));
  return summarise(degrees);
}

nlohmann::json json_of(const PoseErrors& errors) {
  return {{"translation_m", summarise(errors.translation)},
          {"rotation_deg", rotation_in_degrees(errors)}};
}

void print_row(const char* what, const char* unit, const ErrorSummary& summary) {
  std::printf("  %-26s [%3s] %9.4f %9.4f %9.4f %9.4f %9.4f  %9.5f %9.5f %10.4f\n", what, unit,
              summary.mean, summary.standard_deviation, summary.median, summary.max, summary.rms,
              summary.mean_square, summary.square_standard_deviation, summary.max_square);
}

void print_errors(const std::string& what, const PoseErrors& errors) {
  print_row((what + "translation").c_str(), "m", summarise(errors.translation));
  print_row((what + "rotation").c_str(), "deg", rotation_in_degrees(errors));
}

void print_result(const SlamResult& result) {
  std::printf("%s: %zu poses\n", result.trajectory.c_str(), result.poses);
  std::printf("  %-32s %9s %9s %9s %9s %9s  %9s %9s %10s\n", "error", "mean", "std", "median",
              "max", "rms", "square", "its std", "its max");
  if (result.relations) {
    print_errors("relative ", result.relations->errors);
    std::printf("  %zu relations compared, %zu left out: the trajectory lacks their stamps\n",
                result.relations->compared.size(), result.relations->missing);
  }
  if (result.truth) {
    print_errors("absolute ", result.truth->absolute);
    print_errors("per way ", result.truth->relative);
    std::printf("  %zu poses compared, %zu left out: there is no truth of their time\n",
                result.truth->absolute.translation.size(), result.truth->missing);
  }
}

}  // namespace

void print_report(const SlamEvaluation& evaluation) {
  for (const SlamResult& result : evaluation.trajectories) print_result(result);
  if (!evaluation.closures) return;
  const ClosureCheck& check = *evaluation.closures;
  std::printf("closures.csv: %zu accepted, %zu refused\n", check.accepted, check.refused);
  if (check.accepted == 0) return;
  print_errors("off the poses, ", check.errors);
  std::printf("  %zu of them by 0.5 m or 10 deg and more\n", check.far_off);
}

nlohmann::json as_json(const SlamEvaluation& evaluation) {
  nlohmann::json document = {{"trajectories", nlohmann::json::array()}};
  if (evaluation.closures) {
    document["closures"] = json_of(evaluation.closures->errors);
    document["closures"]["accepted"] = evaluation.closures->accepted;
    document["closures"]["refused"] = evaluation.closures->refused;
    document["closures"]["far_off"] = evaluation.closures->far_off;
  }
  for (const SlamResult& result : evaluation.trajectories) {
    nlohmann::json entry = {{"trajectory", result.trajectory}, {"poses", result.poses}};
    if (result.relations) {
      entry["relations"] = json_of(result.relations->errors);
      entry["relations"]["compared"] = result.relations->compared.size();
      entry["relations"]["missing"] = result.relations->missing;
    }
    if (result.truth) {
      entry["truth"] = {{"absolute", json_of(result.truth->absolute)},
                        {"relative", json_of(result.truth->relative)},
                        {"compared", result.truth->absolute.translation.size()},
                        {"missing", result.truth->missing}};
    }
    document["trajectories"].push_back(entry);
  }
  return document;
}

}  // namespace cli
}  // namespace falko_slam
