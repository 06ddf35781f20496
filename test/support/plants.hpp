// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "falko_slam/simulation/layout.hpp"
#include "falko_slam/simulation/scenario.hpp"

namespace falko_slam {
namespace test {

/// A hall of 24 x 18 m with ten reflectors; the vehicle stands at (2, 0).
inline Scenario small_plant() {
  Scenario scenario;
  scenario.world.surfaces = {{"wall", 0.6, 0.0}, {"reflector", 0.3, 500.0}};
  add_box(scenario.world.fixed, {10.0, 13.0, 0.0}, {24.0, 0.4}, 0);
  add_box(scenario.world.fixed, {10.0, -5.0, 0.0}, {24.0, 0.4}, 0);
  add_box(scenario.world.fixed, {-2.0, 4.0, 0.0}, {0.4, 18.0}, 0);
  add_box(scenario.world.fixed, {22.0, 4.0, 0.0}, {0.4, 18.0}, 0);
  for (const Eigen::Vector2d& at : {Eigen::Vector2d(-1.7, -2.1),
                                    {-1.7, 6.3},
                                    {3.2, 12.7},
                                    {11.9, 12.7},
                                    {21.7, 9.8},
                                    {21.7, 1.1},
                                    {17.3, -4.7},
                                    {8.8, -4.7},
                                    {1.1, -4.7},
                                    {6.4, 4.9}}) {
    scenario.world.fixed.cylinders.push_back({at, 0.04, 1});
  }
  scenario.world_T_start = {2.0, 0.0, 0.0};
  scenario.vehicle.errors.steering_per_run = 5e-4;
  scenario.vehicle.errors.slip_per_run = 1e-3;
  return scenario;
}

/// A round in it with operation points A and B.
inline Layout lap() {
  FollowStep out;
  out.through = {{14.0, 0.0}, {14.0, 5.0}};
  out.name = "A";
  FollowStep back;
  back.through = {{14.0, 9.0}, {2.0, 9.0}, {2.0, 3.0}};
  back.name = "B";
  FollowStep home;
  home.through = {{2.0, 0.0}, {6.0, 0.0}};
  home.corner_radius = 2.0;
  return {"lap", {WaitStep{1.0}, out, WaitStep{1.0}, back, WaitStep{1.0}, home}};
}

}  // namespace test
}  // namespace falko_slam
