// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cstddef>
#include <vector>

namespace falko_slam {

/// Which nodes are coupled, to order them for a factorisation: nodes, not their coordinates, which
/// is nine times less to look at.
class BlockPattern {
 public:
  explicit BlockPattern(const std::vector<bool>& left_out) {
    for (const bool out : left_out) number_.push_back(out ? -1 : size_++);
  }

  void add(std::size_t a, std::size_t b) {
    if (number_[a] < 0 || number_[b] < 0) return;
    couplings_.emplace_back(number_[a], number_[b], 1.0F);
    couplings_.emplace_back(number_[b], number_[a], 1.0F);
  }
  Eigen::Index size() const { return size_; }

  /// First column of each node's three in an order of small fill (approximate minimum degree), -1
  /// for those left out.
  std::vector<Eigen::Index> order() {
    for (int i = 0; i < size_; ++i) couplings_.emplace_back(i, i, 1.0F);
    Eigen::SparseMatrix<float> pattern(size_, size_);
    pattern.setFromTriplets(couplings_.begin(), couplings_.end());
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> old_of_new;
    Eigen::AMDOrdering<int>()(pattern, old_of_new);
    std::vector<Eigen::Index> place(static_cast<std::size_t>(size_));
    for (int i = 0; i < size_; ++i) {
      place[static_cast<std::size_t>(old_of_new.indices()[i])] = 3 * i;
    }
    std::vector<Eigen::Index> columns;
    for (const int number : number_) {
      columns.push_back(number < 0 ? -1 : place[static_cast<std::size_t>(number)]);
    }
    return columns;
  }

 private:
  std::vector<int> number_;
  int size_ = 0;
  std::vector<Eigen::Triplet<float>> couplings_;
};

/// The lower triangle of a symmetric matrix from its blocks, which add up.
class BlockMatrix {
 public:
  explicit BlockMatrix(Eigen::Index size) : size_(size) {}

  /// At a first row and column; nothing where one of them is negative.
  void add(Eigen::Index row, Eigen::Index column, const Eigen::Matrix3d& block) {
    if (row < 0 || column < 0) return;
    for (int j = 0; j < 3; ++j) {
      for (int i = row == column ? j : 0; i < 3; ++i) {
        entries_.emplace_back(static_cast<int>(row) + i, static_cast<int>(column) + j, block(i, j));
      }
    }
  }
  Eigen::SparseMatrix<double> lower_triangle() const {
    Eigen::SparseMatrix<double> matrix(size_, size_);
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    return matrix;
  }

 private:
  Eigen::Index size_;
  std::vector<Eigen::Triplet<double>> entries_;
};

}  // namespace falko_slam
