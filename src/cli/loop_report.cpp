// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "loop_report.hpp"

#include <cstdio>
#include <string>

namespace falko_slam {

static void to_json(nlohmann::json& json, const LoopTiming& time) {
  json = {{"mean_ms", time.mean}, {"median_ms", time.median}, {"p99_ms", time.p99}};
}

static void to_json(nlohmann::json& json, const LoopOperatingPoint& point) {
  json = {{"min_score", point.min_score},
          {"precision", point.precision},
          {"recall", point.recall},
          {"closures", point.closures},
          {"wrong", point.wrong}};
}

static void to_json(nlohmann::json& json, const LoopMethodResult& result) {
  json = {{"method", result.method},
          {"protocol", name_of(result.protocol)},
          {"scans", result.scans},
          {"loops", result.loops},
          {"break_even", result.summary.break_even},
          {"recall_at_100", result.summary.recall_at_100},
          {"recall_at_95", result.summary.recall_at_95},
          {"f1", result.summary.f1},
          {"curve", result.curve},
          {"creation", result.creation},
          {"closing", result.closing}};
  if (result.accepted.closures > 0) {
    json["accepted"] = result.accepted;
    json["ambiguous"] = result.ambiguous;
  }
}

static void to_json(nlohmann::json& json, const DriveResult& result) {
  json = {{"poses", name_of(result.poses)}, {"keyframes", result.keyframes},
          {"loops", result.loops},          {"accepted", result.accepted},
          {"ambiguous", result.ambiguous},  {"surest_refused", result.surest_refused}};
}

namespace cli {
namespace {

std::string three_digits(double number) {
  char text[16];
  std::snprintf(text, sizeof text, "%5.3f", number);
  return text;
}

}  // namespace

void print_report(const std::vector<LoopMethodResult>& results) {
  const LoopMethodResult* last = nullptr;
  for (const LoopMethodResult& result : results) {
    if (last == nullptr || last->protocol != result.protocol) {
      std::printf("\n%s: %zu scans, %zu of them with a loop to be found\n",
                  name_of(result.protocol), result.scans, result.loops);
      std::printf(
          "  %-14s  break-even  recall at precision 1, .95  greatest F1   "
          "ms: create, close mean, median, p99\n",
          "");
    }
    last = &result;
    const LoopSummary& s = result.summary;
    const std::string break_even = s.break_even > 0.0 ? three_digits(s.break_even) : "-";
    std::printf(
        "  %-14s       %5s                %5.3f  %5.3f        %5.3f         "
        "%6.3f      %6.3f  %6.3f %6.3f\n",
        result.method.c_str(), break_even.c_str(), s.recall_at_100, s.recall_at_95, s.f1,
        result.creation.mean, result.closing.mean, result.closing.median, result.closing.p99);
    const LoopOperatingPoint& point = result.accepted;
    if (point.closures > 0) {
      std::printf(
          "  %-14s accepted by itself, at a score of %.2f: %zu closures, %zu wrong; recall "
          "%.3f; %zu refused as ambiguous\n",
          "", point.min_score, point.closures, point.wrong, point.recall, result.ambiguous);
    }
  }
}

nlohmann::json as_json(const std::vector<LoopMethodResult>& results) { return results; }

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
