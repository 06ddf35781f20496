// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "scenario_thing.hpp"

#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "scenario_values.hpp"
#include "thing_copies.hpp"

namespace falko_slam {
namespace {

const EnumNames<BodyMotion::Repeat>& repeat_names() {
  using Repeat = BodyMotion::Repeat;
  static const EnumNames<Repeat> names = {{"once", Repeat::kOnce},
                                          {"round", Repeat::kRound},
                                          {"back_and_forth", Repeat::kBackAndForth}};
  return names;
}

// One copy and where the first one is.
struct Outline {
  Shape shape;
  Pose2 at;
};

// Its frame is that of the world, moved to the first point.
Outline read_lines(const YamlValue& value, bool closed, std::size_t surface) {
  const auto points = read_points(value, closed ? 3 : 2);
  if (closed && points.front() == points.back()) value.fail("ends where it begins");
  Outline outline;
  outline.at = {points.front(), 0.0};
  const std::size_t faces = closed ? points.size() : points.size() - 1;
  for (std::size_t i = 0; i < faces; ++i) {
    outline.shape.faces.push_back(
        {points[i] - points.front(), points[(i + 1) % points.size()] - points.front(), surface});
  }
  return outline;
}

// Each face becomes a parabola of chords: counter-clockwise outlines, so outward is to the right.
void add_bulge(Shape& shape, double bulge) {
  constexpr int kChords = 4;
  if (bulge == 0.0) return;
  std::vector<Face> faces;
  for (const Face& face : shape.faces) {
    const Eigen::Vector2d way = face.to - face.from;
    const Eigen::Vector2d outward = Eigen::Vector2d(way.y(), -way.x()).normalized();
    const auto place = [&](int i) -> Eigen::Vector2d {
      const double share = static_cast<double>(i) / kChords;
      return face.from + share * way + 4.0 * share * (1.0 - share) * bulge * outward;
    };
    for (int i = 0; i < kChords; ++i) faces.push_back({place(i), place(i + 1), face.surface});
  }
  shape.faces = std::move(faces);
}

Outline read_box(const YamlFields& box, const std::optional<Eigen::Vector2d>& usual,
                 double bulge_factor, std::size_t surface) {
  Outline outline;
  if (const auto at = box.find("at")) outline.at = read_pose(*at);
  const bool given = !usual || box.has("size");
  add_box(outline.shape, {}, given ? read_size(box.at("size")) : *usual, surface);
  const auto bulge = box.find("bulge");
  if (bulge) add_bulge(outline.shape, bulge_factor * bulge->number({0.0, 1.0}));
  return outline;
}

Outline read_cylinder(const YamlFields& cylinder, double usual_radius, std::size_t surface) {
  Outline outline;
  if (const auto at = cylinder.find("at")) outline.at = {read_point(*at), 0.0};
  const auto radius = cylinder.find("radius");
  outline.shape.cylinders.push_back(
      {Eigen::Vector2d::Zero(), radius ? read_radius(*radius) : usual_radius, surface});
  return outline;
}

BodyMotion read_motion(const YamlFields& fields) {
  BodyMotion motion;
  motion.through = read_poses(fields.at("through"));
  if (const auto speed = fields.find("speed")) motion.speed = read_speed(*speed);
  if (const auto repeat = fields.find("repeat")) motion.repeat = repeat->choice(repeat_names());
  fields.refuse_unknown();
  return motion;
}

void read_body(const YamlFields& fields, Thing& thing) {
  const auto moves = fields.find("moves");
  const auto appears = fields.find("appears");
  const auto disappears = fields.find("disappears");
  thing.is_fixed = !moves && !appears && !disappears;
  thing.body.motion.through = {Pose2()};
  if (moves) thing.body.motion = read_motion(YamlFields(*moves));
  constexpr double kForever = std::numeric_limits<double>::infinity();
  if (appears) thing.body.appears = appears->number({0.0, 1e9});
  if (disappears) thing.body.disappears = disappears->number({thing.body.appears, kForever});
}

}  // namespace

std::size_t ThingReader::surface_of(const YamlFields& thing, const std::string& usual) const {
  const auto value = thing.find("surface");
  const std::string name = value ? value->text() : usual;
  std::string known;
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    if (surfaces_[i].name == name) return i;
    known += (i == 0 ? "" : ", ") + surfaces_[i].name;
  }
  value->fail("there is no such surface; there are " + known);
}

Thing ThingReader::read(const YamlValue& value) {
  const YamlFields fields(value);
  const std::string kind =
      fields.one_of({"wall", "polygon", "box", "pallet", "column", "reflector"});
  const YamlValue what = fields.at(kind);
  Outline outline;
  if (kind == "wall") {
    const auto closed = fields.find("closed");
    outline = read_lines(what, closed && closed->flag(), surface_of(fields, "concrete"));
  } else if (kind == "polygon") {
    outline = read_lines(what, true, surface_of(fields, "concrete"));
  } else {
    const YamlFields shape(what);
    if (!fields.has("moves")) shape.at("at");
    if (kind == "box")
      outline = read_box(shape, std::nullopt, variation_.bulge, surface_of(fields, "concrete"));
    const Eigen::Vector2d pallet(1.2, 0.8);  // EUR
    if (kind == "pallet")
      outline = read_box(shape, pallet, variation_.bulge, surface_of(fields, "cardboard"));
    if (kind == "column") outline = read_cylinder(shape, 0.2, surface_of(fields, "concrete"));
    if (kind == "reflector") outline = read_cylinder(shape, 0.04, surface_of(fields, "reflector"));
    shape.refuse_unknown();
  }
  Thing thing;
  thing.shape = outline.shape;
  thing.copies = read_copies(fields, outline.at, variation_.scatter, seed, number_++);
  read_body(fields, thing);
  fields.refuse_unknown();
  return thing;
}

}  // namespace falko_slam
