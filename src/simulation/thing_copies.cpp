// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "thing_copies.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

constexpr std::int64_t kMaxCopies = 10000;

// A displacement along x and y of the world [m] and of the heading [rad].
using Step = Eigen::Vector3d;

// SplitMix64, Steele, Lea and Flood 2014.
std::uint64_t mixed(std::uint64_t state) {
  state += 0x9E3779B97F4A7C15U;
  state = (state ^ (state >> 30U)) * 0xBF58476D1CE4E5B9U;
  state = (state ^ (state >> 27U)) * 0x94D049BB133111EBU;
  return state ^ (state >> 31U);
}

double share(std::uint64_t bits) { return std::ldexp(static_cast<double>(bits >> 11U), -53); }

Step read_step(const YamlValue& value) {
  constexpr NumberRange kNear{-1000.0, 1000.0};
  const std::size_t count = value.is_list() ? value.items().size() : 0;
  if (count != 2 && count != 3) value.fail("must be [x, y, heading] or [x, y]");
  const auto numbers = value.numbers(count, kNear);
  return {numbers[0], numbers[1], count == 3 ? numbers[2] : 0.0};
}

// Each of the places, repeated; the places themselves change fastest.
std::vector<Step> repeated(const std::vector<Step>& places, const YamlValue& value) {
  const YamlFields fields(value);
  const auto most =
      std::max<std::int64_t>(kMaxCopies / static_cast<std::int64_t>(places.size()), 1);
  const std::int64_t count = fields.at("count").integer(1, most);
  const Step step = read_step(fields.at("step"));
  fields.refuse_unknown();
  std::vector<Step> all;
  for (std::int64_t i = 0; i < count; ++i) {
    for (const Step& place : places) all.emplace_back(place + static_cast<double>(i) * step);
  }
  return all;
}

std::vector<Step> read_repeats(const YamlFields& thing) {
  std::vector<Step> places = {Step::Zero()};
  const auto repeat = thing.find("repeat");
  if (!repeat) return places;
  if (!repeat->is_list()) return repeated(places, *repeat);
  for (const YamlValue& item : repeat->items()) places = repeated(places, item);
  return places;
}

std::set<std::size_t> read_without(const YamlFields& thing, std::size_t copies) {
  std::set<std::size_t> numbers;
  const auto without = thing.find("without");
  if (!without) return numbers;
  for (const YamlValue& item : without->items()) {
    const std::int64_t number = item.integer(0, static_cast<std::int64_t>(copies) - 1);
    numbers.insert(static_cast<std::size_t>(number));
  }
  return numbers;
}

Step read_scatter(const YamlFields& thing) {
  const auto scatter = thing.find("scatter");
  if (!scatter) return Step::Zero();
  const auto numbers = scatter->numbers(3, {0.0, 10.0});
  return {numbers[0], numbers[1], numbers[2]};
}

}  // namespace

// Box and Muller 1958, cut off.
double scattered(std::uint64_t seed, std::uint64_t thing, std::uint64_t draw) {
  const std::uint64_t first = mixed(mixed(mixed(seed) ^ thing) ^ draw);
  const double radius = std::sqrt(-2.0 * std::log(1.0 - share(first)));
  return std::clamp(radius * std::cos(kTwoPi * share(mixed(first))), -3.0, 3.0);
}

std::vector<Pose2> read_copies(const YamlFields& thing, const Pose2& world_T_thing,
                               double scatter_factor, std::uint64_t seed, std::uint64_t number) {
  const std::vector<Step> steps = read_repeats(thing);
  const std::set<std::size_t> without = read_without(thing, steps.size());
  const Step scatter = scatter_factor * read_scatter(thing);
  std::vector<Pose2> copies;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (without.count(i) > 0) continue;
    Step step = steps[i];
    for (int axis = 0; axis < 3; ++axis) {
      step[axis] +=
          scatter[axis] * scattered(seed, number, 3 * i + static_cast<std::uint64_t>(axis));
    }
    copies.emplace_back(world_T_thing.x() + step.x(), world_T_thing.y() + step.y(),
                        world_T_thing.theta() + step.z());
  }
  return copies;
}

}  // namespace falko_slam
