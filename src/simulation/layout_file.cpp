// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>

#include "falko_slam/common/yaml_fields.hpp"
#include "falko_slam/simulation/layout.hpp"
#include "scenario_drive.hpp"

namespace falko_slam {

Layout read_layout(const std::string& path) {
  YamlFields fields(path);
  Layout layout;
  layout.name = std::filesystem::path(path).stem().string();
  fields.field("name", layout.name);
  for (const DriveStep& step : read_drive(fields, ActuatorModel())) {
    if (const auto* wait = std::get_if<WaitStep>(&step)) layout.steps.emplace_back(*wait);
    if (const auto* follow = std::get_if<FollowStep>(&step)) layout.steps.emplace_back(*follow);
    if (std::holds_alternative<ArcStep>(step)) {
      fields.at("drive").fail(
          "has an arc, which no pose leads: a layout is of `follow` and `wait`");
    }
  }
  if (layout.steps.empty()) fields.fail("has no steps in `drive`: there is nothing to follow");
  return layout;
}

}  // namespace falko_slam
