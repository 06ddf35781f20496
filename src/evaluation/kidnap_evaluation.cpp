// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/kidnap_evaluation.hpp"

#include <cmath>
#include <random>
#include <stdexcept>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

// A drive with what is needed to begin anywhere in it.
class PosedDrive {
 public:
  explicit PosedDrive(const SimulatedDrive& drive) : drive_(drive), truth_(drive.truth) {}

  Time begin() const { return drive_.truth.front().stamp; }
  double seconds() const { return to_seconds(drive_.truth.back().stamp - begin()); }
  Pose2 truth(Time time) const { return *truth_.interpolate(time, std::chrono::seconds(1)); }

  // Events of scans that begin after `from`, and of motions that end after it, until `to`.
  template <class Use>
  void play(Time from, Time to, const Use& use) const {
    for (const DriveInputEvent& event : drive_.events) {
      const Time since = event.scan ? event.scan->first_beam_time : event.stamp;
      if (since > from && event.stamp <= to) use(event);
    }
  }

 private:
  const SimulatedDrive& drive_;
  TrajectoryIndex truth_;
};

class KidnapRun {
 public:
  KidnapRun(const PosedDrive& first, const PosedDrive& second, const RightPose& right)
      : first_(first), second_(second), right_(right) {}

  Kidnap run(Localizer& localizer, Time from, Time to, const KidnapParams& params) {
    const Time begin = from - from_seconds(params.before);
    Kidnap result;
    result.from = first_.truth(from);
    result.to = second_.truth(to);
    const PoseEstimate start{first_.truth(begin), pose_covariance(0.02, 0.005)};
    localizer.set_pose(begin, start);
    first_.play(begin, from, [&](const DriveInputEvent& event) { feed(localizer, event, {}); });
    const Duration shift = from - to;
    second_.play(to, to + from_seconds(params.after), [&](const DriveInputEvent& event) {
      const LocalizerReport* report = feed(localizer, event, shift);
      if (report != nullptr) judge(*report, to, shift, result);
    });
    return result;
  }

 private:
  static const LocalizerReport* feed(Localizer& localizer, const DriveInputEvent& event,
                                     Duration shift) {
    if (event.motion) localizer.add_motion(event.stamp + shift, *event.motion);
    if (!event.scan) return nullptr;
    LaserScan scan = *event.scan;
    scan.first_beam_time += shift;
    return &localizer.add_scan(scan);
  }

  void judge(const LocalizerReport& report, Time to, Duration shift, Kidnap& result) const {
    const double seconds = to_seconds(report.seen_at - shift - to);
    const bool right = is_right(report, shift);
    const bool posed = report.map_T_base.has_value();
    if (result.three < 0.0 && report.seen.size() >= 3) result.three = seconds;
    if (result.lost < 0.0 && (!posed || right)) result.lost = seconds;
    if (right && result.pose < 0.0) result.pose = seconds;
    if (right && result.ok < 0.0 && report.status == LocalizationStatus::kOk) result.ok = seconds;
    if (!posed || right) return;
    if (result.lost < 0.0) {
      if (report.status == LocalizationStatus::kOk) result.ok_until = seconds;
      return;
    }
    ++result.wrong_posed;
    if (report.status == LocalizationStatus::kOk) ++result.wrong_ok;
  }

  bool is_right(const LocalizerReport& report, Duration shift) const {
    if (!report.map_T_base) return false;
    const Pose2 truth = second_.truth(report.stamp - shift);
    const Pose2& pose = report.map_T_base->pose;
    return (pose.translation() - truth.translation()).norm() <= right_.position &&
           std::abs(wrap_angle(pose.theta() - truth.theta())) <= right_.heading;
  }

  const PosedDrive& first_;
  const PosedDrive& second_;
  RightPose right_;
};

}  // namespace

void validate(const KidnapParams& params) {
  require_in_range("count", params.count, 1, 100000);
  require_in_range("before", params.before, 0.5, 1000.0);
  require_in_range("after", params.after, 0.5, 1000.0);
  require_in_range("least", params.least, 0.0, 1000.0);
}

std::vector<Kidnap> evaluate_kidnaps(const SimulatedDrive& first, const SimulatedDrive& second,
                                     LocalizerParams params, const LandmarkMap& map,
                                     const KidnapParams& kidnap, const RightPose& right) {
  validate(kidnap);
  const PosedDrive before(first), after(second);
  if (before.seconds() <= kidnap.before + 0.1 || after.seconds() <= kidnap.after + 0.1) {
    throw std::invalid_argument("drives shorter than what comes before and after a kidnap");
  }
  params.base_T_laser = first.base_T_laser;
  std::mt19937_64 random(kidnap.seed);
  std::uniform_real_distribution<double> from(kidnap.before + 0.05, before.seconds() - 0.05);
  std::uniform_real_distribution<double> to(0.05, after.seconds() - kidnap.after - 0.05);
  KidnapRun run(before, after, right);
  std::vector<Kidnap> results;
  for (int tries = 0; results.size() < static_cast<std::size_t>(kidnap.count); ++tries) {
    if (tries > 1000 * kidnap.count) throw std::invalid_argument("least: never so far apart");
    const Time leave = before.begin() + from_seconds(from(random));
    const Time arrive = after.begin() + from_seconds(to(random));
    const Eigen::Vector2d way =
        after.truth(arrive).translation() - before.truth(leave).translation();
    if (way.norm() < kidnap.least) continue;
    Localizer localizer(params, map);
    results.push_back(run.run(localizer, leave, arrive, kidnap));
  }
  return results;
}

}  // namespace falko_slam
