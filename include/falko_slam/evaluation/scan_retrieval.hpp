// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "falko_slam/evaluation/loop_method.hpp"
#include "falko_slam/features/keypoint.hpp"
#include "falko_slam/place_recognition/glare.hpp"

namespace falko_slam {

/// The keypoints of each scan of a log.
using ScanKeypoints = std::vector<std::vector<Keypoint>>;

/// Finds the scans that look most like one of them.
struct ScanRetrieval {
  using Admission = std::function<bool(std::size_t target)>;

  LoopTiming creation;  ///< of the signatures
  /// At most `count` of the admitted scans, the most alike first; of those equally alike the
  /// earliest. None where nothing can be told, such as from no keypoints.
  std::function<std::vector<std::size_t>(std::size_t source, std::size_t count,
                                         const Admission& admits)>
      nearest;
};

/// GLARE signatures under GLAROT's distance (\cite kallasi2017 4.1.1).
ScanRetrieval glarot_retrieval(const ScanKeypoints& keypoints, const GlareParams& params = {});

}  // namespace falko_slam
