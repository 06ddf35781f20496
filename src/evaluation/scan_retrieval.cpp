// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/scan_retrieval.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "falko_slam/features/beta_grid.hpp"
#include "falko_slam/place_recognition/phrase_index.hpp"
#include "falko_slam/place_recognition/signature_index.hpp"
#include "falko_slam/place_recognition/surface_normals.hpp"

namespace falko_slam {
namespace {

std::vector<Eigen::Vector2d> positions_of(const std::vector<Keypoint>& keypoints) {
  std::vector<Eigen::Vector2d> positions;
  positions.reserve(keypoints.size());
  for (const Keypoint& keypoint : keypoints) positions.push_back(keypoint.position);
  return positions;
}

std::vector<MatchPoint> points_of(const std::vector<Keypoint>& keypoints) {
  std::vector<MatchPoint> points;
  points.reserve(keypoints.size());
  for (const Keypoint& keypoint : keypoints) {
    points.push_back({keypoint.position, keypoint.orientation});
  }
  return points;
}

void use_grid_normals(const LaserScan& scan, std::vector<MatchPoint>& points) {
  std::vector<Eigen::Vector2d> places;
  places.reserve(points.size());
  for (const MatchPoint& point : points) places.push_back(point.position);
  const std::vector<double> normals = surface_normals(scan, places);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].orientation = normals[i];
}

// The keypoints are in the order of their beams: that of their bearings.
std::vector<PhraseBag> phrase_bags(const std::vector<PosedScan>& scans,
                                   const ScanKeypoints& keypoints, const GfpParams& params) {
  BetaGridExtractor extractor;
  std::vector<Vocabulary::Descriptor> descriptors;
  for (std::size_t scan = 0; scan < scans.size(); ++scan) {
    for (const BetaGrid& grid : extractor.extract(scans[scan].scan, keypoints[scan])) {
      descriptors.push_back(grid.occupancy);
    }
  }
  const Vocabulary vocabulary = Vocabulary::learned(descriptors, params.vocabulary);
  std::vector<PhraseBag> bags;
  auto next = descriptors.begin();
  for (std::size_t scan = 0; scan < scans.size(); ++scan) {
    std::vector<std::size_t> words;
    for (std::size_t i = 0; i < keypoints[scan].size(); ++i) {
      words.push_back(vocabulary.word_of(*next++));
    }
    bags.push_back(geometric_phrases(words, scans[scan].scan.closed, params.phrases));
  }
  return bags;
}

// The `count` admitted scans of the least distance.
template <class Distance>
std::vector<std::size_t> least_distant(std::size_t scans, std::size_t count,
                                       const ScanRetrieval::Admission& admits,
                                       const Distance& distance) {
  std::vector<std::pair<std::uint32_t, std::size_t>> ranked;
  for (std::size_t target = 0; target < scans; ++target) {
    if (admits(target)) ranked.emplace_back(distance(target), target);
  }
  const auto end = ranked.begin() + static_cast<std::ptrdiff_t>(std::min(count, ranked.size()));
  std::partial_sort(ranked.begin(), end, ranked.end());
  std::vector<std::size_t> targets;
  for (auto entry = ranked.begin(); entry != end; ++entry) targets.push_back(entry->second);
  return targets;
}

}  // namespace

ScanRetrieval glarot_retrieval(const ScanKeypoints& keypoints, const GlareParams& params) {
  struct Memory {
    SignatureIndex index;
    std::vector<Signature> signatures;
  };
  const auto memory = std::make_shared<Memory>(
      Memory{SignatureIndex(params.direction_cells, params.distance_cells), {}});
  std::vector<double> times;
  for (const auto& points : keypoints) {
    times.push_back(milliseconds_of([&] {
      const KeyframeId id{memory->signatures.size()};
      memory->signatures.push_back(glare(positions_of(points), params));
      memory->index.add(id, memory->signatures.back());
    }));
  }
  return {loop_timing(std::move(times)),
          [memory](std::size_t source, std::size_t count, const ScanRetrieval::Admission& admits) {
            std::vector<std::size_t> targets;
            for (const SignatureMatch& found : memory->index.nearest(
                     memory->signatures[source], count,
                     [&](KeyframeId id) { return admits(static_cast<std::size_t>(id.value)); })) {
              targets.push_back(static_cast<std::size_t>(found.id.value));
            }
            return targets;
          }};
}

ScanRetrieval gsr_retrieval(const std::vector<PosedScan>& scans, const ScanKeypoints& keypoints,
                            const GsrParams& params, KeypointNormals normals) {
  const auto signatures = std::make_shared<std::vector<Signature>>();
  std::vector<double> times;
  for (std::size_t scan = 0; scan < scans.size(); ++scan) {
    times.push_back(milliseconds_of([&] {
      auto points = points_of(keypoints[scan]);
      if (normals == KeypointNormals::kGrid) use_grid_normals(scans[scan].scan, points);
      signatures->push_back(gsr(points, params));
    }));
  }
  return {loop_timing(std::move(times)), [signatures](std::size_t source, std::size_t count,
                                                      const ScanRetrieval::Admission& admits) {
            return least_distant(signatures->size(), count, admits, [&](std::size_t target) {
              return l1_distance((*signatures)[source], (*signatures)[target]);
            });
          }};
}

ScanRetrieval gfp_retrieval(const std::vector<PosedScan>& scans, const ScanKeypoints& keypoints,
                            const GfpParams& params) {
  struct Memory {
    std::vector<PhraseBag> bags;
    std::optional<PhraseIndex> index;
  };
  const auto memory = std::make_shared<Memory>();
  const double total = milliseconds_of([&] {
    memory->bags = phrase_bags(scans, keypoints, params);
    memory->index.emplace(memory->bags);
  });
  // All at once: each scan costs the mean.
  const auto creation =
      loop_timing(std::vector<double>(scans.size(), total / static_cast<double>(scans.size())));
  return {creation,
          [memory](std::size_t source, std::size_t count, const ScanRetrieval::Admission& admits) {
            std::vector<std::size_t> targets;
            for (const PhraseMatch& found :
                 memory->index->nearest(memory->bags[source], count, admits)) {
              targets.push_back(found.scan);
            }
            return targets;
          }};
}

}  // namespace falko_slam
