// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/matching/maximum_clique.hpp"

#include <algorithm>
#include <limits>

namespace falko_slam {
namespace {

std::size_t lowest_bit(std::uint64_t word) {
  return static_cast<std::size_t>(__builtin_ctzll(word));
}

std::size_t count_bits(const std::uint64_t* row, std::size_t words) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < words; ++i) {
    count += static_cast<std::size_t>(__builtin_popcountll(row[i]));
  }
  return count;
}

template <class Visit>
void for_each_bit(const std::uint64_t* row, std::size_t words, Visit visit) {
  for (std::size_t i = 0; i < words; ++i) {
    for (std::uint64_t word = row[i]; word != 0; word &= word - 1) visit(i * 64 + lowest_bit(word));
  }
}

}  // namespace

// The vertex of least degree in what is left goes last, again and again.
void MaximumClique::relabel_by_degeneracy(const BitGraph& graph) {
  constexpr std::size_t kPlaced = std::numeric_limits<std::size_t>::max();
  const std::size_t n = graph.size();
  degree_.resize(n);
  order_.resize(n);
  for (std::size_t v = 0; v < n; ++v) degree_[v] = count_bits(graph.row(v), graph.words());
  for (std::size_t place = n; place-- > 0;) {
    const auto least = std::min_element(degree_.begin(), degree_.end());
    const auto vertex = static_cast<std::size_t>(least - degree_.begin());
    *least = kPlaced;
    order_[place] = vertex;
    for_each_bit(graph.row(vertex), graph.words(), [&](std::size_t neighbor) {
      if (degree_[neighbor] != kPlaced) --degree_[neighbor];
    });
  }
  std::vector<std::size_t>& label = degree_;  // no longer needed as such
  for (std::size_t place = 0; place < n; ++place) label[order_[place]] = place;
  graph_.reset(n);
  for (std::size_t v = 0; v < n; ++v) {
    for_each_bit(graph.row(v), graph.words(), [&](std::size_t neighbor) {
      if (neighbor > v) graph_.add_edge(label[v], label[neighbor]);
    });
  }
}

// Lists the candidates whose colour exceeds `colors_without_gain`, by ascending colour: a clique
// has at most one vertex of each colour.
void MaximumClique::color(Level& level, std::size_t colors_without_gain) {
  const std::size_t words = graph_.words();
  level.branches.clear();
  uncolored_ = level.candidates;
  std::size_t first = 0;  // word that may hold uncoloured vertices
  for (std::size_t number = 1;; ++number) {
    while (first < words && uncolored_[first] == 0) ++first;
    if (first == words) return;
    color_class_ = uncolored_;
    for (std::size_t i = first; i < words; ++i) {
      while (color_class_[i] != 0) {
        const std::size_t bit = lowest_bit(color_class_[i]);
        const std::size_t vertex = i * 64 + bit;
        const Word* neighbors = graph_.row(vertex);
        uncolored_[i] &= ~(Word{1} << bit);
        color_class_[i] &= ~(Word{1} << bit);
        for (std::size_t j = i; j < words; ++j) color_class_[j] &= ~neighbors[j];
        if (number > colors_without_gain) level.branches.push_back({vertex, number});
      }
    }
  }
}

void MaximumClique::expand(std::size_t depth) {
  if (++nodes_ > limits_.max_nodes) return;
  Level& level = levels_[depth];
  const std::size_t words = graph_.words();
  std::vector<Word>& below = levels_[depth + 1].candidates;
  below.resize(words);
  color(level, best_size_ > clique_.size() ? best_size_ - clique_.size() : 0);
  for (std::size_t b = level.branches.size(); b-- > 0;) {
    const auto [vertex, bound] = level.branches[b];
    if (clique_.size() + bound <= best_size_) return;
    Word any = 0;
    for (std::size_t i = 0; i < words; ++i) {
      below[i] = level.candidates[i] & graph_.row(vertex)[i];
      any |= below[i];
    }
    level.candidates[vertex / 64] &= ~(Word{1} << (vertex % 64));
    clique_.push_back(vertex);
    if (any != 0) {
      expand(depth + 1);
    } else if (clique_.size() > best_size_) {
      best_ = clique_;
      best_size_ = clique_.size();
    }
    clique_.pop_back();
    if (nodes_ > limits_.max_nodes) return;
  }
}

CliqueResult MaximumClique::search(const BitGraph& graph, const CliqueLimits& limits) {
  limits_ = limits;
  best_.clear();
  best_size_ = limits.larger_than;
  clique_.clear();
  nodes_ = 0;
  CliqueResult result;
  if (graph.size() == 0) return result;
  relabel_by_degeneracy(graph);
  if (levels_.size() < graph.size() + 1) levels_.resize(graph.size() + 1);
  levels_[0].candidates.assign(graph_.words(), 0);
  for (std::size_t v = 0; v < graph_.size(); ++v) {
    levels_[0].candidates[v / 64] |= Word{1} << (v % 64);
  }
  expand(0);
  for (const std::size_t vertex : best_) result.vertices.push_back(order_[vertex]);
  std::sort(result.vertices.begin(), result.vertices.end());
  result.proven = nodes_ <= limits_.max_nodes;
  result.nodes = std::min(nodes_, limits_.max_nodes);
  return result;
}

}  // namespace falko_slam
