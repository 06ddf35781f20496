// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "falko_slam/evaluation/scan_retrieval.hpp"

namespace falko_slam {

struct ThesisMethodParams {
  int candidates = 10;             ///< nearest signatures that are associated. [1, 1000]
  int gfp_candidates = 50;         ///< the same of GFP. [1, 1000]
  double neighbor_distance = 0.1;  ///< keypoints that are nearer after alignment count. [m]
  GlareParams glare;
  GsrParams gsr;
  KeypointNormals normals = KeypointNormals::kOrientation;  ///< of GSR
  GfpParams gfp;
  std::uint64_t seed = 1;  ///< of RANSAC
};
/// Throws std::invalid_argument with the field and its value.
void validate(const ThesisMethodParams& params);

/// The loop closures that Fig. 4.2 of \cite kallasi2017 compares, by its names.
std::vector<std::string> thesis_method_names();

/// One of them on a log: keypoints, nearest signatures, association; the candidate wins after whose
/// alignment the most keypoints have a neighbour, and their number is the score: the closures of
/// the thesis with N_min are those with a score of at least N_min.
///
/// Association uses the positions of the keypoints only. Each scan has its own random numbers: a
/// closure does not depend on those before. Throws std::invalid_argument for an unknown name or a
/// bad parameter.
LoopMethod thesis_method(const std::string& name, const std::vector<PosedScan>& scans,
                         const ThesisMethodParams& params = {});

}  // namespace falko_slam
