// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "commands.hpp"
#include "console.hpp"
#include "falko_slam/geometry/trajectory_file.hpp"
#include "falko_slam/pose_graph/g2o_file.hpp"
#include "slam_report.hpp"

namespace falko_slam {
namespace cli {
namespace {

struct EvaluateSlamOptions {
  std::string folder;
  std::string relations;
  std::string truth;
  std::string trajectory;
  std::string json;
  TrajectoryErrorParams params;
};

std::vector<std::string> trajectories_in(const EvaluateSlamOptions& options) {
  namespace fs = std::filesystem;
  if (!options.trajectory.empty()) return {options.trajectory};
  std::vector<std::string> names;
  for (const char* name : {"trajectory.tum", "trajectory_online.tum"}) {
    if (fs::exists(fs::path(options.folder) / name)) names.emplace_back(name);
  }
  if (names.empty()) {
    throw std::runtime_error(options.folder +
                             ": holds neither trajectory.tum nor trajectory_online.tum");
  }
  return names;
}

std::optional<ClosureCheck> closures_in(const std::string& name) {
  const std::filesystem::path folder(name);
  const auto closures = folder / "closures.csv", graph = folder / "graph.g2o";
  if (!std::filesystem::exists(closures) || !std::filesystem::exists(graph)) return std::nullopt;
  return check_closures(closures.string(), read_g2o(graph.string()).graph);
}

// Runs an evaluation and puts the names of the two files in front of what went wrong.
template <class Evaluation>
auto naming(const std::string& path, const std::string& other, Evaluation evaluation) {
  try {
    return evaluation();
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + " against " + other + ": " + error.what());
  }
}

void evaluate_slam(const EvaluateSlamOptions& options) {
  if (options.relations.empty() && options.truth.empty()) {
    throw std::invalid_argument("evaluate slam: give --relations, --truth or both");
  }
  std::vector<Relation> relations;
  Trajectory truth;
  if (!options.relations.empty()) relations = read_relations(options.relations);
  if (!options.truth.empty()) truth = read_tum(options.truth);
  SlamEvaluation evaluation;
  for (const std::string& name : trajectories_in(options)) {
    const std::string path = (std::filesystem::path(options.folder) / name).string();
    const Trajectory trajectory = read_tum(path);
    SlamResult result{name, trajectory.size(), std::nullopt, std::nullopt};
    if (!options.relations.empty()) {
      result.relations = naming(path, options.relations,
                                [&] { return evaluate_relations(trajectory, relations); });
    }
    if (!options.truth.empty()) {
      result.truth = naming(path, options.truth,
                            [&] { return evaluate_trajectory(trajectory, truth, options.params); });
    }
    evaluation.trajectories.push_back(std::move(result));
  }
  evaluation.closures = closures_in(options.folder);
  print_report(evaluation);
  if (!options.json.empty()) write_json(options.json, as_json(evaluation));
}

}  // namespace

void add_evaluate_slam(CLI::App& evaluate) {
  auto options = std::make_shared<EvaluateSlamOptions>();
  CLI::App* verb = evaluate.add_subcommand(
      "slam", "the trajectories that falko slam wrote, against ground truth");
  verb->add_option("folder", options->folder, "what falko slam --out was given")->required();
  verb->add_option("--relations", options->relations,
                   "true relative poses: lines of ts1 ts2 x y z roll pitch yaw; .gz and .bz2, too");
  verb->add_option("--truth", options->truth, "the true trajectory, in TUM's format");
  verb->add_option("--trajectory", options->trajectory,
                   "a file in the folder, default trajectory.tum and trajectory_online.tum");
  verb->add_option("--distance", options->params.distance,
                   "of way over which motions are compared with --truth [m], default 1")
      ->check(number_in(0.001, 1000.0));
  verb->add_option("--json", options->json, "write all figures")->check(a_file());
  verb->callback([options] { evaluate_slam(*options); });
}

}  // namespace cli
}  // namespace falko_slam
