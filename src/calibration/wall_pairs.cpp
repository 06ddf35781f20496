// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "wall_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace falko_slam {
namespace {

enum class PieceSight { kPaired, kContradicts, kUnknown };

std::optional<std::size_t> beam_towards(const WallScan& scan, const Eigen::Vector2d& point) {
  return scan.beam_at(std::atan2(point.y(), point.x()));
}

// Beams of the target's wall that look between two points; 0 of them: a piece of no beams.
std::optional<WallPiece> piece_between(const WallScan& target, std::size_t wall,
                                       const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  constexpr std::size_t kLeastBeams = 3;
  const StraightWall& whole = target.walls()[wall];
  const auto first = beam_towards(target, from), last = beam_towards(target, to);
  if (!first || !last) return std::nullopt;
  const auto clamped = [&](std::size_t beam) { return std::clamp(beam, whole.first, whole.last); };
  const std::size_t a = clamped(*first), b = clamped(*last);
  if (b < a || b + 1 - a < kLeastBeams) return std::nullopt;
  return target.piece(wall, a, b);
}

PieceSight compare(const WallScan& target, const WallScan& source, const WallPiece& piece,
                   const Pose2& target_T_source, const WallGate& gate, WallPair& pair) {
  const StraightWall& source_wall = source.walls()[piece.wall];
  const Eigen::Vector2d middle = target_T_source * piece.middle;
  const Eigen::Vector2d normal = target_T_source.rotation() * source_wall.normal;
  if (normal.dot(middle) >= 0.0) return PieceSight::kUnknown;  // its other side
  const auto beam = beam_towards(target, middle);
  if (!beam || target.range(*beam) <= 0.0) return PieceSight::kUnknown;
  const double beyond = target.range(*beam) - middle.norm();
  const double slant = std::max(0.05, -normal.dot(middle) / middle.norm());
  // The beam may look past the middle by a beam.
  const double tolerance = (gate.distance + middle.norm() * target.angle_increment()) / slant;
  if (beyond < -tolerance) return PieceSight::kUnknown;  // hidden
  if (beyond > tolerance) return PieceSight::kContradicts;
  const auto wall = target.wall_at(*beam);
  if (!wall) return PieceSight::kUnknown;
  const StraightWall& target_wall = target.walls()[*wall];
  if (normal.dot(target_wall.normal) < std::cos(gate.angle)) return PieceSight::kContradicts;

  const Eigen::Vector2d along(normal.y(), -normal.x());  // the way of the beams
  const double half = 0.5 * pair.length;
  const auto same = piece_between(target, *wall, middle - half * along, middle + half * along);
  if (!same) return PieceSight::kUnknown;
  const Eigen::Vector2d between = middle - same->middle;
  if (std::abs(along.dot(between)) > half) return PieceSight::kUnknown;
  const Eigen::Vector2d n = (normal + target_wall.normal).normalized();
  pair.distance = n.dot(between);
  if (std::abs(pair.distance) > gate.distance) return PieceSight::kContradicts;
  const Eigen::Vector2d arm = middle - target_T_source.translation();
  const Eigen::Vector2d t(-n.y(), n.x());
  pair.gradient << n, n.y() * arm.x() - n.x() * arm.y();
  pair.feigned_gradient << t, t.y() * arm.x() - t.x() * arm.y();
  pair.variance = piece.variance + same->variance;
  pair.angle_variance = 0.25 * (source_wall.angle_variance + target_wall.angle_variance);
  pair.part = piece.part;
  return PieceSight::kPaired;
}

}  // namespace

WallPairs pair_walls(const WallScan& target, const WallScan& source, const Pose2& target_T_source,
                     const WallGate& gate) {
  WallPairs result;
  for (const WallPiece& piece : source.pieces()) {
    WallPair pair;
    pair.length = source.length_of(piece);
    switch (compare(target, source, piece, target_T_source, gate, pair)) {
      case PieceSight::kPaired:
        result.pairs.push_back(pair);
        break;
      case PieceSight::kContradicts:
        result.contradicting_length += pair.length;
        break;
      case PieceSight::kUnknown:
        break;
    }
  }
  return result;
}

}  // namespace falko_slam
