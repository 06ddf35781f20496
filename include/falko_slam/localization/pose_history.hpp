// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "falko_slam/common/time.hpp"
#include "falko_slam/localization/landmark_filter.hpp"

namespace falko_slam {

struct PoseHistoryParams {
  /// How late an input may come. Greater: more memory, and more work for a late one. [0, 60] [s]
  double span = 2.0;
  /// How far observations may be ahead of the last motion. [0, 10] [s]
  double max_ahead = 0.5;
  /// Held at a time, further observations refused. Each keeps the filter's state behind it: the
  /// square of three and twice the landmarks of the state, in numbers. [1, 1000000]
  std::size_t max_inputs = 2000;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const PoseHistoryParams& params);

/// What became of an input.
enum class InputVerdict {
  kInOrder,   ///< the latest one so far
  kLate,      ///< put in its place; what came later was done anew
  kInvalid,   ///< a motion that LandmarkFilter::predict() refuses
  kRepeated,  ///< a motion of a stamp that there was already
  kTooOld,    ///< from before the history: late by more than its span, or the clock was set back
  kTooNew,    ///< observations too far ahead of the last motion
  kTooMany,   ///< the history is full of inputs
};

struct InputReport {
  InputVerdict verdict = InputVerdict::kInOrder;
  std::optional<FeatureUpdate> update;  ///< of observations that were taken
};

/// A LandmarkFilter whose inputs may come late and out of order: it goes back to the state at their
/// stamp and does what came after anew. Once all inputs are there, the result does not depend on
/// the order in which they came, to the last bit (but for updates of the same stamp, which stay in
/// the order in which they came).
///
/// Observations between two motions see the vehicle part of the way: motions are cut at constant
/// velocity, their covariance in proportion. Observations after the last motion see the vehicle
/// where that motion left it, until the next one comes.
///
/// After a clock was set back call restart(), or all inputs are kTooOld until it has caught up.
/// What to do when no motions come is the caller's. Not thread-safe.
class PoseHistory {
 public:
  /// `filter` holds the pose at `stamp`. Throws std::invalid_argument with the field and its value.
  PoseHistory(LandmarkFilter filter, Time stamp, const PoseHistoryParams& params = {});

  /// The motion from the motion before, by stamps, to this one: late ones fill gaps.
  InputVerdict add_motion(Time stamp, const PoseEstimate& motion);

  InputReport add_observations(Time stamp, FeatureObservations observations);

  /// After all inputs so far; at the last motion or at observations in between.
  PoseEstimate map_T_base() const { return filter_.map_T_base(); }
  const LandmarkFilter& filter() const { return filter_; }
  Time stamp() const { return motion_stamp_; }  ///< of the last motion
  std::size_t inputs() const { return inputs_.size(); }

  /// Forgets all inputs; the pose stays and is that of the new stamp. Landmarks of the state stay,
  /// too, unless the clock was set back: it says when they were seen.
  void restart(Time stamp);
  /// The same at another pose, without them. Throws as LandmarkFilter::reset() does.
  void restart(Time stamp, const PoseEstimate& map_T_base);

 private:
  struct Input {
    Time stamp{};
    std::optional<PoseEstimate> motion;  // else observations
    FeatureObservations observations;
    std::optional<LandmarkFilter> after;  // the state behind it
    Time reached{};                       // and its time
  };

  bool is_too_old(Time stamp) const;
  std::size_t place_for(Time stamp, bool motion) const;
  std::size_t motion_before(std::size_t place) const;  // its place + 1, 0: the origin
  std::optional<FeatureUpdate> replay(std::size_t first, std::size_t wanted);
  void advance(std::size_t place);
  void trim();

  PoseHistoryParams params_;
  LandmarkFilter filter_;
  Time origin_stamp_{};
  LandmarkFilter origin_;
  Time motion_stamp_{};
  std::deque<Input> inputs_;  // by stamp, motions before observations
};

/// The share of a motion that takes place between two times of its span, at constant velocity.
PoseEstimate part_of_motion(const PoseEstimate& motion, double share);

}  // namespace falko_slam
