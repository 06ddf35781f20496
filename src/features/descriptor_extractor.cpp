// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/features/descriptor_extractor.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "beam_directions.hpp"
#include "beam_window.hpp"
#include "falko_slam/common/validation.hpp"
#include "falko_slam/features/sector_grid.hpp"

namespace falko_slam {
namespace {

constexpr int kMaxSectors = 256;

// N(d, sigma) for circular distances -reach to reach of two bins, the sum over all bins being 1. Of
// two bins that lie opposite each other the distance is counted on one side only.
struct CircularGaussian {
  std::size_t reach;
  std::vector<float> weights;
};

CircularGaussian circular_gaussian(int bins, double sigma) {
  constexpr double kTail = 5.0;  // standard deviations; what lies beyond is below 4e-6
  const int reach = std::min(bins / 2, static_cast<int>(std::ceil(kTail * sigma)));
  std::vector<double> weights;
  for (int d = -reach; d <= reach; ++d) {
    const bool twice = 2 * d == -bins;
    weights.push_back(twice ? 0.0 : std::exp(-0.5 * d * d / (sigma * sigma)));
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  CircularGaussian gaussian{static_cast<std::size_t>(reach), {}};
  for (const double weight : weights) gaussian.weights.push_back(static_cast<float>(weight / sum));
  return gaussian;
}

}  // namespace

struct DescriptorExtractor::Workspace {
  explicit Workspace(const DescriptorParams& params)
      : radius(params.radius),
        radius_square(static_cast<float>(params.radius * params.radius)),
        rings_per_metre(static_cast<float>(params.rings / params.radius)),
        last_ring(params.rings - 1),
        sectors(params.sectors),
        gaussian(circular_gaussian(params.sectors, params.cgh_sigma)),
        words(static_cast<std::size_t>(params.rings * params.sectors + 63) / 64),
        points_in_sector(static_cast<std::size_t>(params.sectors)) {}

  void resize(std::vector<DescribedKeypoint>& features, std::size_t size);
  void describe(const LaserScan& scan, DescribedKeypoint& feature);
  void add_points(const LaserScan& scan, const Keypoint& keypoint, std::size_t begin,
                  std::size_t end, Bsc& bsc);
  void spread(Cgh& cgh);

  double radius;
  float radius_square;
  float rings_per_metre;
  int last_ring;
  SectorGrid sectors;
  CircularGaussian gaussian;
  std::size_t words;
  std::vector<int> points_in_sector;
  std::vector<float> sums;
  BeamDirections directions;
  std::vector<DescribedKeypoint> spare;  // for their memory
};

// Features that are not needed now keep the memory of their descriptors for a later scan.
void DescriptorExtractor::Workspace::resize(std::vector<DescribedKeypoint>& features,
                                            std::size_t size) {
  while (features.size() > size) {
    spare.push_back(std::move(features.back()));
    features.pop_back();
  }
  while (features.size() < size && !spare.empty()) {
    features.push_back(std::move(spare.back()));
    spare.pop_back();
  }
  features.resize(size);
}

void DescriptorExtractor::Workspace::add_points(const LaserScan& scan, const Keypoint& keypoint,
                                                std::size_t begin, std::size_t end, Bsc& bsc) {
  const auto cosine = static_cast<float>(std::cos(keypoint.orientation));
  const auto sine = static_cast<float>(std::sin(keypoint.orientation));
  const double center_x = keypoint.position.x();
  const double center_y = keypoint.position.y();
  const int outermost = last_ring;
  const int count = sectors.count();
  std::uint64_t* bits = bsc.words.data();
  int* points = points_in_sector.data();
  for (std::size_t beam = begin; beam < end; ++beam) {
    const double range = scan.ranges[beam];
    const auto dx = static_cast<float>(range * directions[beam].x() - center_x);
    const auto dy = static_cast<float>(range * directions[beam].y() - center_y);
    const float square = dx * dx + dy * dy;
    if (!(square < radius_square)) continue;  // nor for NaN
    const int sector = sectors.sector(cosine * dx + sine * dy, cosine * dy - sine * dx);
    const int ring = std::min(outermost, static_cast<int>(std::sqrt(square) * rings_per_metre));
    const auto cell = static_cast<unsigned>(ring * count + sector);
    bits[cell / 64] |= std::uint64_t{1} << (cell % 64);
    ++points[sector];
  }
}

// Eq. (3.14): every point spreads over the bins around its own.
void DescriptorExtractor::Workspace::spread(Cgh& cgh) {
  const std::size_t bins = points_in_sector.size();
  const std::size_t reach = gaussian.reach;
  sums.assign(bins + 2 * reach, 0.0F);  // bin i stands at i + reach, with what goes beyond the ends
  float total = 0.0F;
  for (std::size_t i = 0; i < bins; ++i) {
    if (points_in_sector[i] == 0) continue;
    const auto points = static_cast<float>(points_in_sector[i]);
    for (std::size_t j = 0; j <= 2 * reach; ++j) sums[i + j] += points * gaussian.weights[j];
    total += points;
  }
  for (std::size_t i = 0; i < reach; ++i) {
    sums[bins + i] += sums[i];
    sums[reach + i] += sums[bins + reach + i];
  }
  const float scale = total > 0.0F ? 1.0F / total : 0.0F;
  cgh.bins.resize(bins);
  for (std::size_t i = 0; i < bins; ++i) cgh.bins[i] = scale * sums[reach + i];
}

void DescriptorExtractor::Workspace::describe(const LaserScan& scan, DescribedKeypoint& feature) {
  feature.bsc.words.assign(words, 0);
  std::fill(points_in_sector.begin(), points_in_sector.end(), 0);
  const BeamWindow window =
      window_around(scan, feature.keypoint, directions[feature.keypoint.beam], radius);
  for_each_run(scan, feature.keypoint, window, [&](std::size_t begin, std::size_t end) {
    add_points(scan, feature.keypoint, begin, end, feature.bsc);
  });
  spread(feature.cgh);
}

DescriptorExtractor::DescriptorExtractor(const DescriptorParams& params) : params_(params) {
  validate(params_);
  workspace_ = std::make_unique<Workspace>(params_);
}
DescriptorExtractor::~DescriptorExtractor() = default;
DescriptorExtractor::DescriptorExtractor(DescriptorExtractor&&) noexcept = default;
DescriptorExtractor& DescriptorExtractor::operator=(DescriptorExtractor&&) noexcept = default;

void DescriptorExtractor::extract(const LaserScan& scan, const std::vector<Keypoint>& keypoints,
                                  std::vector<DescribedKeypoint>& features) {
  workspace_->directions.assign(scan);
  workspace_->resize(features, keypoints.size());
  for (std::size_t i = 0; i < keypoints.size(); ++i) {
    features[i].keypoint = keypoints[i];
    workspace_->describe(scan, features[i]);
  }
}

std::vector<DescribedKeypoint> DescriptorExtractor::extract(
    const LaserScan& scan, const std::vector<Keypoint>& keypoints) {
  std::vector<DescribedKeypoint> features;
  extract(scan, keypoints, features);
  return features;
}

void validate(const DescriptorParams& params) {
  require_in_range("radius", params.radius, 0.05, 10.0);
  require_in_range("rings", params.rings, 1, 64);
  require_in_range("sectors", params.sectors, 4, kMaxSectors);
  require_in_range("cgh_sigma", params.cgh_sigma, 0.01, 8.0);
}

}  // namespace falko_slam
