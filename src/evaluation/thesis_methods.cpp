// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/thesis_methods.hpp"

#include <algorithm>
#include <memory>
#include <random>
#include <stdexcept>
#include <utility>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/features/falko.hpp"
#include "falko_slam/features/flirt.hpp"
#include "falko_slam/matching/affine_hough.hpp"
#include "falko_slam/matching/correspondence_graph.hpp"
#include "falko_slam/matching/ransac.hpp"

namespace falko_slam {
namespace {

using MatchPoints = std::vector<MatchPoint>;

enum class Detector { kFalko, kFlirt };
enum class Retrieval { kGlarot, kGsr, kGfp };
enum class Association { kGraph, kHough, kRansac };

struct Recipe {
  std::string name;
  Detector detector;
  Retrieval retrieval;
  Association association;
};

const std::vector<Recipe>& recipes() {
  static const std::vector<Recipe> all = {
      {"GFP", Detector::kFlirt, Retrieval::kGfp, Association::kRansac},
      {"GSR-FLIRT", Detector::kFlirt, Retrieval::kGsr, Association::kRansac},
      {"GSR-FALKO", Detector::kFalko, Retrieval::kGsr, Association::kRansac},
      {"GLAROT-RANSAC", Detector::kFalko, Retrieval::kGlarot, Association::kRansac},
      {"GLAROT-AH", Detector::kFalko, Retrieval::kGlarot, Association::kHough},
      {"GLAROT-CG", Detector::kFalko, Retrieval::kGlarot, Association::kGraph}};
  return all;
}

// Keypoints of the source with a neighbour in the target after alignment.
double neighbors(const MatchPoints& source, const MatchPoints& target, const Pose2& target_T_source,
                 double distance) {
  const auto has_neighbor = [&](const MatchPoint& point) {
    const Eigen::Vector2d moved = target_T_source * point.position;
    return std::any_of(target.begin(), target.end(), [&](const MatchPoint& other) {
      return (other.position - moved).norm() < distance;
    });
  };
  return static_cast<double>(std::count_if(source.begin(), source.end(), has_neighbor));
}

// What a method keeps of a log, and how it answers.
class Chain {
 public:
  Chain(const Recipe& recipe, const ThesisMethodParams& params)
      : recipe_(recipe), params_(params) {}

  LoopTiming detect(const std::vector<PosedScan>& scans) {
    FalkoDetector falko;
    FlirtDetector flirt;
    std::vector<double> times;
    for (const PosedScan& scan : scans) {
      times.push_back(milliseconds_of([&] {
        keypoints_.push_back(recipe_.detector == Detector::kFalko ? falko.detect(scan.scan)
                                                                  : flirt.detect(scan.scan));
      }));
      points_.emplace_back();
      for (const Keypoint& keypoint : keypoints_.back()) {
        points_.back().push_back({keypoint.position, keypoint.orientation});
      }
    }
    return loop_timing(std::move(times));
  }

  LoopTiming sign(const std::vector<PosedScan>& scans) {
    switch (recipe_.retrieval) {
      case Retrieval::kGlarot:
        retrieval_ = glarot_retrieval(keypoints_, params_.glare);
        break;
      case Retrieval::kGsr:
        retrieval_ = gsr_retrieval(scans, keypoints_, params_.gsr, params_.normals);
        break;
      case Retrieval::kGfp:
        retrieval_ = gfp_retrieval(scans, keypoints_, params_.gfp);
        break;
    }
    return retrieval_.creation;
  }

  LoopTrial close(std::size_t source, const LoopTruth& truth) {
    LoopTrial trial;
    std::vector<std::size_t> targets;
    trial.search = milliseconds_of([&] {
      targets = retrieval_.nearest(
          source, candidates(), [&](std::size_t target) { return truth.admits(source, target); });
    });
    random_.seed(params_.seed * 0x9e3779b97f4a7c15U + source);
    for (const std::size_t target : targets) {
      const MatchResult match = associate(points_[source], points_[target]);
      if (!match.found()) continue;
      const Pose2& pose = match.target_T_source->pose;
      const double score =
          neighbors(points_[source], points_[target], pose, params_.neighbor_distance);
      if (!trial.closure || score > trial.closure->score) trial.closure = {target, score, pose};
    }
    return trial;
  }

 private:
  std::size_t candidates() const {
    return static_cast<std::size_t>(recipe_.retrieval == Retrieval::kGfp ? params_.gfp_candidates
                                                                         : params_.candidates);
  }
  MatchResult associate(const MatchPoints& source, const MatchPoints& target) {
    if (recipe_.association == Association::kGraph) return graph_.match(source, target);
    if (recipe_.association == Association::kHough) return hough_.match(source, target);
    return match_by_ransac(source, target, random_);
  }

  Recipe recipe_;
  ThesisMethodParams params_;
  ScanKeypoints keypoints_;
  std::vector<MatchPoints> points_;
  ScanRetrieval retrieval_;
  CorrespondenceGraphMatcher graph_;
  AffineHoughMatcher hough_;
  std::mt19937_64 random_;
};

}  // namespace

void validate(const ThesisMethodParams& params) {
  require_in_range("candidates", params.candidates, 1, 1000);
  require_in_range("gfp_candidates", params.gfp_candidates, 1, 1000);
  require_in_range("neighbor_distance", params.neighbor_distance, 0.0, 100.0);
  validate(params.glare);
  validate(params.gsr);
  validate(params.gfp.vocabulary);
  validate(params.gfp.phrases);
}

std::vector<std::string> thesis_method_names() {
  std::vector<std::string> names;
  for (const Recipe& recipe : recipes()) names.push_back(recipe.name);
  return names;
}

LoopMethod thesis_method(const std::string& name, const std::vector<PosedScan>& scans,
                         const ThesisMethodParams& params) {
  validate(params);
  const auto recipe = std::find_if(recipes().begin(), recipes().end(),
                                   [&](const Recipe& known) { return known.name == name; });
  if (recipe == recipes().end()) throw std::invalid_argument("no method of the thesis: " + name);
  const auto chain = std::make_shared<Chain>(*recipe, params);
  LoopMethod method;
  method.name = name;
  method.detection = chain->detect(scans);
  method.creation = chain->sign(scans);
  method.close = [chain](std::size_t source, const LoopTruth& truth) {
    return chain->close(source, truth);
  };
  return method;
}

}  // namespace falko_slam
