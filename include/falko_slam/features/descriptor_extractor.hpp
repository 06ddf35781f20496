// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "falko_slam/features/descriptors.hpp"
#include "falko_slam/features/keypoint.hpp"
#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

/// Values of \cite kallasi2017, section 3.3.2.
struct DescriptorParams {
  double radius = 0.5;     ///< of the described neighbourhood [m]. [0.05, 10]
  int rings = 8;           ///< r_n: rings of BSC. [1, 64]
  int sectors = 16;        ///< alpha_n: sectors of BSC and bins of CGH. [4, 256]
  double cgh_sigma = 0.6;  ///< standard deviation of a neighbour's direction [bins]. [0.01, 8]
};
/// Throws std::invalid_argument with the field and its value.
void validate(const DescriptorParams& params);

struct DescribedKeypoint {
  Keypoint keypoint;
  Bsc bsc;
  Cgh cgh;
};

/// BSC and CGH of keypoints, from one pass over the points around each of them.
///
/// The grid is centred on the keypoint's refined position and starts at its orientation. All valid
/// beams within the radius count; on a closed scan the neighbourhood reaches over the seam.
/// Keeps its memory between scans; not thread-safe.
class DescriptorExtractor {
 public:
  explicit DescriptorExtractor(const DescriptorParams& params = {});
  ~DescriptorExtractor();
  DescriptorExtractor(DescriptorExtractor&&) noexcept;
  DescriptorExtractor& operator=(DescriptorExtractor&&) noexcept;

  /// Replaces `features` by the keypoints with their descriptors, in the same order.
  void extract(const LaserScan& scan, const std::vector<Keypoint>& keypoints,
               std::vector<DescribedKeypoint>& features);
  std::vector<DescribedKeypoint> extract(const LaserScan& scan,
                                         const std::vector<Keypoint>& keypoints);

  const DescriptorParams& params() const { return params_; }

 private:
  struct Workspace;
  DescriptorParams params_;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace falko_slam
