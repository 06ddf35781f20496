// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where the Localizer nodelet begins, and what it is told by others.
#include <filesystem>
#include <stdexcept>

#include "falko_slam/common/number_text.hpp"
#include "falko_slam/localization/pose_file.hpp"
#include "falko_slam/ros_bridge/localizer_conversion.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"
#include "localizer_nodelet.hpp"

namespace falko_slam {

// The parameters' pose counts before the file's, and without either it is searched for. Who
// switched the vehicle off may have moved it: the file's pose is as sure as a pose that somebody
// sets.
void LocalizerNodelet::begin(Time stamp) {
  begun_ = true;
  const InitialPose& initial = params_.initial_pose;
  const Eigen::Matrix3d covariance =
      pose_covariance(initial.position_deviation, initial.heading_deviation);
  if (initial.known) {
    localizer_->set_pose(stamp,
                         PoseEstimate{Pose2(initial.x, initial.y, initial.theta), covariance});
    NODELET_INFO_STREAM("begins at x " << initial.x << " m, y " << initial.y << " m, heading "
                                       << initial.theta << " rad, as the parameters say");
    return;
  }
  if (params_.pose_file.empty() || !std::filesystem::exists(params_.pose_file)) return;
  try {
    SavedPose saved = read_saved_pose(params_.pose_file);
    const std::string objection =
        objection_to(saved, map_identity_, stamp, from_seconds(params_.pose_max_age));
    if (!objection.empty()) throw std::runtime_error(params_.pose_file + ": " + objection);
    saved.map_T_base.covariance += covariance;
    localizer_->set_pose(stamp, saved.map_T_base);
    NODELET_INFO_STREAM("begins where it was last, at " << saved.map_T_base.pose);
  } catch (const std::exception& error) {
    NODELET_WARN_STREAM("the last pose is not used: " << error.what());
    diagnostics_->note_pose_file(error.what());
  }
}

// What has been told of the way since before the pose changed is not true any more.
void LocalizerNodelet::forget_way() {
  placed_.clear();
  transform_->reset();
}

std::string LocalizerNodelet::take(const geometry_msgs::PoseWithCovarianceStamped& message) {
  if (!newest_)
    throw std::invalid_argument("nothing has come on " + motions_->topic().name + " yet");
  const PoseEstimate pose = from_message(message, params_.map_frame, params_.initial_pose);
  const Time present = now();
  const Time stamp = message.header.stamp.isZero() ? present : from_ros(message.header.stamp);
  const double age = to_seconds(present - stamp);
  const PoseHistoryParams& history = params_.localizer.history;
  if (age > history.span) {
    throw std::invalid_argument("it is " + fixed_text(age, 1) +
                                " s old: the way since then is not known");
  }
  if (-age > history.max_ahead) {
    throw std::invalid_argument("its stamp is " + fixed_text(-age, 1) + " s ahead");
  }
  localizer_->set_pose(stamp, pose);
  begun_ = true;
  forget_way();
  publish_status();
  const Pose2& at = pose.pose;
  return "begins at x " + fixed_text(at.x(), 3) + " m, y " + fixed_text(at.y(), 3) +
         " m, heading " + fixed_text(at.theta(), 4) + " rad";
}

void LocalizerNodelet::on_initial_pose(const geometry_msgs::PoseWithCovarianceStamped& message) {
  try {
    NODELET_INFO_STREAM(take(message));
  } catch (const std::invalid_argument& error) {
    NODELET_ERROR_STREAM("initial pose not taken: " << error.what());
  }
}

bool LocalizerNodelet::on_set_pose(SetPose::Request& request, SetPose::Response& response) {
  try {
    response.message = take(request.pose);
    response.success = true;
    NODELET_INFO_STREAM(response.message);
  } catch (const std::invalid_argument& error) {
    response.message = error.what();
    NODELET_ERROR_STREAM("pose not set: " << error.what());
  }
  return true;
}

bool LocalizerNodelet::on_global_localization(std_srvs::Trigger::Request& /*request*/,
                                              std_srvs::Trigger::Response& response) {
  localizer_->globalize();
  begun_ = true;
  forget_way();
  publish_status();
  response.success = true;
  response.message = "the pose is forgotten and searched for: see the status";
  NODELET_INFO_STREAM(response.message);
  return true;
}

void LocalizerNodelet::save_pose() {
  const LocalizerReport& state = localizer_->state();
  if (params_.pose_file.empty() || !state.map_T_base) return;
  try {
    const std::filesystem::path folder = std::filesystem::path(params_.pose_file).parent_path();
    if (!folder.empty()) std::filesystem::create_directories(folder);
    write_saved_pose(params_.pose_file, {state.stamp, *state.map_T_base, map_identity_});
    diagnostics_->note_pose_file(params_.pose_file);
    diagnostics_->warn_of_pose_file("");
  } catch (const std::exception& error) {
    constexpr double kUnsavedPeriod = 60.0;  // [s]
    NODELET_WARN_STREAM_THROTTLE(kUnsavedPeriod, "the pose is not saved: " << error.what());
    diagnostics_->warn_of_pose_file(std::string("the pose is not saved: ") + error.what());
  }
}

}  // namespace falko_slam
