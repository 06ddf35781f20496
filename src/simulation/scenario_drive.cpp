// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "scenario_drive.hpp"

#include <algorithm>
#include <cmath>

#include "falko_slam/geometry/angles.hpp"
#include "scenario_values.hpp"

namespace falko_slam {
namespace {

constexpr std::size_t kMaxSteps = 100000;

WaitStep read_wait(const YamlFields& fields) {
  WaitStep wait;
  wait.seconds = fields.at("seconds").number({0.0, 86400.0});
  return wait;
}

FollowStep read_follow(const YamlFields& fields, const ActuatorModel& actuators) {
  FollowStep follow;
  follow.through = read_points(fields.at("through"), 1);
  const auto speed = fields.find("speed");
  if (speed) follow.speed = speed->number({0.01, actuators.max_wheel_speed});
  if (const auto radius = fields.find("corner_radius")) {
    follow.corner_radius = radius->number({0.0, 1000.0});
  }
  fields.field("backward", follow.backward);
  fields.field("name", follow.name);
  if (const auto until = fields.find("reflectors_until")) {
    follow.reflectors_until = until->number({0.0, 1e5});
  }
  return follow;
}

ArcStep read_arc(const YamlFields& fields, const ActuatorModel& actuators) {
  ArcStep arc;
  const double fastest = actuators.max_wheel_speed;
  const YamlValue speed = fields.at("wheel_speed");
  arc.wheel_speed = speed.number({-fastest, fastest});
  if (std::abs(arc.wheel_speed) < 0.01) speed.fail("must be at least 0.01 forwards or backwards");
  const double most = actuators.max_steering;
  if (const auto steering = fields.find("steering")) arc.steering = steering->number({-most, most});
  if (fields.one_of({"turn", "way"}) == "way") {
    arc.way = fields.at("way").number({0.001, 1e5});
    return arc;
  }
  arc.turn = fields.at("turn").number({1e-4, 1e3});
  // With so little the wheel's offset decides whether it ever turns.
  if (std::abs(arc.steering) < 0.01) fields.at("turn").fail("never ends: there is no steering");
  return arc;
}

void read_steps(const YamlValue& list, const ActuatorModel& actuators, std::vector<DriveStep>& all);

void read_step(const YamlValue& value, const ActuatorModel& actuators,
               std::vector<DriveStep>& all) {
  const YamlFields step(value);
  const std::string kind = step.one_of({"wait", "follow", "arc", "repeat"});
  if (kind == "repeat") {
    const std::int64_t count = step.at("repeat").integer(1, kMaxSteps);
    std::vector<DriveStep> once;
    read_steps(step.at("steps"), actuators, once);
    const std::size_t room = kMaxSteps - std::min(all.size(), kMaxSteps);
    if (static_cast<std::size_t>(count) > room / std::max<std::size_t>(once.size(), 1)) {
      value.fail("makes a drive of more than 100000 steps");
    }
    for (std::int64_t i = 0; i < count; ++i) all.insert(all.end(), once.begin(), once.end());
  } else {
    const YamlFields fields(step.at(kind));
    if (kind == "wait") all.emplace_back(read_wait(fields));
    if (kind == "follow") all.emplace_back(read_follow(fields, actuators));
    if (kind == "arc") all.emplace_back(read_arc(fields, actuators));
    fields.refuse_unknown();
  }
  step.refuse_unknown();
}

void read_steps(const YamlValue& list, const ActuatorModel& actuators,
                std::vector<DriveStep>& all) {
  for (const YamlValue& value : list.items()) read_step(value, actuators, all);
}

}  // namespace

std::vector<DriveStep> read_drive(const YamlFields& scenario, const ActuatorModel& actuators) {
  std::vector<DriveStep> drive;
  if (const auto steps = scenario.find("drive")) read_steps(*steps, actuators, drive);
  return drive;
}

}  // namespace falko_slam
