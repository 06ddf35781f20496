// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/feature_mapper.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "falko_slam/common/validation.hpp"
#include "kept_sight.hpp"
#include "keypoint_clusters.hpp"
#include "landmark_fields.hpp"
#include "viewpoint_cover.hpp"

namespace falko_slam {
namespace {

constexpr double kUsualViewpoints = 2.0;  // that usual_deviation counts as

// The mean of a landmark's keypoints from one viewpoint.
struct View {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double variance_sum = 0.0;
  double count = 0.0;

  Eigen::Vector2d mean() const { return sum / count; }
};

struct Cluster {
  std::map<std::size_t, View> views;  // by viewpoint
  std::set<std::size_t> scans;
  std::size_t keypoints = 0;
};

Cluster cluster_of(const std::vector<PlacedKeypoint>& keypoints,
                   const std::vector<std::size_t>& members) {
  Cluster cluster;
  for (const std::size_t member : members) {
    const PlacedKeypoint& keypoint = keypoints[member];
    View& view = cluster.views[keypoint.viewpoint];
    view.sum += keypoint.point;
    view.variance_sum += keypoint.variance;
    view.count += 1.0;
    cluster.scans.insert(keypoint.scan);
  }
  cluster.keypoints = members.size();
  return cluster;
}

// Mean and scatter over viewpoints: what they have in common with another one is its noise and the
// corner's own wandering.
PointEstimate middle_of(const Cluster& cluster, double usual_deviation) {
  const double usual_variance = usual_deviation * usual_deviation;
  const auto weight_of = [&](const View& view) {
    return 1.0 / (usual_variance + view.variance_sum / view.count);
  };
  PointEstimate middle;
  double weights = 0.0;
  for (const auto& [viewpoint, view] : cluster.views) {
    middle.point += weight_of(view) * view.mean();
    weights += weight_of(view);
  }
  middle.point /= weights;
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const auto& [viewpoint, view] : cluster.views) {
    const Eigen::Vector2d off = view.mean() - middle.point;
    scatter += weight_of(view) / weights * off * off.transpose();
  }
  scatter(1, 0) = scatter(0, 1);  // products are rounded differently
  const auto count = static_cast<double>(cluster.views.size());
  middle.covariance =
      (count * scatter + kUsualViewpoints * usual_variance * Eigen::Matrix2d::Identity()) /
      (count - 1.0 + kUsualViewpoints);
  return middle;
}

struct Candidate {
  MapLandmark landmark;
  std::size_t viewpoints = 0;
  std::size_t keypoints = 0;
};

bool is_better(const Candidate& a, const Candidate& b) {
  const auto key = [](const Candidate& candidate) {
    const Eigen::Vector2d& place = candidate.landmark.position;
    return std::make_tuple(-static_cast<double>(candidate.viewpoints), -candidate.landmark.hits,
                           place.x(), place.y());
  };
  return key(a) < key(b);
}

bool is_free(const Eigen::Vector2d& place, const LandmarkMap& map, double separation) {
  return std::none_of(map.landmarks.begin(), map.landmarks.end(), [&](const MapLandmark& other) {
    return (other.position - place).norm() < separation;
  });
}

// The best of those that are too near to each other, by place.
void append_best(std::vector<Candidate> candidates, double separation, FeatureMap& result) {
  std::sort(candidates.begin(), candidates.end(), is_better);
  LandmarkMap taken = result.map;
  for (const Candidate& candidate : candidates) {
    if (!is_free(candidate.landmark.position, taken, separation)) {
      ++result.report.too_near;
      continue;
    }
    taken.landmarks.push_back(candidate.landmark);
    ++result.report.features;
    result.report.keypoints_of_features += candidate.keypoints;
  }
  const auto first_new =
      taken.landmarks.begin() + static_cast<std::ptrdiff_t>(result.map.landmarks.size());
  std::sort(first_new, taken.landmarks.end(), [](const MapLandmark& a, const MapLandmark& b) {
    return std::make_pair(a.position.x(), a.position.y()) <
           std::make_pair(b.position.x(), b.position.y());
  });
  int id = 0;
  for (const MapLandmark& landmark : result.map.landmarks) id = std::max(id, landmark.id + 1);
  for (auto landmark = first_new; landmark != taken.landmarks.end(); ++landmark) {
    landmark->id = id++;
  }
  result.map = std::move(taken);
}

}  // namespace

