// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/landmark_filter.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "covariance_check.hpp"
#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "seen_feature.hpp"
#include "state_joint_distance.hpp"
#include "tentative_list.hpp"

namespace falko_slam {
namespace {

bool is_finite(const Pose2& pose) {
  return pose.translation().allFinite() && std::isfinite(pose.theta());
}

bool is_usable(const PoseEstimate& estimate) {
  return is_finite(estimate.pose) && is_positive_semidefinite<3>(estimate.covariance);
}

double greatest_deviation(const Eigen::Matrix2d& covariance) {
  return std::sqrt(covariance.trace());  // or a little more
}

// A feature of the scan, its number there, and what became of it.
struct Input {
  std::optional<SeenFeature> seen;
  ObservationVerdict verdict = ObservationVerdict::kInvalid;
};

struct Pairs {
  std::vector<LandmarkState::Row> rows;
  JointPairs joint;
};

}  // namespace

void validate(const LandmarkFilterParams& params) {
  if (!is_finite(params.base_T_laser)) {
    std::ostringstream text;
    text << "base_T_laser = " << params.base_T_laser << ": must be finite";
    throw std::invalid_argument(text.str());
  }
  require_in_range("max_landmarks", params.max_landmarks, 1, 500);
  require_in_range("hits", params.hits, 1, 100);
  require_in_range("forget_after", params.forget_after, 0.01, 1000.0);
  require_in_range("give_up_after", params.give_up_after, 0.01, 1000.0);
  require_in_range("separation", params.separation, 0.0, 10.0);
  validate(params.association);
}

struct LandmarkFilter::State {
  State(const LandmarkFilterParams& p, const PoseEstimate& map_T_base)
      : params(p),
        gate(pair_gate(p.association.gate_probability)),
        state(map_T_base, p.max_landmarks),
        tentative(p.hits, 0.5 * p.separation) {}

  LandmarkFilterParams params;
  double gate;
  LandmarkState state;
  std::vector<FeatureRecord> records;  // one per landmark of the state
  TentativeList tentative;
  std::uint64_t next_number = 1;

