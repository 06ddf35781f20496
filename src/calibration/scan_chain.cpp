// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_chain.hpp"

#include <Eigen/LU>

namespace falko_slam {
namespace {

// One number for a covariance: a turn counts as what it moves at this distance.
double badness(const Eigen::Matrix3d& covariance) {
  constexpr double kLever = 5.0;  // [m]
  return covariance(0, 0) + covariance(1, 1) + kLever * kLever * covariance(2, 2);
}

// What an error of the target's frame does to a pose in it.
Eigen::Matrix3d moved_to(const Pose2& target_T_source, const Eigen::Matrix3d& target_covariance) {
  Eigen::Matrix3d jacobian = Eigen::Matrix3d::Identity();
  jacobian(0, 2) = -target_T_source.y();
  jacobian(1, 2) = target_T_source.x();
  return jacobian * target_covariance * jacobian.transpose();
}

bool determined(const WallRegistration& link, const ScanMotionParams& params) {
  return link.agreement() >= params.min_agreement &&
         link.deviation_without_a_part <= params.max_deviation;
}

ChainEnd longer_by(const ChainEnd& chain, const WallKey& from, const WallRegistration& link,
                   const WallKey& to) {
  const Pose2& from_T_to = link.target_T_source;
  const Eigen::Matrix3d covariance = link.covariance + moved_to(from_T_to, from.bent) + to.bent;
  const auto [dleft, dright] = compose_jacobians(chain.start_T_laser.pose, from_T_to);
  ChainEnd longer;
  longer.start_T_laser = compose(chain.start_T_laser, {from_T_to, covariance});
  longer.lasting = dleft * chain.lasting * dleft.transpose() +
                   dright * link.lasting_covariance * dright.transpose();
  longer.last = link;
  longer.links = chain.links + 1;
  return longer;
}

// With what both ends see alike themselves.
ChainEnd closed(const ChainEnd& chain, const WallKey& first, const WallKey& last,
                const ScanMotionParams& params) {
  const PoseEstimate& known = chain.start_T_laser;
  const auto found = register_walls(first.walls, last.walls, known.pose, known.covariance.inverse(),
                                    params.registration);
  if (!found || found->agreement() < params.min_agreement) return chain;
  ChainEnd both = chain;
  both.start_T_laser = {found->target_T_source, found->covariance};
  return both;
}

}  // namespace

std::optional<WallRegistration> link(const WallKey& from, const WallKey& to,
                                     const ScanMotionParams& params) {
  constexpr double kUnknownDistance = 1.0;  // [m]
  constexpr double kUnknownTurn = 0.3;
  const Eigen::Matrix3d unknown = pose_covariance(kUnknownDistance, kUnknownTurn).inverse();
  auto found = register_walls(from.walls, to.walls, from.start_T_laser.inverse() * to.start_T_laser,
                              unknown, params.registration);
  if (!found || found->parts < params.min_parts) return std::nullopt;
  return found;
}

std::optional<ChainEnd> best_chain(const std::vector<WallKey>& keys,
                                   const ScanMotionParams& params) {
  std::vector<std::optional<ChainEnd>> reached(keys.size());
  reached.front() = ChainEnd();
  for (std::size_t to = 1; to < keys.size(); ++to) {
    for (std::size_t from = 0; from < to; ++from) {
      if (!reached[from]) continue;
      const auto found = link(keys[from], keys[to], params);
      if (!found || !determined(*found, params)) continue;
      const ChainEnd chain = longer_by(*reached[from], keys[from], *found, keys[to]);
      const bool better = !reached[to] || badness(chain.start_T_laser.covariance) <
                                              badness(reached[to]->start_T_laser.covariance);
      if (better) reached[to] = chain;
    }
  }
  const std::optional<ChainEnd>& best = reached.back();
  if (!best || best->links < 2) return best;
  return closed(*best, keys.front(), keys.back(), params);
}

}  // namespace falko_slam
