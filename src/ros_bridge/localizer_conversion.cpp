// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/localizer_conversion.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "falko_slam/localization/line_model.hpp"
#include "falko_slam/ros_bridge/laser_pose.hpp"
#include "falko_slam/ros_bridge/pose_conversion.hpp"

namespace falko_slam {
namespace {

std::uint8_t level_of(LocalizationStatus status) {
  switch (status) {
    case LocalizationStatus::kOk:
      return LocalizerStatus::OK;
    case LocalizationStatus::kDegraded:
      return LocalizerStatus::DEGRADED;
    case LocalizationStatus::kRecovering:
      return LocalizerStatus::RECOVERING;
    case LocalizationStatus::kLost:
      break;
  }
  return LocalizerStatus::LOST;
}

// Numbers of the message do not change when the core's list of reasons does.
std::uint8_t code_of(LocalizationReason reason) {
  using Reason = LocalizationReason;
  switch (reason) {
    case Reason::kNoPose:
      return LocalizerStatus::NO_POSE;
    case Reason::kContradicted:
      return LocalizerStatus::CONTRADICTED;
    case Reason::kTooUncertain:
      return LocalizerStatus::TOO_UNCERTAIN;
    case Reason::kNoSensors:
      return LocalizerStatus::NO_SENSORS;
    case Reason::kCarried:
      return LocalizerStatus::CARRIED;
    case Reason::kSearching:
      return LocalizerStatus::SEARCHING;
    case Reason::kAmbiguous:
      return LocalizerStatus::AMBIGUOUS;
    case Reason::kConfirming:
      return LocalizerStatus::CONFIRMING;
    case Reason::kClockSetBack:
      return LocalizerStatus::CLOCK_SET_BACK;
    case Reason::kNoMotions:
      return LocalizerStatus::NO_MOTIONS;
    case Reason::kOdometryDisagrees:
      return LocalizerStatus::ODOMETRY_DISAGREES;
    case Reason::kNoScans:
      return LocalizerStatus::NO_SCANS;
    case Reason::kUnconfirmed:
      return LocalizerStatus::UNCONFIRMED;
    case Reason::kMisfit:
      return LocalizerStatus::MISFIT;
    case Reason::kMapDisagrees:
      return LocalizerStatus::MAP_DISAGREES;
    case Reason::kFewLandmarks:
      return LocalizerStatus::FEW_LANDMARKS;
    case Reason::kUncertain:
      return LocalizerStatus::UNCERTAIN;
    case Reason::kNone:
      break;
  }
  return LocalizerStatus::NONE;
}

std::uint8_t kind_of(LandmarkKind kind) {
  return kind == LandmarkKind::kReflector ? LandmarkEstimate::REFLECTOR : LandmarkEstimate::FEATURE;
}

void place(LandmarkEstimate& message, const Eigen::Vector2d& position,
           const Eigen::Matrix2d& covariance) {
  message.position.x = position.x();
  message.position.y = position.y();
  message.covariance = {covariance(0, 0), covariance(0, 1), covariance(1, 1)};
}

LandmarkEstimate to_message(const MapLandmark& landmark) {
  LandmarkEstimate message;
  message.kind = kind_of(landmark.kind);
  message.source = LandmarkEstimate::MAP;
  message.id = static_cast<std::uint64_t>(landmark.id);
  message.name = landmark.name;
  place(message, landmark.position, landmark.covariance);
  return message;
}

// With s the way along the face from the foot of its anchor to its middle, its place across is
// offset + s angle there: a turn to the left leads it to the left.
void place_face(LandmarkEstimate& message, const ActiveLandmark& face) {
  const Eigen::Vector2d along = direction_of(face.line);
  const Eigen::Vector2d middle = nearest_point(face.line, face.middle);
  Eigen::Matrix2d J = Eigen::Matrix2d::Identity();
  J(1, 0) = along.dot(middle - face.line.anchor);
  place(message, middle, J * face.covariance * J.transpose());
  message.kind = LandmarkEstimate::FACE;
  message.direction = std::atan2(along.y(), along.x());
  message.half_length = face.half_length;
}

LandmarkEstimate to_message(const ActiveLandmark& landmark) {
  LandmarkEstimate message;
  message.source = LandmarkEstimate::STATE;
  message.id = landmark.number;
  if (landmark.is_line) {
    place_face(message, landmark);
  } else {
    message.kind = kind_of(landmark.kind);
    place(message, landmark.middle, landmark.covariance);
  }
  return message;
}

Eigen::Matrix3d planar_covariance(const geometry_msgs::PoseWithCovariance& message) {
  constexpr std::size_t kSixth[] = {0, 1, 5};  // x, y and the rotation about z of six
  Eigen::Matrix3d covariance;
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = 0; j < 3; ++j) {
      covariance(i, j) = message.covariance[6 * kSixth[i] + kSixth[j]];
    }
  }
  return covariance;
}

void require_covariance(const Eigen::Matrix3d& covariance) {
  if (!covariance.allFinite()) throw std::invalid_argument("its covariance is not finite");
  const Eigen::Matrix3d turned = covariance.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(0.5 * (covariance + turned),
                                                              Eigen::EigenvaluesOnly);
  const double size = covariance.diagonal().cwiseAbs().maxCoeff();
  const bool even = (covariance - turned).cwiseAbs().maxCoeff() <= 1e-9 * size;
  if (!even || solver.eigenvalues()(0) < -1e-9 * size) {
    throw std::invalid_argument("its covariance is not symmetric and positive semidefinite");
  }
}

}  // namespace

