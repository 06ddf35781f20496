// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>

#include "commands.hpp"
#include "console.hpp"
#include "falko_slam/evaluation/reflector_evaluation.hpp"
#include "falko_slam/simulation/scenario_file.hpp"

namespace falko_slam {
namespace cli {
namespace {

struct EvaluateReflectorsOptions {
  std::string scenario;
  std::string json;
  ReflectorEvaluationParams params;
};

constexpr double kMillimetres = 1e3;

void print(const char* what, const ReflectorBand& band, const ReflectorErrors& errors) {
  if (errors.count == 0) return;
  std::printf("%3.0f-%-3.0f %-9s %7zu %8.1f %6.1f %8.1f %6.1f", band.from, band.to, what,
              errors.count, kMillimetres * errors.along_bias, kMillimetres * errors.along_rms,
              kMillimetres * errors.across_bias, kMillimetres * errors.across_rms);
  if (errors.nees > 0.0) std::printf(" %6.2f", errors.nees);
  std::printf("\n");
}

void print(const ReflectorEvaluation& evaluation) {
  std::printf("%zu scans: %zu reflectors found, %zu of them where there is none\n",
              evaluation.scans, evaluation.found, evaluation.strangers);
  std::printf("%zu reported by the device, %zu of them not found\n", evaluation.reported,
              evaluation.missed);
  std::printf("   m             count    along: bias, rms   across: bias, rms [mm]   NEES (2)\n");
  for (const ReflectorBand& band : evaluation.bands) {
    print("found", band, band.found);
    print(" hidden", band, band.hidden);
    print("reported", band, band.reported);
  }
}

nlohmann::json json_of(const ReflectorErrors& errors) {
  return {{"count", errors.count},           {"along_bias", errors.along_bias},
          {"along_rms", errors.along_rms},   {"across_bias", errors.across_bias},
          {"across_rms", errors.across_rms}, {"nees", errors.nees}};
}

nlohmann::json json_of(const ReflectorEvaluation& evaluation) {
  nlohmann::json bands = nlohmann::json::array();
  for (const ReflectorBand& band : evaluation.bands) {
    bands.push_back({{"from", band.from},
                     {"to", band.to},
                     {"found", json_of(band.found)},
                     {"hidden", json_of(band.hidden)},
                     {"reported", json_of(band.reported)}});
  }
  return {{"scans", evaluation.scans},         {"found", evaluation.found},
          {"strangers", evaluation.strangers}, {"reported", evaluation.reported},
          {"missed", evaluation.missed},       {"bands", bands}};
}

void evaluate(const EvaluateReflectorsOptions& options) {
  const Scenario scenario = read_scenario(options.scenario);
  ReflectorEvaluation evaluation;
  {
    Progress progress("scans");
    evaluation = evaluate_reflectors(scenario, options.params, [&] { progress.step(); });
  }
  print(evaluation);
  std::printf("%s\n", describe_resources().c_str());
  if (!options.json.empty()) write_json(options.json, json_of(evaluation));
}

}  // namespace

void add_evaluate_reflectors(CLI::App& evaluate_verb) {
  auto options = std::make_shared<EvaluateReflectorsOptions>();
  CLI::App* verb = evaluate_verb.add_subcommand(
      "reflectors", "the reflector detector in a simulated drive, beside the device's own report");
  verb->add_option("scenario", options->scenario, "YAML file, see doc/scenarios.md")->required();
  verb->add_option("--every", options->params.every, "looks at one scan in so many, default 4")
      ->check(CLI::Range(1, 1000));
  verb->add_option("--seed", options->params.seed, "of all noise, default 1")
      ->check(CLI::NonNegativeNumber);
  verb->add_option("--json", options->json, "write all figures")->check(a_file());
  verb->callback([options] { evaluate(*options); });
}

}  // namespace cli
}  // namespace falko_slam
