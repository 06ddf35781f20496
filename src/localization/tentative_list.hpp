// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "seen_feature.hpp"

namespace falko_slam {

/// Features that are no landmarks yet: seen less often than it takes.
class TentativeList {
 public:
  /// `reach`: how far from where it was a feature may be found again [m].
  TentativeList(int hits, double reach) : hits_(hits), reach_(reach) {}

  /// Whether the feature has now been seen often enough; it then leaves the list. `angle`: of a
  /// line's normal in map.
  bool note(const SeenFeature& seen, double angle, Time stamp);

  void forget(Time stamp, Duration after);

  std::size_t size() const { return features_.size(); }

 private:
  struct Tentative {
    SeenFeature seen;
    double angle = 0.0;
    int hits = 1;
    Time last_seen{};
  };
  bool is_same(const Tentative& tentative, const SeenFeature& seen, double angle) const;

  int hits_;
  double reach_;
  std::vector<Tentative> features_;
};

}  // namespace falko_slam