LocalizerStatus to_message(const LocalizerReport& report, const std::string& map_frame) {
  LocalizerStatus message;
  message.header = header_of(report.stamp, map_frame);
  message.level = level_of(report.status);
  message.reason = code_of(report.reason);
  message.text = describe(report.reason);
  message.along_deviation = message.across_deviation = message.heading_deviation = -1.0;
  if (report.map_T_base) {
    const Eigen::Vector3d deviations = deviations_of(*report.map_T_base);
    message.along_deviation = deviations(0);
    message.across_deviation = deviations(1);
    message.heading_deviation = deviations(2);
  }
  message.observed = static_cast<std::uint32_t>(report.seen.size());
  message.used = static_cast<std::uint32_t>(report.agreement.used);
  message.used_of_state = static_cast<std::uint32_t>(report.agreement.in_state);
  message.strangers = static_cast<std::uint32_t>(report.agreement.strangers);
  message.expected = static_cast<std::uint32_t>(report.agreement.expected);
  message.missed = static_cast<std::uint32_t>(report.agreement.missed);
  message.nis = report.agreement.nis;
  message.degrees_of_freedom = static_cast<std::uint32_t>(report.agreement.degrees_of_freedom);
  message.evidence = report.evidence;
  message.hypotheses = static_cast<std::uint32_t>(report.hypotheses);
  return message;
}

LandmarkArray landmarks_in_use(const LocalizerReport& report, const LandmarkMap& map,
                               const std::vector<ActiveLandmark>& in_state,
                               const std::string& map_frame) {
  LandmarkArray message;
  message.header = header_of(report.seen_at, map_frame);
  std::set<std::uint32_t> ids;
  for (const SeenLandmark& seen : report.seen) {
    if (seen.id) ids.insert(*seen.id);
  }
  for (const MapLandmark& landmark : map.landmarks) {
    if (ids.count(static_cast<std::uint32_t>(landmark.id)) > 0) {
      message.landmarks.push_back(to_message(landmark));
    }
  }
  for (const ActiveLandmark& landmark : in_state) message.landmarks.push_back(to_message(landmark));
  return message;
}

geometry_msgs::PoseWithCovarianceStamped pose_message(const PoseEstimate& map_T_base, Time stamp,
                                                      const std::string& map_frame) {
  geometry_msgs::PoseWithCovarianceStamped message;
  message.header = header_of(stamp, map_frame);
  message.pose = to_message(map_T_base);
  return message;
}

PoseEstimate from_message(const geometry_msgs::PoseWithCovarianceStamped& message,
                          const std::string& map_frame, const InitialPose& initial) {
  const std::string frame = tf_frame(message.header.frame_id);
  if (!frame.empty() && frame != map_frame) {
    throw std::invalid_argument("it is in the frame " + frame + ", not " + map_frame);
  }
  const auto& q = message.pose.pose.orientation;
  const double length = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  if (!(std::abs(length - 1.0) < 1e-3)) {
    throw std::invalid_argument("its orientation is not a quaternion of length 1");
  }
  const Pose2 pose = in_plane(message.pose.pose);
  if (!pose.translation().allFinite()) throw std::invalid_argument("its position is not finite");
  Eigen::Matrix3d covariance = planar_covariance(message.pose);
  require_covariance(covariance);
  if (covariance.isZero(0.0)) {
    covariance = pose_covariance(initial.position_deviation, initial.heading_deviation);
  }
  return {pose, 0.5 * (covariance + covariance.transpose())};
}

std::vector<LandmarkObservation> reflector_observations(const ReflectorArray& message,
                                                        const BaseVelocity& velocity,
                                                        const Pose2& base_T_laser,
                                                        const ReflectorDetectorParams& noise) {
  std::vector<LandmarkObservation> observations;
  for (const Reflector& reflector : message.reflectors) {
    const double seconds = reflector.time_offset.toSec();
    const Pose2 moved = Pose2::exp({seconds * velocity.forward, 0.0, seconds * velocity.turn_rate});
    const Eigen::Vector2d point = base_T_laser.inverse() * moved * base_T_laser *
                                  Eigen::Vector2d(reflector.position.x, reflector.position.y);
    const double hits = std::max<double>(1.0, reflector.hit_count);
    const double along =
        noise.range_noise * noise.range_noise / hits + noise.range_bias * noise.range_bias;
    LandmarkObservation observation;
    observation.model = ObservationModel::kRangeBearing;
    observation.value = {point.norm(), std::atan2(point.y(), point.x())};
    observation.covariance =
        Eigen::Vector2d(along, noise.bearing_noise * noise.bearing_noise).asDiagonal();
    if (is_usable(observation)) observations.push_back(observation);
  }
  return observations;
}

Eigen::Vector3d deviations_of(const PoseEstimate& map_T_base) {
  const Eigen::Matrix2d base_R_map = map_T_base.pose.rotation().transpose();
  const Eigen::Matrix2d in_base =
      base_R_map * map_T_base.covariance.topLeftCorner<2, 2>() * base_R_map.transpose();
  return Eigen::Vector3d(in_base(0, 0), in_base(1, 1), map_T_base.covariance(2, 2))
      .cwiseMax(0.0)
      .cwiseSqrt();
}

}  // namespace falko_slam
