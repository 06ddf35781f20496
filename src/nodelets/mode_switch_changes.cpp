// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How the ModeSwitch nodelet goes from one mode to another, or does not.
#include <falko_slam/SaveMap.h>
#include <falko_slam/SaveState.h>
#include <falko_slam/SetPose.h>
#include <ros/service.h>

#include <algorithm>
#include <ctime>
#include <stdexcept>

#include "falko_slam/localization/map_format.hpp"
#include "falko_slam/ros_bridge/file_folder.hpp"
#include "falko_slam/ros_bridge/topics.hpp"
#include "falko_slam/slam/slam_state_file.hpp"
#include "mode_switch_nodelet.hpp"

namespace falko_slam {
namespace {

constexpr double kHandoverPatience = 2.0;  // [s]

// A map that was made before must not be lost by one of three metres.
std::string with_time(const std::string& name) {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "_%Y-%m-%d_%H-%M-%S", &utc);
  return name + text;
}

std::string parameter(const std::string& name) {
  std::string value;
  ros::param::get(name, value);
  return value;
}

// Throws std::runtime_error unless the service is there and does what it is asked for.
template <class Service>
void require_success(const std::string& name, Service& service) {
  if (!ros::service::exists(name, false) || !ros::service::call(name, service)) {
    throw std::runtime_error(name + " does not answer");
  }
  if (!service.response.success) throw std::runtime_error(name + ": " + service.response.message);
}

}  // namespace

std::string ModeSwitchNodelet::file_of(VehicleMode mode, const std::string& wished) const {
  const std::string file = wished.empty() ? parameter(file_parameter(mode)) : wished;
  std::string folder;
  if (mode == VehicleMode::kMapping) folder = parameter(nodelet_of(mode).name + "/map_folder");
  return path_in(folder.empty() ? default_file_folder() : with_home(folder), file);
}

void ModeSwitchNodelet::require_readable(VehicleMode mode, const std::string& file) const {
  if (mode == VehicleMode::kLocalization) {
    if (file.empty()) throw std::runtime_error("there is no map: " + file_parameter(mode));
    read_map_of_any_format(file);
  } else if (!file.empty()) {
    load_slam_state(file);
  }
}

SaveState ModeSwitchNodelet::save_map() const {
  const std::string node = nodelet_of(VehicleMode::kMapping).name + "/";
  const std::string name = with_time(params_.save_as);
  SaveState state;
  state.request.file = name + ".slam";
  require_success(node + topics::kSaveState, state);
  SaveMap map;
  map.request.file = name;
  require_success(node + topics::kSaveMap, map);
  return state;
}

// The state becomes the parameter: whoever loads the nodelet again, mapping goes on.
void ModeSwitchNodelet::autosave() {
  if (mode_ != VehicleMode::kMapping || params_.autosave_period == 0.0) return unsaved_.clear();
  const ros::SteadyTime now = ros::SteadyTime::now();
  if (!runs_ || (now - autosaved_).toSec() < params_.autosave_period) return;
  autosaved_ = now;
  SaveState state;
  state.request.file = params_.save_as + "_autosave.slam";
  try {
    require_success(nodelet_of(mode_).name + "/" + topics::kSaveState, state);
    ros::param::set(file_parameter(mode_), state.request.file);
    unsaved_.clear();
  } catch (const std::runtime_error& error) {
    unsaved_ = std::string("not saved: ") + error.what();
  }
}

void ModeSwitchNodelet::load(VehicleMode mode, const std::string& file) {
  ros::param::set(file_parameter(mode), file);
  manager_->load(nodelet_of(mode));
  mode_ = mode;
  runs_ = true;
  autosaved_ = ros::SteadyTime::now();
  if (mode == VehicleMode::kMapping) getPrivateNodeHandle().setParam(kBeganWith, file);
  getPrivateNodeHandle().setParam("mode", name_of(mode, vehicle_mode_names()));
}

// It takes no pose before its first motion: odometry has then gone on, too.
std::string ModeSwitchNodelet::hand_over(const std::string& map) {
  const std::string name = nodelet_of(VehicleMode::kLocalization).name + "/" + topics::kSetPose;
  handover_->follow();
  const auto when_loaded = handover_->pose_on(map);
  std::string trouble = "odometry stands still";
  const ros::SteadyTime began = ros::SteadyTime::now();
  while ((ros::SteadyTime::now() - began).toSec() < kHandoverPatience) {
    handover_->follow();
    SetPose call;
    const auto pose = handover_->pose_on(map);
    if (!pose || !when_loaded) return "";
    call.request.pose = *pose;
    try {
      if (pose->header.stamp > when_loaded->header.stamp) {
        require_success(name, call);
        return "; " + call.response.message + ", by odometry since it was there last";
      }
    } catch (const std::runtime_error& error) {
      trouble = error.what();
    }
    ros::WallDuration(0.05).sleep();
  }
  return "; searches for its place: " + trouble;
}

std::string ModeSwitchNodelet::change(VehicleMode mode, const SetMode::Request& request) {
  const VehicleMode before = mode_;
  const std::string name = name_of(mode, vehicle_mode_names());
  const auto loaded = manager_->loaded();
  if (!loaded) throw std::runtime_error(manager_->manager() + " does not answer");
  const std::string old = nodelet_of(before).name;
  const bool runs = std::find(loaded->begin(), loaded->end(), old) != loaded->end();
  if (runs && mode == before && request.file.empty()) return "is in mode " + name + " already";
  const std::string file = file_of(mode, request.file);
  require_readable(mode, file);

  const std::string kept = parameter(file_parameter(mode));
  std::string done = "mode " + name;
  std::string old_file = file_of(before, "");
  if (runs) {
    if (before == VehicleMode::kMapping && request.discard_map == 0) {
      const SaveState saved = save_map();
      old_file = saved.request.file;
      done += "; " + saved.response.message;
    }
    manager_->unload(old);
    if (before == VehicleMode::kLocalization) handover_->keep(old_file, pose_, ros::Time::now());
  }
  if (before == VehicleMode::kMapping && mode != before) {
    // The next map is no continuation of what was saved by the way.
    ros::param::set(file_parameter(before),
                    getPrivateNodeHandle().param(kBeganWith, std::string()));
  }
  try {
    load(mode, file);
    if (mode == VehicleMode::kLocalization) done += hand_over(file);
  } catch (const std::runtime_error& error) {
    runs_ = false;
    ros::param::set(file_parameter(mode), kept);
    load(before, old_file);
    throw std::runtime_error(std::string(error.what()) + "; back in mode " +
                             name_of(before, vehicle_mode_names()));
  }
  return done;
}

bool ModeSwitchNodelet::on_set_mode(SetMode::Request& request, SetMode::Response& response) {
  try {
    const auto mode = value_of(request.mode, vehicle_mode_names());
    if (!mode) {
      throw std::runtime_error("mode '" + request.mode + "': must be " +
                               list_names(vehicle_mode_names()));
    }
    response.message = change(*mode, request);
    response.success = true;
    refusal_.clear();
    NODELET_INFO_STREAM(response.message);
  } catch (const std::exception& error) {
    response.message = error.what();
    refusal_ = "not " + request.mode + ": " + error.what();
    refused_ = ros::SteadyTime::now();
    NODELET_ERROR_STREAM("mode not changed: " << error.what());
  }
  publish_mode(runs_ ? name_of(mode_, vehicle_mode_names()) : "none");
  return true;
}

}  // namespace falko_slam
