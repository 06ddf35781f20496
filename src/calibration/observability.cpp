// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/observability.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "falko_slam/common/validation.hpp"

namespace falko_slam {
namespace {

using Parameter = CalibrationParameter;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Of the columns (n sin, n cos) of A_psi.
class SteeringColumns {
 public:
  explicit SteeringColumns(std::string name) : name_(std::move(name)) {}

  void add(const PathSegment& segment) {
    const Eigen::Vector2d row(segment.ticks * std::sin(segment.steering),
                              segment.ticks * std::cos(segment.steering));
    M_ += row * row.transpose();
    (segment.steering > 0.0 ? left_ : right_) |= segment.steering != 0.0;
  }

  double condition() const {
    const double half_trace = 0.5 * M_.trace();
    const double spread = std::hypot(0.5 * (M_(0, 0) - M_(1, 1)), M_(0, 1));
    const double smallest = half_trace - spread;
    // Rounding leaves this much of an eigenvalue that is zero.
    if (!(smallest > 1e-14 * half_trace)) return kInfinity;
    return std::sqrt((half_trace + spread) / smallest);
  }

  std::string missing_side() const {
    if (left_ == right_) return left_ ? "" : "left and right";
    return left_ ? "right" : "left";
  }

  std::string remedy() const {
    const std::string side = missing_side();
    if (!side.empty()) return "drive " + name_ + "arcs to the " + side;
    const bool flat = M_(0, 0) < M_(1, 1);
    return "drive " + name_ + "arcs with " + (flat ? "more" : "less") +
           " steering, near 45 degrees, on both sides";
  }

  const std::string& name() const { return name_; }

 private:
  std::string name_;  // "forward ", empty for all
  Eigen::Matrix2d M_ = Eigen::Matrix2d::Zero();
  bool left_ = false, right_ = false;
};

class Checker {
 public:
  explicit Checker(const ObservabilityParams& params) : params_(params) {}

  double check_steering(const SteeringColumns& columns, const std::vector<Parameter>& affected) {
    const double condition = columns.condition();
    const std::string arcs = "the " + columns.name() + "arcs ";
    if (!columns.missing_side().empty()) {
      remark(CalibrationVerdict::kUnobservable, affected,
             arcs + "leave out " + columns.missing_side(), columns.remedy());
    } else {
      judge(condition, affected, arcs + "are steered too much alike", columns.remedy());
    }
    return condition;
  }

  double check_laser(const std::vector<PathSegment>& segments) {
    double m_1 = 0.0, m_2 = 0.0, m_3 = 0.0, m_4 = 0.0;  // (2.33) to (2.36)
    for (const PathSegment& segment : segments) {
      const Eigen::Vector2d& s = segment.start_T_end.pose.translation();
      const double sine = std::sin(segment.turn), versine = 1.0 - std::cos(segment.turn);
      m_1 += 2.0 * versine;
      m_2 += s.x() * versine - s.y() * sine;
      m_3 += s.x() * sine + s.y() * versine;
      m_4 += s.squaredNorm();
    }
    const double product = std::sqrt(m_1 * m_4);
    const double rho = product > 0.0 ? std::hypot(m_2, m_3) / product : 1.0;
    const double arm = std::sqrt(static_cast<double>(segments.size()) / m_1);
    const double condition =
        rho < 1.0 - 1e-14 ? std::sqrt((1.0 + rho) / (1.0 - rho)) * std::max(1.0, arm) : kInfinity;
    judge(condition, {Parameter::kLaserX, Parameter::kLaserY, Parameter::kLaserTheta},
          arm > params_.weak_condition ? "the drives hardly turn"
                                       : "the arcs have nearly one centre of rotation",
          "drive arcs of a half turn with other steering, on both sides");
    return condition;
  }

  ObservabilityReport report;

 private:
  void judge(double condition, const std::vector<Parameter>& affected, const std::string& what,
             const std::string& remedy) {
    if (condition <= params_.weak_condition) return;
    std::ostringstream reason;
    reason << what << " (condition number " << condition << ")";
    remark(condition > params_.unobservable_condition ? CalibrationVerdict::kUnobservable
                                                      : CalibrationVerdict::kWeak,
           affected, reason.str(), remedy);
  }

  void remark(CalibrationVerdict verdict, const std::vector<Parameter>& affected,
              const std::string& reason, const std::string& remedy) {
    report.verdict = std::max(report.verdict, verdict);
    report.remarks.push_back({verdict, affected, reason, remedy});
  }

  const ObservabilityParams& params_;
};

}  // namespace

const char* name_of(CalibrationVerdict verdict) {
  switch (verdict) {
    case CalibrationVerdict::kOk:
      return "OK";
    case CalibrationVerdict::kWeak:
      return "WEAK";
    case CalibrationVerdict::kUnobservable:
      return "UNOBSERVABLE";
    case CalibrationVerdict::kContradictory:
      return "CONTRADICTORY";
  }
  return "?";
}

void validate(const ObservabilityParams& params) {
  require_in_range("weak_condition", params.weak_condition, 1.0, 1e6);
  require_in_range("unobservable_condition", params.unobservable_condition, 1.0, 1e9);
}

ObservabilityReport check_observability(const std::vector<PathSegment>& segments,
                                        TricycleModel model, const ObservabilityParams& params) {
  validate(params);
  Checker checker(params);
  const bool standard = model == TricycleModel::kStandard;
  SteeringColumns forward(standard ? "" : "forward "), backward("backward ");
  for (const PathSegment& segment : segments) {
    (standard || segment.ticks > 0.0 ? forward : backward).add(segment);
  }
  if (standard) {
    checker.report.forward_condition = checker.report.backward_condition = checker.check_steering(
        forward, {Parameter::kSteerOffsetForward, Parameter::kSteerOffsetBackward,
                  Parameter::kDrivingScale});
  } else {
    checker.report.forward_condition =
        checker.check_steering(forward, {Parameter::kSteerOffsetForward, Parameter::kDrivingScale});
    checker.report.backward_condition = checker.check_steering(
        backward, {Parameter::kSteerOffsetBackward, Parameter::kDrivingScale});
  }
  checker.report.laser_condition = checker.check_laser(segments);
  return checker.report;
}

}  // namespace falko_slam
