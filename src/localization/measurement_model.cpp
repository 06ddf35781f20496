// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/measurement_model.hpp"

#include <cmath>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

Eigen::Vector2d turned_left(const Eigen::Vector2d& v) { return {-v.y(), v.x()}; }

}  // namespace

// With J the turn by 90 degrees, dt/dtheta = J R(theta) l = J (t - q) and d(R^T)/dtheta = -R^T J:
//
//   kCartesian     dz/dq = -R^T    dz/dtheta = -R^T J (p - q)                     dz/dp = R^T
//   kRangeBearing  with the rows g = (d_x, d_y) / rho and (-d_y, d_x) / rho^2 of dz/dp:
//                  dz/dq = -dz/dp  dz/dtheta = -dz/dp J (t - q) - (0, 1)
ObservationPrediction predict_observation(ObservationModel model, const Pose2& map_T_base,
                                          const Pose2& base_T_laser,
                                          const Eigen::Vector2d& landmark) {
  const Pose2 map_T_laser = map_T_base * base_T_laser;
  const Eigen::Vector2d d = landmark - map_T_laser.translation();
  ObservationPrediction prediction;
  Eigen::Vector2d dvalue_dtheta;
  if (model == ObservationModel::kCartesian) {
    prediction.dvalue_dlandmark = map_T_laser.rotation().transpose();
    prediction.value = prediction.dvalue_dlandmark * d;
    dvalue_dtheta = -prediction.dvalue_dlandmark * turned_left(landmark - map_T_base.translation());
  } else {
    const double range = d.norm();
    prediction.value << range, wrap_angle(std::atan2(d.y(), d.x()) - map_T_laser.theta());
    prediction.dvalue_dlandmark << d.transpose() / range,
        turned_left(d).transpose() / (range * range);
    const Eigen::Vector2d lever = map_T_laser.translation() - map_T_base.translation();
    dvalue_dtheta = -prediction.dvalue_dlandmark * turned_left(lever) - Eigen::Vector2d::UnitY();
  }
  prediction.dvalue_dpose << -prediction.dvalue_dlandmark, dvalue_dtheta;
  return prediction;
}

Eigen::Vector2d innovation_of(ObservationModel model, const Eigen::Vector2d& observed,
                              const Eigen::Vector2d& predicted) {
  Eigen::Vector2d innovation = observed - predicted;
  if (model == ObservationModel::kRangeBearing) innovation.y() = wrap_angle(innovation.y());
  return innovation;
}

}  // namespace falko_slam
