// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/features/beta_grid.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "beam_directions.hpp"
#include "beam_window.hpp"
#include "falko_slam/common/validation.hpp"
#include "falko_slam/features/sector_grid.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// A beam in the frame of the grid: the points foot + t along with t up to `end`, its own point.
// `foot` is nearest to the centre, so that |point|^2 = foot_square + t^2.
struct Ray {
  Eigen::Vector2d along;
  Eigen::Vector2d foot;
  double foot_square;
  double start, end;

  Eigen::Vector2d at(double t) const { return foot + t * along; }
};

}  // namespace

struct BetaGridExtractor::Workspace {
  explicit Workspace(const BetaGridParams& params);

  void describe(const LaserScan& scan, const Keypoint& keypoint, BetaGrid& grid);
  void follow(const Ray& ray);
  void cross_cells(const Ray& ray, double from, double to);
  double ring_crossing(const Ray& ray, int border, double t) const;
  double sector_crossing(const Ray& ray, int border) const;
  void add_miss(int ring, int sector);
  std::size_t cell_at(int ring, int sector) const {
    const int cell = ring * sectors.count() + sector;
    return static_cast<std::size_t>(cell);
  }

  double radius;
  double evidence_length;
  int rings;
  SectorGrid sectors;
  std::vector<double> border_squares;    // of the rings, one more than rings [m^2]
  std::vector<Eigen::Vector2d> borders;  // where the sectors start
  std::vector<int> hits, misses;         // by cell
  std::vector<std::size_t> last_beam;    // that counted for the cell
  std::size_t beam = 0;                  // number of the one being followed
  BeamDirections directions;
};

BetaGridExtractor::Workspace::Workspace(const BetaGridParams& params)
    : radius(params.radius),
      evidence_length(params.evidence_length),
      rings(params.rings),
      sectors(params.sectors) {
  for (int i = 0; i <= rings; ++i) {
    const double border =
        params.min_radius + (params.radius - params.min_radius) * i / params.rings;
    border_squares.push_back(border * border);
  }
  for (int i = 0; i < params.sectors; ++i) {
    const double angle = kTwoPi * i / params.sectors;
    borders.emplace_back(std::cos(angle), std::sin(angle));
  }
  const std::size_t cells =
      static_cast<std::size_t>(params.rings) * static_cast<std::size_t>(params.sectors);
  hits.resize(cells);
  misses.resize(cells);
  last_beam.resize(cells);
}

void BetaGridExtractor::Workspace::add_miss(int ring, int sector) {
  const std::size_t cell = cell_at(ring, sector);
  if (last_beam[cell] == beam) return;
  last_beam[cell] = beam;
  ++misses[cell];
}

// Where after t the beam leaves through the border of a ring; towards the centre for t < 0.
double BetaGridExtractor::Workspace::ring_crossing(const Ray& ray, int border, double t) const {
  const double square = border_squares[static_cast<std::size_t>(border)] - ray.foot_square;
  if (!(square > 0.0)) return kInfinity;
  return t < 0.0 ? -std::sqrt(square) : std::sqrt(square);
}

double BetaGridExtractor::Workspace::sector_crossing(const Ray& ray, int border) const {
  const Eigen::Vector2d& direction = borders[static_cast<std::size_t>(border)];
  const double across = cross(ray.along, direction);
  const double t = -cross(ray.foot, direction) / across;
  // The half of the line that lies behind the centre is no border.
  return across != 0.0 && ray.at(t).dot(direction) > 0.0 ? t : kInfinity;
}

// The cells between two places of the beam that are both inside the grid, border by border: the
// direction from the centre turns one way all along.
void BetaGridExtractor::Workspace::cross_cells(const Ray& ray, double from, double to) {
  if (!(from < to)) return;
  const int count = sectors.count();
  const bool counter_clockwise = cross(ray.foot, ray.along) > 0.0;
  // A little inside, where rounding does not decide.
  double t = from + 1e-9 * (to - from);
  const double square = ray.foot_square + t * t;
  int ring = 0;
  while (ring + 1 < rings && square >= border_squares[static_cast<std::size_t>(ring) + 1]) ++ring;
  const Eigen::Vector2d start = ray.at(t);
  int sector = sectors.sector(static_cast<float>(start.x()), static_cast<float>(start.y()));
  const int most = 2 * rings + count + 2;
  for (int step = 0; step < most; ++step) {
    add_miss(ring, sector);
    // Towards the centre the inner border comes first, unless the beam turns back before it.
    double at_ring = t < 0.0 ? ring_crossing(ray, ring, t) : ring_crossing(ray, ring + 1, t);
    bool inwards = t < 0.0;
    if (at_ring == kInfinity) {
      at_ring = ring_crossing(ray, ring + 1, 0.0);
      inwards = false;
    }
    const double at_sector =
        sector_crossing(ray, counter_clockwise ? (sector + 1) % count : sector);
    if (std::min(at_ring, at_sector) >= to) return;
    if (at_sector < at_ring) {
      sector = (sector + (counter_clockwise ? 1 : count - 1)) % count;
      t = std::max(t, at_sector);
    } else {
      ring += inwards ? -1 : 1;
      t = std::max(t, at_ring);
    }
    if (ring < 0 || ring >= rings) return;
  }
}

