// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/path_evaluation.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/localization/external_map_filter.hpp"
#include "falko_slam/localization/localizer.hpp"
#include "falko_slam/localization/scan_landmarks.hpp"

namespace falko_slam {
namespace {

struct TimedEstimate {
  Time stamp;
  PoseEstimate map_T_base;
};

// One of the methods, fed with a drive.
class PathLocalizer {
 public:
  virtual ~PathLocalizer() = default;
  virtual void add_motion(Time stamp, const PoseEstimate& motion) = 0;
  virtual std::optional<TimedEstimate> add_scan(const LaserScan& scan) = 0;
};

class WholeLocalizer : public PathLocalizer {
 public:
  WholeLocalizer(const LocalizerParams& params, const LandmarkMap& map, const StampedPose& start)
      : localizer_(params, map) {
    localizer_.set_pose(start.stamp, PoseEstimate{start.map_T_base, pose_covariance(0.02, 0.005)});
  }
  void add_motion(Time stamp, const PoseEstimate& motion) override {
    localizer_.add_motion(stamp, motion);
  }
  std::optional<TimedEstimate> add_scan(const LaserScan& scan) override {
    const LocalizerReport& report = localizer_.add_scan(scan);
    if (!report.map_T_base) return std::nullopt;
    return TimedEstimate{report.stamp, *report.map_T_base};
  }

 private:
  Localizer localizer_;
};

// Algorithm 1, or without corners odometry alone wherever there are no reflectors.
class ExternalMapLocalizer : public PathLocalizer {
 public:
  ExternalMapLocalizer(const LocalizerParams& params, const LandmarkMap& map,
                       const StampedPose& start, bool corners)
      : corners_(corners),
        detector_(params, map),
        track_(std::chrono::seconds(5)),
        filter_({{params.base_T_laser, params.association}, 0.1, params.landmarks.max_landmarks},
                landmark_index(map), {start.map_T_base, pose_covariance(0.02, 0.005)}),
        reached_(start.stamp) {
    track_.add(start.stamp, {});
  }
  void add_motion(Time stamp, const PoseEstimate& motion) override { track_.add(stamp, motion); }
  std::optional<TimedEstimate> add_scan(const LaserScan& scan) override {
    const ScanLandmarks landmarks = detector_.detect(scan, track_);
    if (landmarks.instant > reached_) {
      filter_.predict(track_.between(reached_, landmarks.instant));
      reached_ = landmarks.instant;
    }
    std::vector<LandmarkObservation> seen;
    for (const TimedObservation& observation : landmarks.seen) {
      seen.push_back(observation.observation);
    }
    if (corners_) {
      const auto& corners = landmarks.unmapped.points;
      seen.insert(seen.end(), corners.begin(), corners.end());
    }
    filter_.update(seen);
    return TimedEstimate{landmarks.instant, filter_.map_T_base()};
  }

 private:
  bool corners_;
  LandmarkDetector detector_;
  OdometryTrack track_;
  ExternalMapFilter filter_;
  Time reached_;
};

LandmarkMap corners_of(LandmarkMap map) {
  const auto is_reflector = [](const MapLandmark& landmark) {
    return landmark.kind == LandmarkKind::kReflector;
  };
  auto& all = map.landmarks;
  all.erase(std::remove_if(all.begin(), all.end(), is_reflector), all.end());
  return map;
}

std::unique_ptr<PathLocalizer> localizer_of(PathMethod method, LocalizerParams params,
                                            const LandmarkMap& map, const StampedPose& start) {
  if (method != PathMethod::kMap) params.features.unmapped = true;
  if (method == PathMethod::kState) return std::make_unique<WholeLocalizer>(params, map, start);
  if (method == PathMethod::kMap) {
    return std::make_unique<WholeLocalizer>(params, corners_of(map), start);
  }
  const bool corners = method == PathMethod::kExternalMap;
  return std::make_unique<ExternalMapLocalizer>(params, map, start, corners);
}

Eigen::Vector3d error_in_map(const Pose2& estimate, const Pose2& truth) {
  return {estimate.x() - truth.x(), estimate.y() - truth.y(),
          wrap_angle(estimate.theta() - truth.theta())};
}

// Which leg a time belongs to, if to any.
const DriveLeg* leg_at(const SimulatedDrive& drive, Time time) {
  for (const DriveLeg& leg : drive.legs) {
    if (leg.begin < time && time <= leg.end) return &leg;
  }
  return nullptr;
}

class PathTally {
 public:
  explicit PathTally(const SimulatedDrive& drive) : drive_(drive), truth_(drive.truth) {}

  void add(Time scan_end, const std::optional<TimedEstimate>& estimate) {
    const DriveLeg* leg = leg_at(drive_, scan_end);
    if (leg == nullptr) return;
    if (leg != leg_) begin(leg);
    PathRun& run = runs_.back();
    run.arrived = estimate.has_value();
    if (!estimate) return;
    const auto truth = truth_.interpolate(estimate->stamp, std::chrono::seconds(1));
    if (!truth) return;
    way_ += (truth->translation() - last_).norm();
    last_ = truth->translation();
    const Eigen::Vector3d error = error_in_map(estimate->map_T_base.pose, *truth);
    const Eigen::Vector2d in_base = truth->rotation().transpose() * error.head<2>();
    run.errors.push_back({way_, in_base.x(), in_base.y(), error.z()});
    run.nees = error.dot(estimate->map_T_base.covariance.inverse() * error);
  }

  std::vector<PathRun> runs() { return std::move(runs_); }

 private:
  void begin(const DriveLeg* leg) {
    leg_ = leg;
    runs_.push_back({leg->name, {}, false, 0.0});
    way_ = 0.0;
    const auto start = truth_.interpolate(leg->begin, std::chrono::seconds(1));
    last_ = start ? start->translation() : Eigen::Vector2d::Zero();
  }

  const SimulatedDrive& drive_;
  TrajectoryIndex truth_;
  const DriveLeg* leg_ = nullptr;
  std::vector<PathRun> runs_;
  double way_ = 0.0;
  Eigen::Vector2d last_ = Eigen::Vector2d::Zero();
};

}  // namespace

const char* name_of(PathMethod method) {
  switch (method) {
    case PathMethod::kState:
      return "landmarks in the state";
    case PathMethod::kMap:
      return "map of corners";
    case PathMethod::kExternalMap:
      return "Algorithm 1";
    case PathMethod::kOdometry:
      return "odometry";
  }
  return "?";
}

bool is_within(const PathRun& run, const OperationPoint& limits) {
  if (!run.arrived || run.errors.empty()) return false;
  const PathError& error = run.errors.back();
  return std::hypot(error.along, error.across) <= limits.position &&
         std::abs(error.heading) <= limits.heading;
}

std::vector<PathRun> evaluate_paths(const SimulatedDrive& drive, PathMethod method,
                                    LocalizerParams params, const LandmarkMap& map) {
  params.base_T_laser = drive.base_T_laser;
  const auto localizer = localizer_of(method, params, map, drive.truth.front());
  PathTally tally(drive);
  for (const DriveInputEvent& event : drive.events) {
    if (event.motion) localizer->add_motion(event.stamp, *event.motion);
    if (!event.scan) continue;
    const DriveLeg* leg = leg_at(drive, event.stamp);
    LaserScan scan = *event.scan;
    // Without intensities nothing tells a reflector from a thin post.
    if (leg != nullptr && event.stamp > leg->reflectors_until) scan.intensities.clear();
    tally.add(event.stamp, localizer->add_scan(scan));
  }
  return tally.runs();
}

}  // namespace falko_slam
