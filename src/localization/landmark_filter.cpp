// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/landmark_filter.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "covariance_check.hpp"
#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "feature_gate.hpp"
#include "seen_feature.hpp"
#include "state_joint_distance.hpp"
#include "tentative_list.hpp"

namespace falko_slam {
namespace {

void require_usable(const PoseEstimate& map_T_base) {
  if (is_usable(map_T_base)) return;
  throw std::invalid_argument(
      "map_T_base: must be finite, with a symmetric positive semidefinite covariance");
}

// A feature of the scan, its number there, and what became of it.
struct Input {
  std::optional<SeenFeature> seen;
  ObservationVerdict verdict = ObservationVerdict::kInvalid;
  std::optional<std::size_t> of_map = {};  // the landmark there
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
  require_in_range("point_wander", params.point_wander, 0.0, 1.0);
  require_in_range("face_wander", params.face_wander, 0.0, 1.0);
  require_in_range("face_turn_wander", params.face_turn_wander, 0.0, 1.0);
  require_in_range("separation", params.separation, 0.0, 10.0);
  validate(params.association);
}

struct LandmarkFilter::State {
  State(const LandmarkFilterParams& p, const PoseEstimate& map_T_base,
        std::shared_ptr<const LandmarkIndex> landmark_map)
      : params(p),
        map(std::move(landmark_map)),
        gate(pair_gate(p.association.gate_probability)),
        state(map_T_base, p.max_landmarks),
        tentative(p.hits, 0.5 * p.separation) {}

  LandmarkFilterParams params;
  std::shared_ptr<const LandmarkIndex> map;  // or null
  double gate;
  LandmarkState state;
  std::vector<FeatureRecord> records;  // one per landmark of the state
  TentativeList tentative;
  std::uint64_t next_number = 1;

  FeatureRecord& record(int landmark) { return records[static_cast<std::size_t>(landmark)]; }
  void remove(int landmark);
  void wander(double way);
  int forget(Time stamp);
  void gate_inputs(std::vector<Input>& inputs, FeaturePairs& pairs) const;
  void correct(Time stamp, std::vector<Input>& inputs, const FeaturePairs& pairs,
               FeatureUpdate& update);
  void place(std::vector<Input>& inputs) const;
  bool stands_near_map(const SeenFeature& seen) const;
  bool stands_near(const SeenFeature& seen) const;
  bool make_room(Time stamp, FeatureUpdate& update);
  void consider(Time stamp, Input& input, FeatureUpdate& update);
};

void LandmarkFilter::State::remove(int landmark) {
  state.remove(landmark);
  record(landmark) = records.back();
  records.pop_back();
}

void LandmarkFilter::State::wander(double way) {
  const auto squared = [](double value) { return value * value; };
  const double point = way * squared(params.point_wander);
  const Eigen::Vector2d face(way * squared(params.face_turn_wander),
                             way * squared(params.face_wander));
  for (int i = 0; i < state.landmarks(); ++i) {
    if (record(i).is_line) {
      state.loosen(i, face);
    } else if (record(i).kind == LandmarkKind::kFeature) {
      state.loosen(i, {point, point});
    }
  }
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

void LandmarkFilter::State::gate_inputs(std::vector<Input>& inputs, FeaturePairs& pairs) const {
  pairs.joint.landmarks = records.size();
  FeatureGate gate_of(state, records, map.get(), params.base_T_laser, gate);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (!inputs[i].seen) continue;
    switch (gate_of.add(i, *inputs[i].seen, pairs)) {
      case FeatureGate::Found::kNone:
        inputs[i].verdict = ObservationVerdict::kNoLandmark;
        break;
      case FeatureGate::Found::kSome:
        inputs[i].verdict = ObservationVerdict::kIncompatible;
        break;
      case FeatureGate::Found::kUnknownId:
        inputs[i].verdict = ObservationVerdict::kUnknownId;
        break;
    }
  }
}

void LandmarkFilter::State::correct(Time stamp, std::vector<Input>& inputs,
                                    const FeaturePairs& pairs, FeatureUpdate& update) {
  StateJointDistance distance(state, pairs.rows, pairs.joint.landmarks);
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
    Input& input = inputs[pair.observation];
    input.verdict = ObservationVerdict::kUsed;
    if (pair.landmark >= records.size()) {
      input.of_map = pairs.of_map[pair.landmark - records.size()];
      continue;
    }
    FeatureRecord& landmark = records[pair.landmark];
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

bool LandmarkFilter::State::stands_near_map(const SeenFeature& seen) const {
  std::vector<std::size_t> near;
  map->find_near(seen.in_map, params.separation, near);
  return std::any_of(near.begin(), near.end(),
                     [&](std::size_t place) { return map->landmarks()[place].kind == seen.kind; });
}

bool LandmarkFilter::State::stands_near(const SeenFeature& seen) const {
  if (map && !seen.is_line && stands_near_map(seen)) return true;
  for (int i = 0; i < state.landmarks(); ++i) {
    const FeatureRecord& other = records[static_cast<std::size_t>(i)];
    if (other.is_line != seen.is_line || other.kind != seen.kind) continue;
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
      {next_number++, seen.is_line, seen.kind, anchor, seen.in_map, seen.line.half_length, stamp});
  input.verdict = ObservationVerdict::kAdded;
}

LandmarkFilter::LandmarkFilter(const LandmarkFilterParams& params, const PoseEstimate& map_T_base,
                               std::shared_ptr<const LandmarkIndex> map) {
  validate(params);
  require_usable(map_T_base);
  state_ = std::make_unique<State>(params, map_T_base, std::move(map));
}
LandmarkFilter::~LandmarkFilter() = default;
LandmarkFilter::LandmarkFilter(const LandmarkFilter& other)
    : state_(std::make_unique<State>(*other.state_)) {}
LandmarkFilter& LandmarkFilter::operator=(const LandmarkFilter& other) {
  if (this != &other) *state_ = *other.state_;
  return *this;
}
LandmarkFilter::LandmarkFilter(LandmarkFilter&&) noexcept = default;
LandmarkFilter& LandmarkFilter::operator=(LandmarkFilter&&) noexcept = default;

bool LandmarkFilter::predict(const PoseEstimate& motion) {
  if (!is_usable(motion) || !is_usable(compose(state_->state.pose(), motion))) return false;
  state_->state.predict(motion);
  state_->wander(motion.pose.translation().norm());
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
  FeaturePairs pairs;
  s.gate_inputs(inputs, pairs);
  s.correct(stamp, inputs, pairs, update);
  s.place(inputs);
  for (Input& input : inputs) {
    if (input.verdict == ObservationVerdict::kNoLandmark) s.consider(stamp, input, update);
  }
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const bool is_point = i < observations.points.size();
    (is_point ? update.points : update.lines).push_back(inputs[i].verdict);
    if (is_point) update.of_map.push_back(inputs[i].of_map);
  }
  return update;
}

void LandmarkFilter::reset(const PoseEstimate& map_T_base) {
  require_usable(map_T_base);
  State& s = *state_;
  s.state = LandmarkState(map_T_base, s.params.max_landmarks);
  s.records.clear();
  s.tentative = TentativeList(s.params.hits, 0.5 * s.params.separation);
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
    landmark.kind = record.kind;
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
