// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "falko_slam/place_recognition/signature_index.hpp"
#include "signature_query.hpp"

namespace falko_slam {

/// The signatures of a tree, one behind the other, with their sums.
struct SignatureBlock {
  int rows = 0;
  int columns = 0;
  std::vector<KeyframeId> ids;
  std::vector<bool> removed;
  std::vector<std::uint8_t> cells;
  std::vector<std::uint16_t> row_sums;
  std::vector<std::uint16_t> column_sums;
  std::vector<std::uint8_t> sorted;
  std::vector<GroupSums> groups;

  std::size_t size() const { return ids.size(); }
  std::size_t cell_count() const {
    return static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
  }
  const std::uint8_t* cells_of(std::size_t i) const { return cells.data() + i * cell_count(); }
  const std::uint8_t* sorted_of(std::size_t i) const { return sorted.data() + i * cell_count(); }
  const std::uint16_t* rows_of(std::size_t i) const {
    return row_sums.data() + i * static_cast<std::size_t>(rows);
  }
  const std::uint16_t* columns_of(std::size_t i) const {
    return column_sums.data() + i * static_cast<std::size_t>(columns);
  }
  void add(KeyframeId id, const Signature& signature);
  /// Copies entry i of a block of the same shape.
  void add(const SignatureBlock& other, std::size_t i);
};

/// The best answers so far, in order.
class BestMatches {
 public:
  BestMatches(std::size_t count, const SignatureIndex::Admission& admits)
      : count_(count), admits_(admits) {}

  /// What is farther than this is no answer any more.
  std::uint32_t limit() const;
  /// Compares the entry if its bounds allow.
  void offer(const SignatureQuery& query, const SignatureBlock& block, std::size_t i);
  /// Whatever its bounds.
  void compare(const SignatureQuery& query, const SignatureBlock& block, std::size_t i);

  const std::vector<SignatureMatch>& matches() const { return matches_; }

 private:
  std::size_t count_;
  const SignatureIndex::Admission& admits_;
  std::vector<SignatureMatch> matches_;
};

/// A static tree of boxes around the column sums of signatures.
class SignatureTree {
 public:
  SignatureTree() = default;
  /// Sorts the entries into the tree; those removed are left out.
  explicit SignatureTree(const SignatureBlock& entries);

  void search(const SignatureQuery& query, BestMatches& best) const;

  SignatureBlock block;

 private:
  struct Node {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    std::uint32_t right = 0;  // the left child is the next node; 0: a leaf
  };
  void build(const SignatureBlock& entries, std::vector<std::uint32_t>& order, std::uint32_t begin,
             std::uint32_t end);
  std::size_t add_box(const SignatureBlock& entries, const std::vector<std::uint32_t>& order,
                      std::uint32_t begin, std::uint32_t end);
  std::uint32_t bound(const SignatureQuery& query, std::size_t node) const;
  void search(const SignatureQuery& query, std::size_t node, BestMatches& best) const;

  std::vector<Node> nodes_;
  std::vector<std::uint16_t> lowest_;  // of each node, for each column
  std::vector<std::uint16_t> highest_;
};

}  // namespace falko_slam
