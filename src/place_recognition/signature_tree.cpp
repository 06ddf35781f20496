// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "signature_tree.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace falko_slam {
namespace {

constexpr std::uint32_t kLeafSize = 16;

bool before(const SignatureMatch& a, const SignatureMatch& b) {
  return a.distance != b.distance ? a.distance < b.distance : a.id < b.id;
}

}  // namespace

void SignatureBlock::add(KeyframeId id, const Signature& signature) {
  ids.push_back(id);
  removed.push_back(false);
  cells.insert(cells.end(), signature.cells.begin(), signature.cells.end());
  for (const std::uint16_t sum : falko_slam::row_sums(signature)) row_sums.push_back(sum);
  for (const std::uint16_t sum : falko_slam::column_sums(signature)) column_sums.push_back(sum);
  for (const std::uint8_t cell : sorted_columns(signature)) sorted.push_back(cell);
  groups.push_back(group_sums(signature));
}

void SignatureBlock::add(const SignatureBlock& other, std::size_t i) {
  ids.push_back(other.ids[i]);
  removed.push_back(other.removed[i]);
  cells.insert(cells.end(), other.cells_of(i), other.cells_of(i) + cell_count());
  row_sums.insert(row_sums.end(), other.rows_of(i), other.rows_of(i) + rows);
  column_sums.insert(column_sums.end(), other.columns_of(i), other.columns_of(i) + columns);
  sorted.insert(sorted.end(), other.sorted_of(i), other.sorted_of(i) + cell_count());
  groups.push_back(other.groups[i]);
}

std::uint32_t BestMatches::limit() const {
  if (count_ == 0) return 0;
  return matches_.size() < count_ ? std::numeric_limits<std::uint32_t>::max()
                                  : matches_.back().distance;
}

void BestMatches::offer(const SignatureQuery& query, const SignatureBlock& block, std::size_t i) {
  if (count_ == 0 || block.removed[i]) return;
  const std::uint32_t worst = limit();
  if (l1_distance(block.groups[i].data(), query.groups().data(), kColumnGroups) > worst) return;
  if (l1_distance(block.columns_of(i), query.columns().data(), query.columns().size()) > worst) {
    return;
  }
  if (l1_distance(block.sorted_of(i), query.sorted().data(), block.cell_count()) > worst) return;
  compare(query, block, i);
}

void BestMatches::compare(const SignatureQuery& query, const SignatureBlock& block, std::size_t i) {
  if (count_ == 0 || (admits_ && !admits_(block.ids[i]))) return;
  const ShiftedDistance found = query.distance_to(block.cells_of(i), block.rows_of(i));
  const SignatureMatch match{block.ids[i], found.distance, found.shift};
  if (matches_.size() == count_) {
    if (!before(match, matches_.back())) return;
    matches_.pop_back();
  }
  matches_.insert(std::upper_bound(matches_.begin(), matches_.end(), match, before), match);
}

SignatureTree::SignatureTree(const SignatureBlock& entries) {
  block.rows = entries.rows;
  block.columns = entries.columns;
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < entries.size(); ++i) {
    if (!entries.removed[i]) order.push_back(i);
  }
  if (order.empty()) return;
  build(entries, order, 0, static_cast<std::uint32_t>(order.size()));
  for (const std::uint32_t i : order) block.add(entries, i);
}

std::size_t SignatureTree::add_box(const SignatureBlock& entries,
                                   const std::vector<std::uint32_t>& order, std::uint32_t begin,
                                   std::uint32_t end) {
  const auto columns = static_cast<std::size_t>(entries.columns);
  const std::size_t node = nodes_.size();
  nodes_.push_back({begin, end, 0});
  lowest_.resize((node + 1) * columns, std::numeric_limits<std::uint16_t>::max());
  highest_.resize((node + 1) * columns, 0);
  for (std::uint32_t i = begin; i < end; ++i) {
    const std::uint16_t* sums = entries.columns_of(order[i]);
    for (std::size_t c = 0; c < columns; ++c) {
      std::uint16_t& low = lowest_[node * columns + c];
      std::uint16_t& high = highest_[node * columns + c];
      low = std::min(low, sums[c]);
      high = std::max(high, sums[c]);
    }
  }
  return node;
}

void SignatureTree::build(const SignatureBlock& entries, std::vector<std::uint32_t>& order,
                          std::uint32_t begin, std::uint32_t end) {
  const std::size_t node = add_box(entries, order, begin, end);
  if (end - begin <= kLeafSize) return;
  const auto columns = static_cast<std::size_t>(entries.columns);
  std::size_t widest = 0;
  const auto width = [&](std::size_t c) {
    return highest_[node * columns + c] - lowest_[node * columns + c];
  };
  for (std::size_t c = 1; c < columns; ++c) {
    if (width(c) > width(widest)) widest = c;
  }
  if (width(widest) == 0) return;  // all alike: no box could tell them apart
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(order.begin() + begin, order.begin() + middle, order.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) {
                     const auto left = entries.columns_of(a)[widest];
                     const auto right = entries.columns_of(b)[widest];
                     return left != right ? left < right : a < b;
                   });
  build(entries, order, begin, middle);
  nodes_[node].right = static_cast<std::uint32_t>(nodes_.size());
  build(entries, order, middle, end);
}

std::uint32_t SignatureTree::bound(const SignatureQuery& query, std::size_t node) const {
  const std::size_t columns = query.columns().size();
  const std::uint16_t* low = lowest_.data() + node * columns;
  const std::uint16_t* high = highest_.data() + node * columns;
  const std::uint16_t* at = query.columns().data();
  int sum = 0;
  for (std::size_t c = 0; c < columns; ++c) {
    sum +=
        std::max(0, std::max(static_cast<int>(low[c]) - at[c], static_cast<int>(at[c]) - high[c]));
  }
  return static_cast<std::uint32_t>(sum);
}

void SignatureTree::search(const SignatureQuery& query, BestMatches& best) const {
  if (!nodes_.empty()) search(query, 0, best);
}

void SignatureTree::search(const SignatureQuery& query, std::size_t node, BestMatches& best) const {
  const Node& here = nodes_[node];
  if (here.right == 0) {
    for (std::size_t i = here.begin; i < here.end; ++i) best.offer(query, block, i);
    return;
  }
  std::size_t near = node + 1;
  std::size_t far = here.right;
  std::uint32_t near_bound = bound(query, near);
  std::uint32_t far_bound = bound(query, far);
  if (far_bound < near_bound) {
    std::swap(near, far);
    std::swap(near_bound, far_bound);
  }
  if (near_bound <= best.limit()) search(query, near, best);
  if (far_bound <= best.limit()) search(query, far, best);
}

}  // namespace falko_slam