void validate(const FeatureMapperParams& params) {
  require_in_range("cluster_radius", params.cluster_radius, 0.005, 1.0);
  require_in_range("min_hits", params.min_hits, 1, 1000000);
  require_in_range("min_viewpoints", params.min_viewpoints, 1, 100000);
  require_in_range("viewpoint_spacing", params.viewpoint_spacing, 0.01, 100.0);
  require_in_range("min_share", params.min_share, 0.0, 1.0);
  require_in_range("separation", params.separation, 0.0, 10.0);
  require_in_range("usual_deviation", params.usual_deviation, 0.0001, 1.0);
}

struct FeatureMapper::Scans {
  explicit Scans(double spacing) : viewpoints(spacing) {}

  ViewpointCover viewpoints;
  std::vector<KeptSight> sights;
  std::vector<std::size_t> viewpoint_of;  // of each scan
  std::vector<PlacedKeypoint> keypoints;

  /// None if the cluster is no landmark, and counts why.
  std::optional<Candidate> candidate_of(const Cluster& cluster, const FeatureMapperParams& params,
                                        FeatureMapReport& report) const;

  double share_of(const Cluster& cluster, const Eigen::Vector2d& middle, double radius) const {
    std::size_t expected = 0;
    for (std::size_t scan = 0; scan < sights.size(); ++scan) {
      if (cluster.scans.count(scan) > 0) {
        ++expected;
        continue;
      }
      const PlaceSight sight = sights[scan].at(middle, radius);
      const bool saw_it = cluster.views.count(viewpoint_of[scan]) > 0;
      if (sight == PlaceSight::kSeenThrough || (sight == PlaceSight::kSurface && saw_it))
        ++expected;
    }
    return static_cast<double>(cluster.scans.size()) / static_cast<double>(expected);
  }
};

std::optional<Candidate> FeatureMapper::Scans::candidate_of(const Cluster& cluster,
                                                            const FeatureMapperParams& params,
                                                            FeatureMapReport& report) const {
  if (cluster.scans.size() < static_cast<std::size_t>(params.min_hits) ||
      cluster.views.size() < static_cast<std::size_t>(params.min_viewpoints)) {
    ++report.too_few_hits;
    return std::nullopt;
  }
  const PointEstimate middle = middle_of(cluster, params.usual_deviation);
  if (share_of(cluster, middle.point, params.cluster_radius) < params.min_share) {
    ++report.too_small_share;
    return std::nullopt;
  }
  Candidate candidate;
  candidate.landmark.kind = LandmarkKind::kFeature;
  candidate.landmark.position = middle.point;
  candidate.landmark.covariance = middle.covariance;
  candidate.landmark.hits = static_cast<int>(cluster.scans.size());
  candidate.viewpoints = cluster.views.size();
  candidate.keypoints = cluster.keypoints;
  return candidate;
}

FeatureMapper::FeatureMapper(const FeatureMapperParams& params) : params_(params) {
  validate(params_);
  scans_ = std::make_unique<Scans>(params_.viewpoint_spacing);
}
FeatureMapper::~FeatureMapper() = default;
FeatureMapper::FeatureMapper(FeatureMapper&&) noexcept = default;
FeatureMapper& FeatureMapper::operator=(FeatureMapper&&) noexcept = default;

void FeatureMapper::add(const Pose2& map_T_laser, const LaserScan& scan,
                        const std::vector<PointEstimate>& keypoints) {
  const std::size_t viewpoint = scans_->viewpoints.add(map_T_laser.translation());
  for (const PointEstimate& keypoint : keypoints) {
    if (!keypoint.point.allFinite() || !is_covariance(keypoint.covariance)) continue;
    scans_->keypoints.push_back({map_T_laser * keypoint.point, 0.5 * keypoint.covariance.trace(),
                                 scans_->sights.size(), viewpoint});
  }
  scans_->sights.emplace_back(map_T_laser, scan);
  scans_->viewpoint_of.push_back(viewpoint);
}

FeatureMap FeatureMapper::build(const LandmarkMap& known) const {
  FeatureMap result{known, {}};
  FeatureMapReport& report = result.report;
  report.scans = scans_->sights.size();
  report.viewpoints = scans_->viewpoints.size();
  report.keypoints = scans_->keypoints.size();
  std::vector<Candidate> candidates;
  for (const auto& members : cluster_keypoints(scans_->keypoints, params_.cluster_radius)) {
    ++report.clusters;
    const auto candidate =
        scans_->candidate_of(cluster_of(scans_->keypoints, members), params_, report);
    if (candidate) candidates.push_back(*candidate);
  }
  append_best(candidates, params_.separation, result);
  return result;
}

}  // namespace falko_slam
