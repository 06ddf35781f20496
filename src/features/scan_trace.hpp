// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "beam_directions.hpp"
#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

/// The valid points of a scan, strung up in the order of their beams and cut where there is a gap.
///
/// A closed scan is read from a beam that its ranges alone determine, and all geometry is computed
/// in the frame of that beam: two scans that differ only in where they start have the same trace,
/// to the bit. A closed scan without any gap is a loop, which is continued over both of its ends by
/// half of its points: they have their neighbours on both sides.
class ScanTrace {
 public:
  /// The point on the other side of a gap.
  struct Neighbor {
    bool exists;
    double range;  ///< [m]
  };

  /// Points `begin` to `end`, of which those from `first` to `last` are not the continuation of a
  /// loop, and what lies beyond the gaps at its ends.
  struct Piece {
    std::size_t begin, end;
    std::size_t first, last;
    Neighbor before, after;
  };

  /// Cuts where consecutive valid points are farther apart than `max_gap` [m] or a quarter of a
  /// turn.
  void assign(const LaserScan& scan, double max_gap);

  std::size_t size() const { return beam.size(); }
  const std::vector<Piece>& pieces() const { return pieces_; }
  /// Bearing of the beam that all geometry is seen from [rad].
  double start_bearing() const { return start_bearing_; }

  // By point.
  std::vector<std::size_t> beam;  ///< in the scan
  std::vector<double> bearing;    ///< from the start, ascending within a piece [rad]
  std::vector<double> range;      ///< [m]
  std::vector<double> x, y;       ///< in the frame of the beam at the start [m]

 private:
  void collect(const LaserScan& scan, std::size_t start);
  void cut(const LaserScan& scan, double max_gap);
  void close_loop(const LaserScan& scan);

  double start_bearing_ = 0.0;
  BeamDirections directions_;
  std::vector<Piece> pieces_;
};

}  // namespace falko_slam