  FeatureRecord& record(int landmark) { return records[static_cast<std::size_t>(landmark)]; }
  void remove(int landmark);
  int forget(Time stamp);
  bool may_be(const FeatureRecord& candidate, const Eigen::Vector2d& mean, double reach,
              const SeenFeature& seen) const;
  void gate_input(std::size_t number, Input& input, Pairs& pairs);
  void correct(Time stamp, std::vector<Input>& inputs, const Pairs& pairs, FeatureUpdate& update);
  void place(std::vector<Input>& inputs) const;
  bool stands_near(const SeenFeature& seen) const;
  bool make_room(Time stamp, FeatureUpdate& update);
  void consider(Time stamp, Input& input, FeatureUpdate& update);
};

void LandmarkFilter::State::remove(int landmark) {
  state.remove(landmark);
  record(landmark) = records.back();
  records.pop_back();
}

int LandmarkFilter::State::forget(Time stamp) {
  int dropped = 0;
  for (int i = state.landmarks() - 1; i >= 0; --i) {
    if (stamp - record(i).last_seen <= from_seconds(params.forget_after)) continue;
    remove(i);
    ++dropped;
  }
  tentative.forget(stamp, from_seconds(params.give_up_after));
  return dropped;
}

// A cheap look before the gate itself.
bool LandmarkFilter::State::may_be(const FeatureRecord& candidate, const Eigen::Vector2d& mean,
                                   double reach, const SeenFeature& seen) const {
  if (candidate.is_line != seen.is_line) return false;
  if (!seen.is_line) return (mean - seen.in_map).squaredNorm() <= reach * reach;
  return overlap(mean.x(), candidate.middle, 0.5 * candidate.half_length, seen.in_map,
                 0.5 * seen.line.half_length + reach);
}

// The deviation of an innovation is at most the sum of those of pose, landmark and observation.
void LandmarkFilter::State::gate_input(std::size_t number, Input& input, Pairs& pairs) {
  if (!input.seen) return;
  const SeenFeature& seen = *input.seen;
  const PoseEstimate estimate = state.pose();
  const double way = (seen.in_map - estimate.pose.translation()).norm();
  const double heading = std::sqrt(estimate.covariance(2, 2));
  const double own = greatest_deviation(estimate.covariance.topLeftCorner<2, 2>()) + heading * way +
                     (seen.is_line ? 0.0 : greatest_deviation(seen.line.covariance));
  const double share = std::max(0.1, 1.0 - std::sqrt(gate) * heading);
  input.verdict = ObservationVerdict::kNoLandmark;
  for (int i = 0; i < state.landmarks(); ++i) {
    const Eigen::Vector2d mean = state.mean_of(i);
    const double theirs = record(i).is_line ? 0.0 : greatest_deviation(state.covariance_of(i));
    if (!may_be(record(i), mean, std::sqrt(gate) * (own + theirs) / share, seen)) continue;
    LandmarkState::Row row = row_of(estimate.pose, params.base_T_laser, record(i), mean, seen);
    row.landmark = i;
    const Eigen::Matrix2d S = state.innovation_covariance(row);
    const double distance = row.innovation.dot(S.inverse() * row.innovation);
    if (!(distance <= gate)) continue;
    pairs.rows.push_back(row);
    pairs.joint.pairs.push_back({number, static_cast<std::size_t>(i), distance});
    input.verdict = ObservationVerdict::kIncompatible;
  }
}

void LandmarkFilter::State::correct(Time stamp, std::vector<Input>& inputs, const Pairs& pairs,
                                    FeatureUpdate& update) {
  StateJointDistance distance(state, pairs.rows);
  const AssociationParams& association = params.association;
  const JointSelection selection = search_jointly(
      pairs.joint, distance,
      {association.joint_probability, gate, association.ambiguity, association.max_nodes});
  update.proven = selection.proven;
  for (const std::size_t input : selection.ambiguous) {
    inputs[input].verdict = ObservationVerdict::kAmbiguous;
  }
  std::vector<LandmarkState::Row> rows;
  for (const std::size_t place : selection.pairs) rows.push_back(pairs.rows[place]);
  if (rows.empty()) return;
  const double nis = state.correct(rows);
  if (nis < 0.0) return;
  update.nis = nis;
  update.degrees_of_freedom = 2 * static_cast<int>(rows.size());
  const Pose2 map_T_laser = state.pose().pose * params.base_T_laser;
  for (const std::size_t place : selection.pairs) {
    const JointPairs::Pair& pair = pairs.joint.pairs[place];
    FeatureRecord& landmark = records[pair.landmark];
    Input& input = inputs[pair.observation];
    input.verdict = ObservationVerdict::kUsed;
    landmark.last_seen = stamp;
    landmark.middle = map_T_laser * input.seen->line.middle;
    landmark.half_length = input.seen->line.half_length;
  }
}

void LandmarkFilter::State::place(std::vector<Input>& inputs) const {
  const Pose2 map_T_laser = state.pose().pose * params.base_T_laser;
  for (Input& input : inputs) {
    if (input.seen) input.seen->in_map = map_T_laser * input.seen->line.middle;
  }
}

bool LandmarkFilter::State::stands_near(const SeenFeature& seen) const {
  for (int i = 0; i < state.landmarks(); ++i) {
    const FeatureRecord& other = records[static_cast<std::size_t>(i)];
    if (other.is_line != seen.is_line) continue;
    const Eigen::Vector2d mean = state.mean_of(i);
    if (!seen.is_line) {
      if ((mean - seen.in_map).norm() < params.separation) return true;
      continue;
    }
    const Eigen::Vector2d normal(std::cos(mean.x()), std::sin(mean.x()));
    const double across = normal.dot(seen.in_map - other.anchor) - mean.y();
    if (std::abs(across) < params.separation &&
        overlap(mean.x(), other.middle, 0.5 * other.half_length, seen.in_map,
                0.5 * seen.line.half_length)) {
      return true;
    }
  }
  return false;
}

// Where the state is full, the landmark goes that was out of sight for longest.
bool LandmarkFilter::State::make_room(Time stamp, FeatureUpdate& update) {
  if (state.landmarks() < state.most()) return true;
  const auto oldest = std::min_element(
      records.begin(), records.end(),
      [](const FeatureRecord& a, const FeatureRecord& b) { return a.last_seen < b.last_seen; });
  if (oldest->last_seen >= stamp) return false;
  remove(static_cast<int>(oldest - records.begin()));
  ++update.dropped;
  return true;
}

void LandmarkFilter::State::consider(Time stamp, Input& input, FeatureUpdate& update) {
  const SeenFeature& seen = *input.seen;
  if (stands_near(seen)) {
    input.verdict = ObservationVerdict::kTooNear;
    return;
  }
  const PoseEstimate estimate = state.pose();
  const double angle =
      wrap_angle(seen.line.value.x() + (estimate.pose * params.base_T_laser).theta());
  input.verdict = ObservationVerdict::kTentative;
  if (!tentative.note(seen, angle, stamp) || !make_room(stamp, update)) return;
  const BornLandmark landmark = born(estimate.pose, params.base_T_laser, seen);
  state.add(landmark.mean, landmark.dlandmark_dpose, landmark.noise);
  const Eigen::Vector2d anchor = (estimate.pose * params.base_T_laser).translation();
  records.push_back(
      {next_number++, seen.is_line, anchor, seen.in_map, seen.line.half_length, stamp});
  input.verdict = ObservationVerdict::kAdded;
}

LandmarkFilter::LandmarkFilter(const LandmarkFilterParams& params, const PoseEstimate& map_T_base) {
  validate(params);
  if (!is_usable(map_T_base)) {
    throw std::invalid_argument(
        "map_T_base: must be finite, with a symmetric positive semidefinite covariance");
  }
  state_ = std::make_unique<State>(params, map_T_base);
}
LandmarkFilter::~LandmarkFilter() = default;
LandmarkFilter::LandmarkFilter(LandmarkFilter&&) noexcept = default;
LandmarkFilter& LandmarkFilter::operator=(LandmarkFilter&&) noexcept = default;

bool LandmarkFilter::predict(const PoseEstimate& motion) {
  if (!is_usable(motion) || !is_usable(compose(state_->state.pose(), motion))) return false;
  state_->state.predict(motion);
  return true;
}

FeatureUpdate LandmarkFilter::update(Time stamp, const FeatureObservations& observations) {
  FeatureUpdate update;
  State& s = *state_;
  update.dropped = s.forget(stamp);
  std::vector<Input> inputs;
  for (const auto& point : observations.points) inputs.push_back({seen_point(point)});
  for (const auto& line : observations.lines) inputs.push_back({seen_line(line)});
  s.place(inputs);
  Pairs pairs;
  pairs.joint.landmarks = s.records.size();
  for (std::size_t i = 0; i < inputs.size(); ++i) s.gate_input(i, inputs[i], pairs);
  s.correct(stamp, inputs, pairs, update);
  s.place(inputs);
  for (Input& input : inputs) {
    if (input.verdict == ObservationVerdict::kNoLandmark) s.consider(stamp, input, update);
  }
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    auto& verdicts = i < observations.points.size() ? update.points : update.lines;
    verdicts.push_back(inputs[i].verdict);
  }
  return update;
}

PoseEstimate LandmarkFilter::map_T_base() const { return state_->state.pose(); }

std::vector<ActiveLandmark> LandmarkFilter::landmarks() const {
  std::vector<ActiveLandmark> result;
  for (int i = 0; i < state_->state.landmarks(); ++i) {
    const FeatureRecord& record = state_->record(i);
    const Eigen::Vector2d mean = state_->state.mean_of(i);
    ActiveLandmark landmark;
    landmark.number = record.number;
    landmark.is_line = record.is_line;
    if (record.is_line) landmark.line = {wrap_angle(mean.x()), mean.y(), record.anchor};
    landmark.middle = record.is_line ? record.middle : mean;
    landmark.covariance = state_->state.covariance_of(i);
    landmark.half_length = record.half_length;
    landmark.last_seen = record.last_seen;
    result.push_back(landmark);
  }
  return result;
}

Eigen::MatrixXd LandmarkFilter::covariance() const { return state_->state.covariance(); }

}  // namespace falko_slam
