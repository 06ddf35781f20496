// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/loop_protocol.hpp"

#include <algorithm>
#include <cmath>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {

const char* name_of(LoopProtocol protocol) {
  switch (protocol) {
    case LoopProtocol::kOffline:
      return "offline";
    case LoopProtocol::kOnline:
      return "online";
    case LoopProtocol::kRevisits:
      return "revisits";
    case LoopProtocol::kKidnapped:
      return "kidnapped";
  }
  return "unknown";
}

LoopTruth::LoopTruth(const std::vector<PosedScan>& scans, LoopProtocol protocol,
                     const LoopProtocolParams& params)
    : protocol_(protocol), params_(params), has_loop_(scans.size(), false) {
  for (const PosedScan& scan : scans) {
    const Eigen::Vector2d step =
        poses_.empty()
            ? Eigen::Vector2d(0.0, 0.0)
            : Eigen::Vector2d(scan.map_T_laser.translation() - poses_.back().translation());
    paths_.push_back((paths_.empty() ? 0.0 : paths_.back()) + step.norm());
    poses_.push_back(scan.map_T_laser);
  }
  for (std::size_t source = 0; source < poses_.size(); ++source) {
    for (std::size_t target = 0; target < poses_.size() && !has_loop_[source]; ++target) {
      if (!admits(source, target)) continue;
      const Pose2 difference = poses_[target].inverse() * poses_[source];
      has_loop_[source] = difference.translation().norm() < params_.loop_distance &&
                          std::abs(difference.theta()) < params_.loop_turn;
    }
  }
}

bool LoopTruth::admits(std::size_t source, std::size_t target) const {
  if (protocol_ == LoopProtocol::kOffline) return source != target;
  if (protocol_ == LoopProtocol::kKidnapped) {
    return std::abs(paths_[source] - paths_[target]) >= params_.min_path;
  }
  if (target >= source) return false;
  if (protocol_ == LoopProtocol::kRevisits) {
    return paths_[source] - paths_[target] >= params_.min_path;
  }
  const Pose2& a = poses_[source];
  const Pose2& b = poses_[target];
  return std::abs(a.x() - b.x()) > params_.min_step || std::abs(a.y() - b.y()) > params_.min_step ||
         std::abs(angle_between(a.theta(), b.theta())) > params_.min_turn;
}

bool LoopTruth::is_right(std::size_t source, std::size_t target,
                         const Pose2& target_T_source) const {
  const Pose2 error = (poses_[target] * target_T_source).inverse() * poses_[source];
  return error.translation().norm() < params_.max_error &&
         std::abs(error.theta()) < params_.max_turn_error;
}

std::size_t LoopTruth::loops() const {
  return static_cast<std::size_t>(std::count(has_loop_.begin(), has_loop_.end(), true));
}

LoopOperatingPoint operating_point(const std::vector<LoopAnswer>& answers, double min_score) {
  LoopOperatingPoint point;
  point.min_score = min_score;
  std::size_t loops = 0;
  std::size_t found = 0;
  for (const LoopAnswer& answer : answers) {
    loops += answer.has_loop ? 1U : 0U;
    if (!answer.closed || answer.score < min_score) continue;
    ++point.closures;
    point.wrong += answer.right ? 0U : 1U;
    found += answer.right && answer.has_loop ? 1U : 0U;
  }
  if (point.closures > 0) {
    point.precision =
        static_cast<double>(point.closures - point.wrong) / static_cast<double>(point.closures);
  }
  if (loops > 0) point.recall = static_cast<double>(found) / static_cast<double>(loops);
  return point;
}

std::vector<LoopOperatingPoint> loop_curve(const std::vector<LoopAnswer>& answers) {
  std::vector<double> scores;
  for (const LoopAnswer& answer : answers) {
    if (answer.closed) scores.push_back(answer.score);
  }
  std::sort(scores.begin(), scores.end(), std::greater<>());
  scores.erase(std::unique(scores.begin(), scores.end()), scores.end());
  std::vector<LoopOperatingPoint> curve;
  curve.reserve(scores.size());
  for (const double score : scores) curve.push_back(operating_point(answers, score));
  return curve;
}

LoopSummary summarize(const std::vector<LoopOperatingPoint>& curve) {
  LoopSummary summary;
  for (const LoopOperatingPoint& point : curve) {
    if (point.wrong == 0) summary.recall_at_100 = std::max(summary.recall_at_100, point.recall);
    if (point.precision >= 0.95) {
      summary.recall_at_95 = std::max(summary.recall_at_95, point.recall);
    }
    const double sum = point.precision + point.recall;
    if (sum > 0.0) summary.f1 = std::max(summary.f1, 2.0 * point.precision * point.recall / sum);
    if (summary.break_even == 0.0 && point.recall >= point.precision) {
      summary.break_even = point.recall;
    }
  }
  return summary;
}

}  // namespace falko_slam
