// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/scan_retrieval.hpp"

#include <memory>
#include <utility>

#include "falko_slam/place_recognition/signature_index.hpp"

namespace falko_slam {
namespace {

std::vector<Eigen::Vector2d> positions_of(const std::vector<Keypoint>& keypoints) {
  std::vector<Eigen::Vector2d> positions;
  for (const Keypoint& keypoint : keypoints) positions.push_back(keypoint.position);
  return positions;
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

}  // namespace falko_slam
