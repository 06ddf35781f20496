// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "scenario_world.hpp"

#include <algorithm>

#include "scenario_thing.hpp"

namespace falko_slam {
namespace {

constexpr std::size_t kMaxPieces = 100000;

void read_surfaces(const YamlValue& value, std::vector<Surface>& surfaces) {
  for (const auto& [name, described] : YamlFields(value).all()) {
    const YamlFields fields(described);
    Surface surface;
    surface.name = name;
    surface.reflectivity = fields.at("reflectivity").number({0.0, 2.0});
    if (const auto gain = fields.find("retro_gain")) surface.retro_gain = gain->number({0.0, 1e6});
    fields.refuse_unknown();
    const auto same = std::find_if(surfaces.begin(), surfaces.end(),
                                   [&](const Surface& one) { return one.name == surface.name; });
    if (same == surfaces.end()) {
      surfaces.push_back(surface);
    } else {
      *same = surface;
    }
  }
}

void add(const Shape& shape, const Pose2& world_T_shape, Shape& all) {
  for (const Face& face : shape.faces) {
    all.faces.push_back({world_T_shape * face.from, world_T_shape * face.to, face.surface});
  }
  for (const Cylinder& cylinder : shape.cylinders) {
    all.cylinders.push_back({world_T_shape * cylinder.center, cylinder.radius, cylinder.surface});
  }
}

}  // namespace

std::vector<Surface> built_in_surfaces() {
  return {{"white", 1.0, 0.0},  {"concrete", 0.5, 0.0},   {"wood", 0.4, 0.0},
          {"steel", 0.3, 0.0},  {"cardboard", 0.6, 0.0},  {"dark", 0.08, 0.0},
          {"glass", 0.05, 0.0}, {"reflector", 0.3, 500.0}};
}

World read_world(const YamlFields& scenario, const WorldVariation& variation) {
  World world;
  world.surfaces = built_in_surfaces();
  if (const auto surfaces = scenario.find("surfaces")) read_surfaces(*surfaces, world.surfaces);
  ThingReader reader(world.surfaces, variation);
  if (const auto seed = scenario.find("scatter_seed")) {
    reader.seed = static_cast<std::uint64_t>(seed->integer(0));
  }
  if (variation.scatter_seed) reader.seed = *variation.scatter_seed;
  std::size_t pieces = 0;
  for (const YamlValue& value : scenario.at("world").items()) {
    const Thing thing = reader.read(value);
    const std::size_t each = thing.shape.faces.size() + thing.shape.cylinders.size();
    pieces += each * thing.copies.size();
    if (pieces > kMaxPieces) value.fail("makes more than 100000 faces and cylinders of the world");
    Body body = thing.body;
    Shape& shape = thing.is_fixed ? world.fixed : body.shape;
    for (const Pose2& copy : thing.copies) add(thing.shape, copy, shape);
    if (!thing.is_fixed) world.bodies.push_back(body);
  }
  return world;
}

}  // namespace falko_slam
