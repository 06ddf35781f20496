// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/scan_agreement.hpp"

#include "falko_slam/common/validation.hpp"
#include "footing.hpp"

namespace falko_slam {

void validate(const AgreementParams& params) {
  require_in_range("tolerance", params.tolerance, 1e-3, 10.0);
  require_in_range("see_through", params.see_through, 0.0, 100.0);
}

Agreement& Agreement::operator+=(const Agreement& other) {
  points += other.points;
  agreeing += other.agreeing;
  missed += other.missed;
  seen_through += other.seen_through;
  length += other.length;
  agreeing_length += other.agreeing_length;
  missed_length += other.missed_length;
  seen_through_length += other.seen_through_length;
  return *this;
}

Agreement agreement(const ScanView& target, const ScanView& source, const Pose2& target_T_source,
                    const AgreementParams& params, std::size_t stride) {
  Agreement result;
  for (std::size_t i = 0; i < source.points().size(); i += stride) {
    const SurfacePoint& point = source.points()[i];
    ++result.points;
    result.length += point.length;
    const Eigen::Vector2d in_target = target_T_source * point.position;
    const Footing found = footing(target, in_target, params.tolerance);
    if (found.range <= 0.0) continue;
    if (found.distance < params.tolerance) {
      ++result.agreeing;
      result.agreeing_length += point.length;
    } else if (in_target.norm() < found.range - params.see_through) {
      ++result.seen_through;
      result.seen_through_length += point.length;
    } else if (in_target.norm() < found.range + params.see_through) {
      ++result.missed;
      result.missed_length += point.length;
    }
  }
  return result;
}

}  // namespace falko_slam
