// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/loop_evaluation.hpp"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <optional>
#include <random>
#include <utility>

#include "falko_slam/features/falko.hpp"
#include "falko_slam/matching/affine_hough.hpp"
#include "falko_slam/matching/correspondence_graph.hpp"
#include "falko_slam/matching/ransac.hpp"
#include "falko_slam/place_recognition/glare.hpp"
#include "falko_slam/place_recognition/signature_index.hpp"

namespace falko_slam {
namespace {

struct Closure {
  std::size_t target = 0;
  double score = 0.0;
  Pose2 target_T_source;
};

// Answers a scan under the truth's protocol; empty: not closed.
using Method = std::function<std::optional<Closure>(std::size_t source, const LoopTruth& truth)>;

template <class Work>
double milliseconds_of(Work&& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
      .count();
}

LoopTiming timing_of(std::vector<double> times) {
  if (times.empty()) return {};
  std::sort(times.begin(), times.end());
  const double sum = std::accumulate(times.begin(), times.end(), 0.0);
  return {sum / static_cast<double>(times.size()), times[times.size() / 2],
          times[times.size() * 99 / 100]};
}

LoopMethodResult run(const std::string& name, const Method& method, LoopProtocol protocol,
                     const LoopTruth& truth, const LoopTiming& creation,
                     std::vector<LoopAnswer>& answers) {
  LoopMethodResult result;
  result.method = name;
  result.protocol = protocol;
  result.scans = truth.scans();
  result.loops = truth.loops();
  result.creation = creation;
  answers.assign(truth.scans(), {});
  std::vector<double> times;
  for (std::size_t source = 0; source < truth.scans(); ++source) {
    std::optional<Closure> closure;
    times.push_back(milliseconds_of([&] { closure = method(source, truth); }));
    answers[source].has_loop = truth.has_loop(source);
    if (!closure) continue;
    answers[source].closed = true;
    answers[source].score = closure->score;
    answers[source].right = truth.is_right(source, closure->target, closure->target_T_source);
  }
  result.closing = timing_of(std::move(times));
  result.curve = loop_curve(answers);
  result.summary = summarize(result.curve);
  return result;
}

// GLAROT of FALKO keypoints: the thesis' chain up to the association.
class Glarot {
 public:
  using Associate = std::function<MatchResult(const std::vector<MatchPoint>& source,
                                              const std::vector<MatchPoint>& target)>;

  Glarot(const std::vector<PosedScan>& scans, const LoopEvaluationParams& params)
      : params_(params) {
    FalkoDetector falko;
    const GlareParams& glare_params = params.detector.keyframe.glare;
    index_ = SignatureIndex(glare_params.direction_cells, glare_params.distance_cells);
    std::vector<double> times;
    for (const PosedScan& scan : scans) {
      times.push_back(milliseconds_of([&] {
        points_.emplace_back();
        std::vector<Eigen::Vector2d> positions;
        for (const Keypoint& keypoint : falko.detect(scan.scan)) {
          points_.back().push_back({keypoint.position});
          positions.push_back(keypoint.position);
        }
        signatures_.push_back(glare(positions, glare_params));
        index_.add({signatures_.size() - 1}, signatures_.back());
      }));
    }
    creation_ = timing_of(std::move(times));
  }

  const LoopTiming& creation() const { return creation_; }

  std::optional<Closure> close(std::size_t source, const LoopTruth& truth,
                               const Associate& associate) const {
    std::optional<Closure> best;
    const auto nearest = index_.nearest(
        signatures_[source], static_cast<std::size_t>(params_.candidates),
        [&](KeyframeId id) { return truth.admits(source, static_cast<std::size_t>(id.value)); });
    for (const SignatureMatch& found : nearest) {
      const auto target = static_cast<std::size_t>(found.id.value);
      const MatchResult match = associate(points_[source], points_[target]);
      if (!match.found()) continue;
      const Pose2& pose = match.target_T_source->pose;
      const double score = neighbors(source, target, pose);
      if (!best || score > best->score) best = Closure{target, score, pose};
    }
    return best;
  }

