// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "corner_block.hpp"

namespace falko_slam {
namespace {

constexpr FloatLanes kZero = FloatLanes{};

// Neighbours of the beams, all in the same step to one side.
struct Neighbors {
  FloatLanes x, y;
  IntLanes within;  // the radius
};

struct Center {
  FloatLanes range, radius_square;
};

inline void look(const SampledScan& scan, const BeamBlock& block, const Center& center,
                 std::int32_t step, Neighbors& right, Neighbors& left) {
  const auto lag = static_cast<std::ptrdiff_t>(step) * block.stride;
  FloatLanes below;
  FloatLanes above;
  load(scan.ranges(block.first) - lag, below);
  load(scan.ranges(block.first) + lag, above);
  right.x = below * scan.cosine(lag) - center.range;
  right.y = below * -scan.sine(lag);
  left.x = above * scan.cosine(lag) - center.range;
  left.y = above * scan.sine(lag);
  right.within = right.x * right.x + right.y * right.y <= center.radius_square;
  left.within = left.x * left.x + left.y * left.y <= center.radius_square;
}

// Whether the beam meets the line to either of its next neighbours at more than the least angle.
inline void find_steep(const Neighbors& right, const Neighbors& left, float tangent,
                       IntLanes& steep) {
  const FloatLanes right_along = right.x < kZero ? -right.x : right.x;
  const FloatLanes left_along = left.x < kZero ? -left.x : left.x;
  steep = (-right.y >= tangent * right_along) | (left.y >= tangent * left_along);
}

// The farthest neighbour within the radius, Eqs. (3.3) and (3.4); the beam's point if there is
// none.
struct End {
  FloatLanes x = kZero;
  FloatLanes y = kZero;

  inline void take(const Neighbors& next) {
    x = next.within ? next.x : x;
    y = next.within ? next.y : y;
  }
};

// Sums over the points of one side, from which its line follows.
struct SideLanes {
  FloatLanes n = kZero, x = kZero, y = kZero, xx = kZero, xy = kZero, yy = kZero;

  inline void take(const Neighbors& next) {
    const FloatLanes dx = next.within ? next.x : kZero;
    const FloatLanes dy = next.within ? next.y : kZero;
    n += next.within ? kZero + 1.0F : kZero;
    x += dx;
    y += dy;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
  }
};

// The line through a side and the beam's own point: normal . p = offset, the normal of any length.
struct SideLine {
  FloatLanes normal_x, normal_y, offset, mean_square_residual;
};

inline void fit(const SideLanes& side, SideLine& line) {
  const FloatLanes inverse_count = 1.0F / (side.n + 1.0F);
  const FloatLanes mean_x = side.x * inverse_count;
  const FloatLanes mean_y = side.y * inverse_count;
  const FloatLanes sxx = side.xx - mean_x * side.x;
  const FloatLanes sxy = side.xy - mean_x * side.y;
  const FloatLanes syy = side.yy - mean_y * side.y;
  // Eigenvalues of the scatter matrix are 0.5 (sxx + syy) -+ radius.
  const FloatLanes half_difference = 0.5F * (sxx - syy);
  FloatLanes radius = half_difference * half_difference + sxy * sxy;
  square_root(radius);
  const FloatLanes smaller = 0.5F * (sxx + syy) - radius;
  const IntLanes along_x = half_difference > kZero;
  line.normal_x = along_x ? -sxy : radius - half_difference;
  line.normal_y = along_x ? half_difference + radius : -sxy;
  line.offset = line.normal_x * mean_x + line.normal_y * mean_y;
  line.mean_square_residual = (smaller > kZero ? smaller : kZero) * inverse_count;
}

// Unit vector along the line, from the corner to where the side's points are.
inline void direction(const SideLine& line, const SideLanes& side, FloatLanes& x, FloatLanes& y) {
  FloatLanes length = line.normal_x * line.normal_x + line.normal_y * line.normal_y;
  square_root(length);
  x = line.normal_y / length;
  y = -line.normal_x / length;
  const IntLanes away = x * side.x + y * side.y >= kZero;
  x = away ? x : -x;
  y = away ? y : -y;
}

inline void intersect(const SideLine& a, const SideLine& b, float limit, CornerBlock& result) {
  const FloatLanes determinant = a.normal_x * b.normal_y - a.normal_y * b.normal_x;
  const FloatLanes x = (a.offset * b.normal_y - b.offset * a.normal_y) / determinant;
  const FloatLanes y = (a.normal_x * b.offset - b.normal_x * a.offset) / determinant;
  const IntLanes near = x * x + y * y < kZero + limit * limit;  // not for parallel lines
  result.x = near ? x : kZero;
  result.y = near ? y : kZero;
}

}  // namespace

bool find_corners(const SampledScan& scan, const BeamBlock& block, const CornerTests& tests,
                  CornerBlock& result) {
  Center center;
  load(scan.ranges(block.first), center.range);
  load(scan.radius_squares(block.first), center.radius_square);
  Neighbors right;
  Neighbors left;

  look(scan, block, center, 1, right, left);
  find_steep(right, left, tests.min_incidence_tangent, result.corner);
  End right_end;
  End left_end;
  right_end.take(right);
  left_end.take(left);
  for (std::int32_t step = 2; step <= block.steps; ++step) {
    look(scan, block, center, step, right, left);
    right_end.take(right);
    left_end.take(left);
  }
  const FloatLanes base_x = right_end.x - left_end.x;
  const FloatLanes base_y = right_end.y - left_end.y;
  const FloatLanes base_square = base_x * base_x + base_y * base_y;
  const FloatLanes doubled_area = base_x * left_end.y - base_y * left_end.x;
  const FloatLanes area_square = doubled_area * doubled_area;
  const FloatLanes limit = center.radius_square / (tests.triangle_ratio * tests.triangle_ratio);
  result.corner &= (base_square >= limit) & (area_square >= limit * base_square);
  if (!any(result.corner)) return false;

  SideLanes right_side;
  SideLanes left_side;
  for (std::int32_t step = 1; step <= block.steps; ++step) {
    look(scan, block, center, step, right, left);
    right_side.take(right);
    left_side.take(left);
  }
  result.corner &= (right_side.n >= kZero + tests.min_points_per_side) &
                   (left_side.n >= kZero + tests.min_points_per_side);
  SideLine right_line;
  SideLine left_line;
  fit(right_side, right_line);
  fit(left_side, left_line);
  intersect(right_line, left_line, tests.refinement_limit, result);
  FloatLanes right_x;
  FloatLanes right_y;
  FloatLanes left_x;
  FloatLanes left_y;
  direction(right_line, right_side, right_x, right_y);
  direction(left_line, left_side, left_x, left_y);
  result.axis_x = right_x + left_x;
  result.axis_y = right_y + left_y;
  result.slope = left_x - right_x;
  result.roughness_square = (right_line.mean_square_residual + left_line.mean_square_residual) *
                            base_square / area_square;
  return true;
}

}  // namespace falko_slam
