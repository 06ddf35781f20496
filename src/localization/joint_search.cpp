// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "joint_search.hpp"

#include <algorithm>
#include <cmath>

namespace falko_slam {
namespace {

constexpr std::size_t kMostRivals = 64;
constexpr std::size_t kSeeds = 8;
constexpr std::size_t kNoPair = static_cast<std::size_t>(-1);

// What a standard normal variable stays below with this probability.
double normal_quantile(double probability) {
  double low = -40.0, high = 40.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (0.5 * std::erfc(-middle / std::sqrt(2.0)) < probability ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// The pairs of one observation, the nearest first.
struct Branch {
  std::size_t observation = 0;
  std::vector<std::size_t> pairs;
};

std::vector<Branch> branches_of(const JointPairs& all) {
  std::vector<Branch> branches;
  for (std::size_t i = 0; i < all.pairs.size(); ++i) {
    const std::size_t observation = all.pairs[i].observation;
    if (branches.empty() || branches.back().observation != observation) {
      branches.push_back({observation, {}});
    }
    branches.back().pairs.push_back(i);
  }
  const auto distance = [&](std::size_t pair) { return all.pairs[pair].distance; };
  for (Branch& branch : branches) {
    std::stable_sort(branch.pairs.begin(), branch.pairs.end(),
                     [&](auto a, auto b) { return distance(a) < distance(b); });
  }
  std::stable_sort(branches.begin(), branches.end(), [&](const Branch& a, const Branch& b) {
    if (a.pairs.size() != b.pairs.size()) return a.pairs.size() < b.pairs.size();
    return distance(a.pairs.front()) < distance(b.pairs.front());
  });
  return branches;
}

struct PairSet {
  std::vector<std::size_t> pairs;
  double distance = 0.0;
};

class Search {
 public:
  Search(const JointPairs& all, JointDistance& distance, const JointSearchParams& params)
      : all_(all),
        distance_(distance),
        params_(params),
        branches_(branches_of(all)),
        taken_(all.landmarks, false),
        gates_(joint_gates(params.joint_probability, branches_.size())) {}

  JointSelection run() {
    for (std::size_t i = 0; i < std::min(kSeeds, branches_.size()); ++i) {
      if (most_ < branches_.size()) grow_from(i);
    }
    if (!cannot_have_rivals()) descend(0, 0.0);
    JointSelection selection;
    selection.proven = nodes_ <= params_.max_nodes;
    if (sets_.empty()) return selection;
    const auto best = std::min_element(
        sets_.begin(), sets_.end(),
        [](const PairSet& a, const PairSet& b) { return a.distance < b.distance; });
    selection.most = best->pairs.size();
    selection.distance = best->distance;
    selection.ambiguous = differing(*best);
    for (const std::size_t pair : best->pairs) {
      if (!contains(selection.ambiguous, all_.pairs[pair].observation)) {
        selection.pairs.push_back(pair);
      }
    }
    std::sort(selection.pairs.begin(), selection.pairs.end());
    return selection;
  }

 private:
  static bool contains(const std::vector<std::size_t>& list, std::size_t value) {
    return std::find(list.begin(), list.end(), value) != list.end();
  }

  // No set of this branch can be larger than the best, or as large and no worse than a rival.
  bool hopeless(std::size_t depth, double distance) const {
    const std::size_t possible = chosen_.size() + branches_.size() - depth;
    return possible < most_ || (possible == most_ && distance > least_ + params_.ambiguity);
  }

  bool fits(std::size_t count, double before, double joint) const {
    return joint <= gates_[count + 1] && joint - before <= params_.step_gate;
  }

  // A first set to prune by: all that fits to one pair, were it right. Without it the search lies
  // for long below a wrong pair at its root.
  void grow_from(std::size_t seed) {
    if (nodes_ + 2 * static_cast<int>(branches_.size()) > params_.max_nodes) return;
    nodes_ += 2 * static_cast<int>(branches_.size());
    std::vector<std::size_t> found(branches_.size(), kNoPair);
    double distance = distance_.with(0, found[seed] = branches_[seed].pairs.front());
    std::size_t count = 1;
    taken_[all_.pairs[found[seed]].landmark] = true;
    for (std::size_t i = 0; i < branches_.size(); ++i) {
      if (i == seed) continue;
      for (const std::size_t pair : branches_[i].pairs) {
        if (taken_[all_.pairs[pair].landmark]) continue;
        const double joint = distance_.with(count, pair);
        if (!fits(count, distance, joint)) continue;
        found[i] = pair;
        taken_[all_.pairs[pair].landmark] = true;
        distance = joint;
        ++count;
        break;
      }
    }
    taken_.assign(taken_.size(), false);
    seed == 0 ? keep_found(found, distance) : keep_in_order(found);
  }

  // One set holds everything, and nothing in it could be paired otherwise.
  bool cannot_have_rivals() const {
    return most_ == branches_.size() && most_ == all_.pairs.size();
  }

  void keep_found(const std::vector<std::size_t>& found, double distance) {
    for (const std::size_t pair : found) {
      if (pair != kNoPair) chosen_.push_back(pair);
    }
    keep(distance);
    chosen_.clear();
  }

  // Keeps a set if it is one that the search could come to.
  void keep_in_order(const std::vector<std::size_t>& found) {
    double distance = 0.0;
    bool good = true;
    for (const std::size_t pair : found) {
      if (pair == kNoPair || !good) continue;
      const double joint = distance_.with(chosen_.size(), pair);
      good = fits(chosen_.size(), distance, joint);
      distance = joint;
      chosen_.push_back(pair);
    }
    if (good && !hopeless(branches_.size(), distance)) keep(distance);
    chosen_.clear();
  }

  void descend(std::size_t depth, double distance) {
    if (hopeless(depth, distance)) return;
    if (depth == branches_.size()) return keep(distance);
    for (const std::size_t pair : branches_[depth].pairs) {
      const std::size_t landmark = all_.pairs[pair].landmark;
      if (taken_[landmark]) continue;
      if (++nodes_ > params_.max_nodes) return keep(distance);
      const double joint = distance_.with(chosen_.size(), pair);
      if (!fits(chosen_.size(), distance, joint)) continue;
      taken_[landmark] = true;
      chosen_.push_back(pair);
      descend(depth + 1, joint);
      chosen_.pop_back();
      taken_[landmark] = false;
      if (nodes_ > params_.max_nodes) return;
    }
    descend(depth + 1, distance);
  }

  void keep(double distance) {
    if (chosen_.empty() || chosen_.size() < most_) return;
    if (chosen_.size() > most_) sets_.clear();
    const bool better = chosen_.size() > most_ || distance < least_;
    most_ = chosen_.size();
    if (better) {
      least_ = distance;
      const auto far = [&](const PairSet& set) {
        return set.distance > least_ + params_.ambiguity;
      };
      sets_.erase(std::remove_if(sets_.begin(), sets_.end(), far), sets_.end());
    } else if (sets_.size() >= kMostRivals) {
      return;
    }
    sets_.push_back({chosen_, distance});
  }

  // Observations that some set pairs otherwise than the best does, or does not pair.
  std::vector<std::size_t> differing(const PairSet& best) const {
    std::vector<std::size_t> result;
    const auto note = [&](const PairSet& set, const PairSet& other) {
      for (const std::size_t pair : set.pairs) {
        const std::size_t observation = all_.pairs[pair].observation;
        if (!contains(other.pairs, pair) && !contains(result, observation)) {
          result.push_back(observation);
        }
      }
    };
    for (const PairSet& set : sets_) {
      note(set, best);
      note(best, set);
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  const JointPairs& all_;
  JointDistance& distance_;
  const JointSearchParams& params_;
  std::vector<Branch> branches_;
  std::vector<bool> taken_;
  std::vector<double> gates_;
  std::vector<std::size_t> chosen_;
  std::vector<PairSet> sets_;
  std::size_t most_ = 0;
  double least_ = 0.0;
  int nodes_ = 0;
};

}  // namespace

double pair_gate(double probability) { return -2.0 * std::log1p(-probability); }

std::vector<double> joint_gates(double probability, std::size_t most) {
  const double z = normal_quantile(probability);
  std::vector<double> gates = {0.0, pair_gate(probability)};
  for (std::size_t pairs = 2; pairs <= most; ++pairs) {
    const double n = 2.0 * static_cast<double>(pairs), spread = 2.0 / (9.0 * n);
    gates.push_back(n * std::pow(1.0 - spread + z * std::sqrt(spread), 3.0));
  }
  return gates;
}

JointSelection search_jointly(const JointPairs& pairs, JointDistance& distance,
                              const JointSearchParams& params) {
  return Search(pairs, distance, params).run();
}

}  // namespace falko_slam
