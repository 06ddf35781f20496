// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "falko_slam/evaluation/loop_method.hpp"
#include "falko_slam/features/keypoint.hpp"
#include "falko_slam/place_recognition/geometric_phrases.hpp"
#include "falko_slam/place_recognition/glare.hpp"
#include "falko_slam/place_recognition/gsr.hpp"
#include "falko_slam/place_recognition/vocabulary.hpp"

namespace falko_slam {

/// The keypoints of each scan of a log.
using ScanKeypoints = std::vector<std::vector<Keypoint>>;

/// Finds the scans that look most like one of them.
struct ScanRetrieval {
  using Admission = std::function<bool(std::size_t target)>;

  LoopTiming creation;  ///< of the signatures
  /// At most `count` of the admitted scans, the most alike first; of those equally alike the
  /// earliest.
  std::function<std::vector<std::size_t>(std::size_t source, std::size_t count,
                                         const Admission& admits)>
      nearest;
};

/// GLARE signatures under GLAROT's distance (\cite kallasi2017 4.1.1).
ScanRetrieval glarot_retrieval(const ScanKeypoints& keypoints, const GlareParams& params = {});

/// What GSR takes for the normal of a keypoint.
enum class KeypointNormals {
  kOrientation,  ///< the keypoint's own orientation
  kGrid,         ///< of the surface in a Euclidean grid, as the text of the thesis has it
};

/// GSR signatures under the L1 distance.
///
/// Deviation: a corner has no normal; the direction in which the points of its cell spread least is
/// a matter of chance there, its bisector is not. Hence orientations by default, which serve GSR
/// better (doc/decisions/0010-gsr-and-phrases.md).
ScanRetrieval gsr_retrieval(const std::vector<PosedScan>& scans, const ScanKeypoints& keypoints,
                            const GsrParams& params = {},
                            KeypointNormals normals = KeypointNormals::kOrientation);

struct GfpParams {
  VocabularyParams vocabulary;
  PhraseParams phrases;
};

/// Geometrical FLIRT phrases: words are beta-grids of the keypoints, learned from all scans of the
/// log, as the thesis does (4.2.2); with the share of the learning in the time of creation.
ScanRetrieval gfp_retrieval(const std::vector<PosedScan>& scans, const ScanKeypoints& keypoints,
                            const GfpParams& params = {});

}  // namespace falko_slam