 private:
  // Keypoints of the source with a neighbour in the target after alignment.
  double neighbors(std::size_t source, std::size_t target, const Pose2& pose) const {
    const auto near = [&](const MatchPoint& point) {
      const Eigen::Vector2d moved = pose * point.position;
      return std::any_of(points_[target].begin(), points_[target].end(),
                         [&](const MatchPoint& other) {
                           return (other.position - moved).norm() < params_.neighbor_distance;
                         });
    };
    return static_cast<double>(std::count_if(points_[source].begin(), points_[source].end(), near));
  }

  const LoopEvaluationParams& params_;
  std::vector<std::vector<MatchPoint>> points_;
  std::vector<Signature> signatures_;
  SignatureIndex index_{1, 1};
  LoopTiming creation_;
};

// The curve is that of the best candidates, the ambiguous ones too: what the scores can tell.
LoopMethodResult run_detector(LoopDetector& detector, LoopProtocol protocol, const LoopTruth& truth,
                              const LoopTiming& creation) {
  std::vector<LoopVerdict> verdicts(truth.scans(), LoopVerdict::kNotMatched);
  const Method method = [&](std::size_t source, const LoopTruth&) -> std::optional<Closure> {
    const LoopDetection detection = detector.detect({source}, [&](const Keyframe& target) {
      return truth.admits(source, static_cast<std::size_t>(target.id.value));
    });
    if (detection.candidates.empty()) return std::nullopt;
    const LoopCandidate& best = detection.candidates.front();
    if (best.score <= 0.0) return std::nullopt;
    verdicts[source] = best.verdict;
    return Closure{static_cast<std::size_t>(best.target.value), best.score,
                   best.target_T_source->pose};
  };
  std::vector<LoopAnswer> answers;
  LoopMethodResult result = run("falko_slam", method, protocol, truth, creation, answers);
  for (std::size_t source = 0; source < answers.size(); ++source) {
    if (verdicts[source] != LoopVerdict::kAccepted) answers[source].closed = false;
    result.ambiguous += verdicts[source] == LoopVerdict::kAmbiguous ? 1U : 0U;
  }
  result.accepted = operating_point(answers, detector.params().min_score);
  return result;
}

}  // namespace

std::vector<LoopMethodResult> evaluate_loops(const std::vector<PosedScan>& scans,
                                             const LoopEvaluationParams& params,
                                             const std::function<void(const std::string&)>& tell) {
  tell("signatures");
  const Glarot glarot(scans, params);
  CorrespondenceGraphMatcher graph;
  AffineHoughMatcher hough;
  std::mt19937_64 random(params.seed);
  const std::vector<std::pair<std::string, Glarot::Associate>> matchers = {
      {"GLAROT-CG",
       [&](const auto& source, const auto& target) { return graph.match(source, target); }},
      {"GLAROT-AH",
       [&](const auto& source, const auto& target) { return hough.match(source, target); }},
      {"GLAROT-RANSAC", [&](const auto& source, const auto& target) {
         return match_by_ransac(source, target, random);
       }}};

  LoopDetector detector(params.detector);
  std::vector<double> times;
  for (const PosedScan& scan : scans) {
    times.push_back(milliseconds_of([&] { detector.add(scan.scan, scan.map_T_laser); }));
  }
  const LoopTiming creation = timing_of(std::move(times));

  std::vector<LoopMethodResult> results;
  for (const LoopProtocol protocol : params.protocols) {
    const LoopTruth truth(scans, protocol, params.protocol);
    for (const auto& [name, associate] : matchers) {
      tell(name + " " + name_of(protocol));
      const Method method = [&, &chosen = associate](std::size_t source, const LoopTruth& t) {
        return glarot.close(source, t, chosen);
      };
      std::vector<LoopAnswer> answers;
      results.push_back(run(name, method, protocol, truth, glarot.creation(), answers));
    }
    tell(std::string("falko_slam ") + name_of(protocol));
    results.push_back(run_detector(detector, protocol, truth, creation));
  }
  return results;
}

}  // namespace falko_slam