void BetaGridExtractor::Workspace::follow(const Ray& ray) {
  ++beam;
  if (!(ray.foot_square < border_squares.back())) return;
  const double square = ray.foot_square + ray.end * ray.end;
  if (square >= border_squares.front() && square < border_squares.back()) {
    int ring = 0;
    while (square >= border_squares[static_cast<std::size_t>(ring) + 1]) ++ring;
    const Eigen::Vector2d point = ray.at(ray.end);
    const int sector = sectors.sector(static_cast<float>(point.x()), static_cast<float>(point.y()));
    const std::size_t cell = cell_at(ring, sector);
    last_beam[cell] = beam;
    ++hits[cell];
  }
  const double outer = std::sqrt(border_squares.back() - ray.foot_square);
  const double begin = std::max(ray.start, -outer);
  const double end = std::min(ray.end, outer);
  const double hole_square = border_squares.front() - ray.foot_square;
  if (hole_square <= 0.0) return cross_cells(ray, begin, end);
  const double hole = std::sqrt(hole_square);
  cross_cells(ray, begin, std::min(end, -hole));
  cross_cells(ray, std::max(begin, hole), end);
}

void BetaGridExtractor::Workspace::describe(const LaserScan& scan, const Keypoint& keypoint,
                                            BetaGrid& grid) {
  std::fill(hits.begin(), hits.end(), 0);
  std::fill(misses.begin(), misses.end(), 0);
  const double cosine = std::cos(keypoint.orientation);
  const double sine = std::sin(keypoint.orientation);
  const auto to_grid = [&](const Eigen::Vector2d& v) {
    return Eigen::Vector2d(cosine * v.x() + sine * v.y(), cosine * v.y() - sine * v.x());
  };
  const Eigen::Vector2d laser = to_grid(-keypoint.position);
  const BeamWindow window = window_around(scan, keypoint, directions[keypoint.beam], radius);
  for_each_run(scan, keypoint, window, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      if (!scan.valid(i)) continue;
      Ray ray;
      ray.along = to_grid(directions[i]);
      ray.start = laser.dot(ray.along);
      ray.end = ray.start + scan.ranges[i];
      ray.foot = laser - ray.start * ray.along;
      ray.foot_square = ray.foot.squaredNorm();
      follow(ray);
    }
  });
  const double evidence = keypoint.position.norm() * scan.angle_increment / evidence_length;
  grid.occupancy.resize(hits.size());
  grid.variance.resize(hits.size());
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const double a = 1.0 + evidence * hits[i];
    const double b = 1.0 + evidence * misses[i];
    grid.occupancy[i] = static_cast<float>(a / (a + b));
    grid.variance[i] = static_cast<float>(a * b / ((a + b) * (a + b) * (a + b + 1.0)));
  }
}

BetaGridExtractor::BetaGridExtractor(const BetaGridParams& params) : params_(params) {
  validate(params_);
  workspace_ = std::make_unique<Workspace>(params_);
}
BetaGridExtractor::~BetaGridExtractor() = default;
BetaGridExtractor::BetaGridExtractor(BetaGridExtractor&&) noexcept = default;
BetaGridExtractor& BetaGridExtractor::operator=(BetaGridExtractor&&) noexcept = default;

void BetaGridExtractor::extract(const LaserScan& scan, const std::vector<Keypoint>& keypoints,
                                std::vector<BetaGrid>& grids) {
  workspace_->directions.assign(scan);
  grids.resize(keypoints.size());
  for (std::size_t i = 0; i < keypoints.size(); ++i) {
    workspace_->describe(scan, keypoints[i], grids[i]);
  }
}

std::vector<BetaGrid> BetaGridExtractor::extract(const LaserScan& scan,
                                                 const std::vector<Keypoint>& keypoints) {
  std::vector<BetaGrid> grids;
  extract(scan, keypoints, grids);
  return grids;
}

double distance(const BetaGrid& a, const BetaGrid& b) {
  if (a.occupancy.size() != b.occupancy.size()) {
    throw std::invalid_argument(
        "descriptors of different sizes: " + std::to_string(a.occupancy.size()) + " and " +
        std::to_string(b.occupancy.size()));
  }
  double sum = 0.0;
  double weights = 0.0;
  for (std::size_t i = 0; i < a.occupancy.size(); ++i) {
    const auto p = static_cast<double>(a.occupancy[i]);
    const auto q = static_cast<double>(b.occupancy[i]);
    const double weight =
        1.0 / (static_cast<double>(a.variance[i]) + static_cast<double>(b.variance[i]));
    sum += weight * (p - q) * (p - q) / (p + q);
    weights += weight;
  }
  return weights > 0.0 ? sum / weights : 0.0;
}

void validate(const BetaGridParams& params) {
  require_in_range("radius", params.radius, 0.05, 10.0);
  require_in_range("min_radius", params.min_radius, 0.001, 0.5 * params.radius);
  require_in_range("rings", params.rings, 1, 64);
  require_in_range("sectors", params.sectors, 2, 256);
  require_in_range("evidence_length", params.evidence_length, 0.001, 10.0);
}

}  // namespace falko_slam
