// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "falko_slam/calibration/calibration_file.hpp"
#include "map_build.hpp"
#include "map_inspection.hpp"

namespace falko_slam {
namespace cli {
namespace {

// Where the laser is: what tf has is what somebody measured by hand.
struct LaserOptions {
  std::string calibration;
  std::vector<double> pose;
};

void add_laser_options(CLI::App& verb, LaserOptions& laser) {
  CLI::Option* calibration =
      verb.add_option("--calibration", laser.calibration,
                      "file of `falko calibrate`: where the laser is; default: as the bag's tf has "
                      "it. A laser that is turned by half a degree moves corners by centimetres");
  verb.add_option("--laser", laser.pose, "the same: x y theta [m], [rad]")
      ->expected(3)
      ->excludes(calibration);
}

std::optional<Pose2> laser_of(const LaserOptions& laser) {
  if (!laser.calibration.empty()) {
    return read_calibration(laser.calibration).calibration.base_T_laser;
  }
  if (laser.pose.empty()) return std::nullopt;
  return Pose2(laser.pose[0], laser.pose[1], laser.pose[2]);
}

void add_mapper_options(CLI::App& verb, FeatureMapperParams& mapper) {
  verb.add_option("--cluster-radius", mapper.cluster_radius,
                  "keypoints within this of a corner are of it [m], default 0.06")
      ->check(number_in(0.005, 1.0));
  verb.add_option("--min-hits", mapper.min_hits, "scans that must have seen it, default 10")
      ->check(CLI::Range(1, 1000000));
  verb.add_option("--min-viewpoints", mapper.min_viewpoints,
                  "places from which it must have been seen, default 4")
      ->check(CLI::Range(1, 100000));
  verb.add_option("--viewpoint-spacing", mapper.viewpoint_spacing,
                  "scans taken within this are of one viewpoint [m], default 0.3")
      ->check(number_in(0.01, 100.0));
  verb.add_option("--min-share", mapper.min_share,
                  "of the scans that should have seen it, default 0.4")
      ->check(number_in(0.0, 1.0));
  verb.add_option("--separation", mapper.separation,
                  "of two that are nearer the better one stays [m], default 0.15")
      ->check(number_in(0.0, 10.0));
}

void add_build(CLI::App& map) {
  auto options = std::make_shared<MapBuildOptions>();
  CLI::App* verb = map.add_subcommand("build", "corners of a drive as landmarks of a fixed map");
  verb->add_option("bag", options->bag, "of the drive, with its scans and transforms")->required();
  verb->add_option("--poses", options->poses,
                   "where base_link was: a TUM file, such as `falko localize` writes, or a topic "
                   "of the bag such as ground_truth")
      ->required();
  verb->add_option("--reflectors", options->reflectors,
                   "map to begin with (.yaml, .imk): its landmarks stay as they are");
  verb->add_option("--out", options->out, "map to write (.yaml)")->required();
  verb->add_option("--topic", options->topic, "LaserScan topic of the bag; default: its only one");
  verb->add_option("--base-frame", options->base_frame, "whose poses they are, default base_link");
  auto laser = std::make_shared<LaserOptions>();
  add_laser_options(*verb, *laser);
  verb->add_option("--max-range", options->max_range,
                   "keypoints farther away are left out [m], default 15")
      ->check(number_in(0.5, 1000.0));
  add_mapper_options(*verb, options->mapper);
  verb->add_option("--json", options->json, "write the figures; - for the console");
  verb->callback([options, laser] {
    options->base_T_laser = laser_of(*laser);
    build_map(*options);
  });
}

void add_inspect(CLI::App& map) {
  auto path = std::make_shared<std::string>();
  auto json = std::make_shared<std::string>();
  CLI::App* verb = map.add_subcommand("inspect", "what a map holds");
  verb->add_option("map", *path, ".yaml or .imk")->required();
  verb->add_option("--json", *json, "write the figures; - for the console");
  verb->callback([path, json] { inspect_map(*path, *json); });
}

void add_convert_map(CLI::App& map) {
  auto in = std::make_shared<std::string>();
  auto out = std::make_shared<std::string>();
  auto replace = std::make_shared<bool>(false);
  CLI::App* verb = map.add_subcommand(
      "convert", "a map into the other format: .imk is a layout of reflectors, else YAML");
  verb->add_option("in", *in, "map to read")->required();
  verb->add_option("out", *out, "map to write")->required();
  verb->add_flag("--force", *replace, "replace an existing file");
  verb->callback([in, out, replace] { convert_map(*in, *out, *replace); });
}

}  // namespace

void add_map(CLI::App& app) {
  CLI::App* map = app.add_subcommand("map", "maps of landmarks: reflectors and corners");
  map->require_subcommand(1);
  add_build(*map);
  add_inspect(*map);
  add_convert_map(*map);
}

}  // namespace cli
}  // namespace falko_slam
