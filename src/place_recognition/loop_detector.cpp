// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/loop_detector.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "falko_slam/place_recognition/signature_index.hpp"

namespace falko_slam {
namespace {

// The first look: every 4th point, roughly.
constexpr std::size_t kRoughStride = 4;
constexpr double kRoughTolerance = 0.3;  // [m]
constexpr double kRoughRatio = 0.4;
// Alignment may correct the keypoints' pose by this much.
constexpr double kFarthestMove = 1.0;  // [m]
constexpr double kWidestTurn = 0.35;   // [rad]

TwoPointMatcherParams one_match_each(TwoPointMatcherParams params) {
  params.max_matches = 1;
  return params;
}

bool better(const LoopCandidate& a, const LoopCandidate& b) {
  if (a.score != b.score) return a.score > b.score;
  if (a.scan_score != b.scan_score) return a.scan_score > b.scan_score;
  if (a.pairs != b.pairs) return a.pairs > b.pairs;
  return a.signature_distance < b.signature_distance;
}

}  // namespace

struct LoopDetector::Memory {
  explicit Memory(const LoopDetectorParams& params)
      : builder(params.keyframe),
        matcher(one_match_each(params.matcher)),
        rival_matcher(params.matcher),
        index(params.keyframe.glare.direction_cells, 2 * params.keyframe.glare.distance_cells) {}

  KeyframeBuilder builder;
  TwoPointMatcher matcher;        // one pose for each candidate
  TwoPointMatcher rival_matcher;  // several for the best one
  SignatureIndex index;
  std::vector<Keyframe> keyframes;
  bool new_drive = false;  // the next keyframe begins one

  const Keyframe& at(KeyframeId id) const { return keyframes.at(id.value); }

