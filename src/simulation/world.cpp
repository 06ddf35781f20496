// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/simulation/world.hpp"

#include <cmath>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

constexpr double kTurnRate = 1.0;  // where only the heading changes [rad/s]

// The way from one place to the next; at which share of it the thing is.
struct Leg {
  const Pose2& from;
  const Pose2& to;

  double seconds(double speed) const {
    const double way = (to.translation() - from.translation()).norm();
    const double turn = std::abs(angle_between(from.theta(), to.theta()));
    return way > 0.0 ? way / speed : turn / kTurnRate;
  }
  Pose2 at(double share) const {
    const Eigen::Vector2d place =
        from.translation() + share * (to.translation() - from.translation());
    return {place, from.theta() + share * angle_between(from.theta(), to.theta())};
  }
};

class Tour {
 public:
  explicit Tour(const BodyMotion& motion) : motion_(motion) {
    const std::size_t places = motion.through.size();
    legs_ = motion.repeat == BodyMotion::Repeat::kRound ? places : places - 1;
    for (std::size_t i = 0; i < legs_; ++i) seconds_ += leg(i).seconds(motion.speed);
  }

  double seconds() const { return seconds_; }

  // Once through, from 0 to seconds().
  Pose2 at(double seconds) const {
    for (std::size_t i = 0; i < legs_; ++i) {
      const double needed = leg(i).seconds(motion_.speed);
      if (seconds < needed) return leg(i).at(seconds / needed);
      seconds -= needed;
    }
    return legs_ == motion_.through.size() ? motion_.through.front() : motion_.through.back();
  }

 private:
  Leg leg(std::size_t i) const {
    return {motion_.through[i], motion_.through[(i + 1) % motion_.through.size()]};
  }

  const BodyMotion& motion_;
  std::size_t legs_ = 0;
  double seconds_ = 0.0;
};

}  // namespace

void add_box(Shape& shape, const Pose2& world_T_center, const Eigen::Vector2d& size,
             std::size_t surface) {
  const Eigen::Vector2d half = 0.5 * size;
  const Eigen::Vector2d corners[4] = {world_T_center * Eigen::Vector2d(-half.x(), -half.y()),
                                      world_T_center * Eigen::Vector2d(half.x(), -half.y()),
                                      world_T_center * Eigen::Vector2d(half.x(), half.y()),
                                      world_T_center * Eigen::Vector2d(-half.x(), half.y())};
  for (int i = 0; i < 4; ++i) shape.faces.push_back({corners[i], corners[(i + 1) % 4], surface});
}

Pose2 pose_at(const BodyMotion& motion, double seconds) {
  if (motion.through.empty()) return {};
  const Tour tour(motion);
  const double once = tour.seconds();
  if (once <= 0.0 || seconds <= 0.0) return motion.through.front();
  if (motion.repeat == BodyMotion::Repeat::kRound) return tour.at(std::fmod(seconds, once));
  if (motion.repeat == BodyMotion::Repeat::kOnce) return tour.at(seconds);
  const double phase = std::fmod(seconds, 2.0 * once);
  return tour.at(phase < once ? phase : 2.0 * once - phase);
}

}  // namespace falko_slam
