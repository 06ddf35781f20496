// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/pose_graph/pose_graph.hpp"

namespace falko_slam {

/// The whitened residual A e of a constraint, A^T A = information, and its derivatives by the
/// coordinates (x, y, theta) of both nodes. With phi = theta_i + theta_z and d = t_j - t_i
///
///     e          = (R(phi)^T d - R_z^T t_z, wrap(theta_j - theta_i - theta_z))
///     de/d(t_i)  = (-R(phi)^T, 0)      de/dtheta_i = (R'(phi)^T d, -1)
///     de/d(t_j)  = ( R(phi)^T, 0)      de/dtheta_j = (0, 1)
struct RelativePoseFactor {
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  struct Linearization {
    Eigen::Vector3d residual;
    RowMajor dfrom, dto;
  };

  explicit RelativePoseFactor(const GraphConstraint& constraint)
      : whitening(square_root_of_information(constraint.information)),
        translation_seen_from_to(constraint.from_T_to.rotation().transpose() *
                                 constraint.from_T_to.translation()),
        turn(constraint.from_T_to.theta()) {}

  Eigen::Vector3d residual(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    const double cosine = std::cos(from.z() + turn), sine = std::sin(from.z() + turn);
    return whitening * plain_residual(cosine, sine, from, to);
  }

  Linearization linearize(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    const double cosine = std::cos(from.z() + turn), sine = std::sin(from.z() + turn);
    const double dx = to.x() - from.x(), dy = to.y() - from.y();
    RowMajor plain_dfrom, plain_dto;
    plain_dfrom << -cosine, -sine, -sine * dx + cosine * dy,  //
        sine, -cosine, -cosine * dx - sine * dy,              //
        0.0, 0.0, -1.0;
    plain_dto << cosine, sine, 0.0,  //
        -sine, cosine, 0.0,          //
        0.0, 0.0, 1.0;
    return {whitening * plain_residual(cosine, sine, from, to), whitening * plain_dfrom,
            whitening * plain_dto};
  }

  Eigen::Matrix3d whitening;
  Eigen::Vector2d translation_seen_from_to;  ///< R_z^T t_z
  double turn;                               ///< theta_z

 private:
  Eigen::Vector3d plain_residual(double cosine, double sine, const Eigen::Vector3d& from,
                                 const Eigen::Vector3d& to) const {
    const double dx = to.x() - from.x(), dy = to.y() - from.y();
    return {cosine * dx + sine * dy - translation_seen_from_to.x(),
            -sine * dx + cosine * dy - translation_seen_from_to.y(),
            wrap_angle(to.z() - from.z() - turn)};
  }
};

}  // namespace falko_slam
