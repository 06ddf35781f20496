// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "loop_report.hpp"

#include <cstdio>
#include <string>

namespace falko_slam {

static void to_json(nlohmann::json& json, const LoopTiming& time) {
  json = {{"mean_ms", time.mean}, {"median_ms", time.median}, {"p99_ms", time.p99}};
}

static void to_json(nlohmann::json& json, const LoopSummary& summary) {
  json = {{"break_even", summary.break_even},
          {"recall_at_100", summary.recall_at_100},
          {"recall_at_95", summary.recall_at_95},
          {"f1", summary.f1}};
}

static void to_json(nlohmann::json& json, const LoopOperatingPoint& point) {
  json = {{"min_score", point.min_score},
          {"precision", point.precision},
          {"recall", point.recall},
          {"closures", point.closures},
          {"wrong", point.wrong}};
}

static void to_json(nlohmann::json& json, const LoopMethodResult& result) {
  json = result.summary;
  json.update({{"method", result.method},
               {"protocol", name_of(result.protocol)},
               {"scans", result.scans},
               {"loops", result.loops},
               {"curve", result.curve},
               {"creation", result.creation},
               {"closing", result.closing}});
  if (result.detection) json["detection"] = *result.detection;
  if (result.search) json["search"] = *result.search;
  if (result.association) json["association"] = *result.association;
  if (result.accepted) {
    json["accepted"] = *result.accepted;
    json["ambiguous"] = result.ambiguous;
  }
}

static void to_json(nlohmann::json& json, const KidnappedResult& result) {
  json = {{"scans", result.scans},
          {"visited", result.visited},
          {"best_right", result.best_right},
          {"any_right", result.any_right},
          {"best", result.best},
          {"locating", result.locating},
          {"travelled", result.travelled}};
}

static void to_json(nlohmann::json& json, const DriveResult& result) {
  json = {{"poses", name_of(result.poses)}, {"keyframes", result.keyframes},
          {"loops", result.loops},          {"accepted", result.accepted},
          {"ambiguous", result.ambiguous},  {"surest_refused", result.surest_refused}};
}

namespace cli {
namespace {

std::string number(const std::optional<double>& value) {
  if (!value) return "-";
  char text[16];
  std::snprintf(text, sizeof text, "%.3f", *value);
  return text;
}

std::optional<double> mean_of(const std::optional<LoopTiming>& timing) {
  return timing ? std::optional<double>(timing->mean) : std::nullopt;
}

void print_accepted(const LoopMethodResult& result) {
  if (!result.accepted) return;
  const LoopOperatingPoint& point = *result.accepted;
  std::printf(
      "  %-14s accepted by itself, at a score of %.2f: %zu closures, %zu wrong; recall "
      "%.3f; %zu refused as ambiguous\n",
      "", point.min_score, point.closures, point.wrong, point.recall, result.ambiguous);
}

void print_method(const LoopMethodResult& result) {
  const LoopSummary& s = result.summary;
  const auto break_even = s.break_even > 0.0 ? std::optional<double>(s.break_even) : std::nullopt;
  std::printf(
      "  %-14s       %5s                %5.3f  %5.3f        %5.3f    "
      "%6s %6s %6s %6s   %7.3f %7.3f %7.3f\n",
      result.method.c_str(), number(break_even).c_str(), s.recall_at_100, s.recall_at_95, s.f1,
      number(mean_of(result.detection)).c_str(), number(result.creation.mean).c_str(),
      number(mean_of(result.search)).c_str(), number(mean_of(result.association)).c_str(),
      result.closing.mean, result.closing.median, result.closing.p99);
  print_accepted(result);
}

void print_kidnapped(const KidnappedResult& result) {
  std::printf("\nkidnapped: %zu scans, %zu of them of a place seen at another time\n", result.scans,
              result.visited);
  std::printf(
      "  one scan       right: the best hypothesis %.3f, one of those returned %.3f; recall at "
      "precision 1 by score %.3f; ms: %.3f\n",
      result.best_right, result.any_right, result.best.recall_at_100, result.locating.mean);
  const LoopMethodResult& travelled = result.travelled;
  std::printf("  after 3 m      recall at precision 1, .95 %.3f %.3f; greatest F1 %.3f\n",
              travelled.summary.recall_at_100, travelled.summary.recall_at_95,
              travelled.summary.f1);
  print_accepted(travelled);
}

}  // namespace

void print_report(const LoopEvaluation& evaluation) {
  const LoopMethodResult* last = nullptr;
  for (const LoopMethodResult& result : evaluation.methods) {
    if (last == nullptr || last->protocol != result.protocol) {
      std::printf("\n%s: %zu scans, %zu of them with a loop to be found\n",
                  name_of(result.protocol), result.scans, result.loops);
      std::printf(
          "  %-14s  break-even  recall at precision 1, .95  greatest F1   ms: detect create search "
          "assoc.   all: mean  median     p99\n",
          "");
    }
    last = &result;
    print_method(result);
  }
  if (evaluation.kidnapped) print_kidnapped(*evaluation.kidnapped);
}

nlohmann::json as_json(const LoopEvaluation& evaluation) {
  nlohmann::json json = {{"methods", evaluation.methods}};
  if (evaluation.kidnapped) json["kidnapped"] = *evaluation.kidnapped;
  return json;
}

void print_report(const std::vector<DriveResult>& results) {
  std::printf(
      "  poses of the    key-          accep-\n"
      "  keyframes      frames  loops     ted  wrong  recall  ambiguous  surest wrong one "
      "refused\n");
  for (const DriveResult& result : results) {
    std::printf("  %-12s  %7zu %6zu %7zu %6zu   %5.3f %10zu                   %5.3f\n",
                name_of(result.poses), result.keyframes, result.loops, result.accepted.closures,
                result.accepted.wrong, result.accepted.recall, result.ambiguous,
                result.surest_refused);
  }
}

nlohmann::json as_json(const std::vector<DriveResult>& results) { return results; }

}  // namespace cli
}  // namespace falko_slam