  std::vector<LoopCandidate> match(const Keyframe& source, const Admission& admits,
                                   const LoopDetectorParams& params);
  LoopVerdict verify(const Keyframe& source, LoopCandidate& candidate,
                     const LoopDetectorParams& params) const;
  void verify_best(const Keyframe& source, std::vector<LoopCandidate>& candidates,
                   const LoopDetectorParams& params) const;
  Neighborhood neighborhood(KeyframeId center, std::size_t end,
                            const LoopDetectorParams& params) const;
  void ask_neighbors(const Keyframe& source, LoopCandidate& candidate,
                     const LoopDetectorParams& params) const;
  bool contradict(const LoopCandidate& a, const LoopCandidate& b,
                  const LoopDetectorParams& params) const;
  bool ambiguous(const Keyframe& source, const std::vector<LoopCandidate>& candidates,
                 const LoopDetectorParams& params);
};

const LoopCandidate* LoopDetection::accepted() const {
  const auto found = std::find_if(
      candidates.begin(), candidates.end(),
      [](const LoopCandidate& candidate) { return candidate.verdict == LoopVerdict::kAccepted; });
  return found != candidates.end() ? &*found : nullptr;
}

// The keyframes with the nearest signatures and the poses that their keypoints give, those with
// the most pairs first.
std::vector<LoopCandidate> LoopDetector::Memory::match(const Keyframe& source,
                                                       const Admission& admits,
                                                       const LoopDetectorParams& params) {
  std::vector<LoopCandidate> candidates;
  if (source.signature.empty()) return candidates;
  const auto nearest = index.nearest(source.signature, static_cast<std::size_t>(params.candidates),
                                     [&](KeyframeId id) { return admits(at(id)); });
  for (const SignatureMatch& found : nearest) {
    LoopCandidate candidate;
    candidate.target = found.id;
    candidate.signature_distance = found.distance;
    for (const MatchResult& match : matcher.match(source.points, at(found.id).points)) {
      candidate.pairs = match.pairs.size();
      candidate.target_T_source = match.target_T_source;
      candidate.verdict = LoopVerdict::kFewerPairs;
    }
    candidates.push_back(candidate);
  }
  std::stable_sort(candidates.begin(), candidates.end(), better);
  return candidates;
}

LoopVerdict LoopDetector::Memory::verify(const Keyframe& source, LoopCandidate& candidate,
                                         const LoopDetectorParams& params) const {
  const ScanView& target = at(candidate.target).view;
  const Pose2 guess = candidate.target_T_source->pose;
  AgreementParams rough = params.agreement;
  rough.tolerance = kRoughTolerance;
  if (agreement(target, source.view, guess, rough, kRoughStride).ratio() < kRoughRatio) {
    return LoopVerdict::kDisagrees;
  }
  const auto aligned = register_scans(target, source.view, guess, params.registration);
  if (!aligned) return LoopVerdict::kNotRegistered;
  const Pose2& pose = aligned->target_T_source.pose;
  const Pose2 move = guess.inverse() * pose;
  if (move.translation().norm() > kFarthestMove || std::abs(move.theta()) > kWidestTurn) {
    return LoopVerdict::kMovedAway;
  }
  candidate.target_T_source = aligned->target_T_source;
  candidate.rms_residual = aligned->rms_residual;
  candidate.scan_score = scan_score(
      agreement(target, source.view, pose, params.agreement),
      agreement(source.view, target, pose.inverse(), params.agreement), aligned->constraint);
  return LoopVerdict::kLowScore;
}

void LoopDetector::Memory::verify_best(const Keyframe& source,
                                       std::vector<LoopCandidate>& candidates,
                                       const LoopDetectorParams& params) const {
  const std::size_t count = std::min(candidates.size(), static_cast<std::size_t>(params.verified));
  for (std::size_t i = 0; i < count; ++i) {
    if (candidates[i].target_T_source)
      candidates[i].verdict = verify(source, candidates[i], params);
  }
  std::stable_sort(candidates.begin(), candidates.end(), better);
}

// The centre and the keyframes of its drive up to `end` along the way on both sides of it.
Neighborhood LoopDetector::Memory::neighborhood(KeyframeId center, std::size_t end,
                                                const LoopDetectorParams& params) const {
  const Keyframe& middle = at(center);
  Neighborhood result;
  result.members.push_back({&middle, Pose2()});
  const auto walk = [&](std::ptrdiff_t direction) {
    double last = middle.path;
    int left = params.max_neighbors;
    for (auto i = static_cast<std::ptrdiff_t>(center.value) + direction;
         i >= 0 && i < static_cast<std::ptrdiff_t>(end) && left > 0; i += direction) {
      const Keyframe& here = keyframes[static_cast<std::size_t>(i)];
      if (here.drive != middle.drive) break;
      if (std::abs(here.path - middle.path) > params.neighborhood) break;
      if (std::abs(here.path - last) < params.neighbor_spacing) continue;
      result.members.push_back({&here, middle.odom_T_laser.inverse() * here.odom_T_laser});
      last = here.path;
      --left;
    }
  };
  walk(-1);
  walk(1);
  return result;
}

void LoopDetector::Memory::ask_neighbors(const Keyframe& source, LoopCandidate& candidate,
                                         const LoopDetectorParams& params) const {
  // Nothing that came after the source, unless later places were asked for.
  const KeyframeId target = candidate.target;
  const std::size_t end = target < source.id ? source.id.value : keyframes.size();
  const Agreement neighbors = neighborhood_agreement(
      neighborhood(target, end, params), neighborhood(source.id, source.id.value + 1, params),
      candidate.target_T_source->pose, params.agreement);
  candidate.score = neighborhood_score(candidate.scan_score, neighbors);
}

// Targets of different drives do not: nothing says where one drive lies in the other, and places
// seen on two drives would refuse each other for ever.
bool LoopDetector::Memory::contradict(const LoopCandidate& a, const LoopCandidate& b,
                                      const LoopDetectorParams& params) const {
  const Keyframe& target_a = at(a.target);
  const Keyframe& target_b = at(b.target);
  if (target_a.drive != target_b.drive) return false;
  const Pose2 difference = (target_a.odom_T_laser * a.target_T_source->pose).inverse() *
                           (target_b.odom_T_laser * b.target_T_source->pose);
  const double way = std::abs(target_a.path - target_b.path);
  return difference.translation().norm() > params.contradicting_distance + params.drift * way ||
         std::abs(difference.theta()) > params.contradicting_turn;
}

// Is there a place nearly as good as the first candidate's that contradicts it? Among the other
// candidates, or by another match with the same keyframe.
bool LoopDetector::Memory::ambiguous(const Keyframe& source,
                                     const std::vector<LoopCandidate>& candidates,
                                     const LoopDetectorParams& params) {
  const LoopCandidate& best = candidates.front();
  const auto rivals = [&](const LoopCandidate& other) {
    return other.score >= params.ambiguity * best.score && contradict(best, other, params);
  };
  if (std::any_of(candidates.begin() + 1, candidates.end(),
                  [&](const LoopCandidate& other) { return other.score > 0.0 && rivals(other); })) {
    return true;
  }
  for (const MatchResult& match : rival_matcher.match(source.points, at(best.target).points)) {
    LoopCandidate other = best;
    other.target_T_source = match.target_T_source;
    if (!contradict(best, other, params)) continue;
    if (verify(source, other, params) != LoopVerdict::kLowScore) continue;
    ask_neighbors(source, other, params);
    if (rivals(other)) return true;
  }
  return false;
}

LoopDetector::LoopDetector(const LoopDetectorParams& params)
    : params_((validate(params), params)), memory_(std::make_unique<Memory>(params)) {}
LoopDetector::~LoopDetector() = default;
LoopDetector::LoopDetector(LoopDetector&&) noexcept = default;
LoopDetector& LoopDetector::operator=(LoopDetector&&) noexcept = default;

const std::vector<Keyframe>& LoopDetector::keyframes() const { return memory_->keyframes; }

KeyframeId LoopDetector::add(const LaserScan& scan, const Pose2& odom_T_laser) {
  Keyframe keyframe = memory_->builder.build(scan);
  keyframe.id = {memory_->keyframes.size()};
  keyframe.odom_T_laser = odom_T_laser;
  if (!memory_->keyframes.empty()) {
    const Keyframe& last = memory_->keyframes.back();
    keyframe.drive = last.drive + (memory_->new_drive ? 1U : 0U);
    const Eigen::Vector2d step = odom_T_laser.translation() - last.odom_T_laser.translation();
    if (!memory_->new_drive) keyframe.path = last.path + step.norm();
  }
  memory_->new_drive = false;
  if (!keyframe.signature.empty()) memory_->index.add(keyframe.id, keyframe.signature);
  memory_->keyframes.push_back(std::move(keyframe));
  return memory_->keyframes.back().id;
}

void LoopDetector::begin_drive() { memory_->new_drive = !memory_->keyframes.empty(); }

LoopDetection LoopDetector::detect(KeyframeId id, const Admission& admits) {
  const Keyframe& source = memory_->at(id);
  const auto admitted = [&](const Keyframe& target) {
    if (target.id == id) return false;
    if (admits) return admits(target);
    if (target.id.value > id.value) return false;
    return target.drive != source.drive || source.path - target.path >= params_.min_path;
  };
  LoopDetection detection{memory_->match(source, admitted, params_)};
  memory_->verify_best(source, detection.candidates, params_);
  int left = params_.compared;
  for (LoopCandidate& candidate : detection.candidates) {
    if (candidate.verdict != LoopVerdict::kLowScore || left-- == 0) break;
    memory_->ask_neighbors(source, candidate, params_);
    if (candidate.score >= params_.min_score) candidate.verdict = LoopVerdict::kNotBest;
  }
  std::stable_sort(detection.candidates.begin(), detection.candidates.end(), better);
  if (!detection.candidates.empty()) {
    LoopVerdict& best = detection.candidates.front().verdict;
    if (best == LoopVerdict::kNotBest) {
      best = memory_->ambiguous(source, detection.candidates, params_) ? LoopVerdict::kAmbiguous
                                                                       : LoopVerdict::kAccepted;
    }
  }
  return detection;
}

std::vector<LoopCandidate> LoopDetector::locate(const LaserScan& scan, std::size_t count,
                                                const Admission& admits) {
  const Keyframe source = memory_->builder.build(scan);
  auto candidates = memory_->match(
      source, [&](const Keyframe& target) { return !admits || admits(target); }, params_);
  memory_->verify_best(source, candidates, params_);
  const auto end =
      std::remove_if(candidates.begin(), candidates.end(),
                     [](const LoopCandidate& candidate) { return candidate.scan_score <= 0.0; });
  candidates.erase(end, candidates.end());
  for (LoopCandidate& candidate : candidates) candidate.score = candidate.scan_score;
  if (candidates.size() > count) candidates.resize(count);
  return candidates;
}

}  // namespace falko_slam
