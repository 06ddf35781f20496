// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "keypoint_clusters.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

namespace falko_slam {
namespace {

constexpr int kCellsPerRadius = 4;
constexpr int kMostMoves = 20;

using CellPlace = std::pair<std::int64_t, std::int64_t>;  // column, row

struct Cell {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  double weight = 0.0;   // viewpoints
  double density = 0.0;  // viewpoints within the radius
  bool taken = false;
  std::vector<std::size_t> keypoints;
};

class CellGrid {
 public:
  CellGrid(const std::vector<PlacedKeypoint>& keypoints, double radius)
      : radius_(radius), size_(radius / kCellsPerRadius) {
    for (std::size_t i = 0; i < keypoints.size(); ++i) {
      cells_[place_of(keypoints[i].point)].keypoints.push_back(i);
    }
    for (auto& [place, cell] : cells_) weigh(keypoints, cell);
    for (auto& [place, cell] : cells_) {
      for_each_near(cell.mean, [&density = cell.density](Cell& near) { density += near.weight; });
    }
  }

  std::vector<std::vector<std::size_t>> clusters() {
    std::vector<Cell*> seeds;
    for (auto& [place, cell] : cells_) seeds.push_back(&cell);
    // By column and row where the density is the same, as the cells come.
    std::stable_sort(seeds.begin(), seeds.end(),
                     [](const Cell* a, const Cell* b) { return a->density > b->density; });
    std::vector<std::vector<std::size_t>> result;
    for (const Cell* seed : seeds) {
      // The disc may move away from its seed.
      while (!seed->taken) result.push_back(take_around(seed->mean));
    }
    return result;
  }

 private:
  CellPlace place_of(const Eigen::Vector2d& point) const {
    return {static_cast<std::int64_t>(std::floor(point.x() / size_)),
            static_cast<std::int64_t>(std::floor(point.y() / size_))};
  }

  static void weigh(const std::vector<PlacedKeypoint>& keypoints, Cell& cell) {
    std::set<std::size_t> viewpoints;
    for (const std::size_t i : cell.keypoints) {
      cell.mean += keypoints[i].point;
      viewpoints.insert(keypoints[i].viewpoint);
    }
    cell.mean /= static_cast<double>(cell.keypoints.size());
    cell.weight = static_cast<double>(viewpoints.size());
  }

  // Cells that are not taken and whose mean lies within the radius.
  template <class Use>
  void for_each_near(const Eigen::Vector2d& center, const Use& use) {
    const CellPlace low = place_of(center - Eigen::Vector2d::Constant(radius_));
    const CellPlace high = place_of(center + Eigen::Vector2d::Constant(radius_));
    for (std::int64_t column = low.first; column <= high.first; ++column) {
      auto cell = cells_.lower_bound({column, low.second});
      for (; cell != cells_.end() && cell->first <= CellPlace{column, high.second}; ++cell) {
        if (cell->second.taken) continue;
        if ((cell->second.mean - center).squaredNorm() <= radius_ * radius_) use(cell->second);
      }
    }
  }

  // What a disc covers lies nearer to its mean, squares summed, than to the disc's centre: wherever
  // it moves to, it covers something.
  std::vector<std::size_t> take_around(Eigen::Vector2d center) {
    for (int move = 0; move < kMostMoves; ++move) {
      Eigen::Vector2d sum = Eigen::Vector2d::Zero();
      double weight = 0.0;
      for_each_near(center, [&](const Cell& cell) {
        sum += cell.weight * cell.mean;
        weight += cell.weight;
      });
      const Eigen::Vector2d mean = sum / weight;
      const bool still = (mean - center).norm() < 1e-3 * radius_;
      center = mean;
      if (still) break;
    }
    return take(center);
  }

  std::vector<std::size_t> take(const Eigen::Vector2d& center) {
    std::vector<std::size_t> members;
    for_each_near(center, [&](Cell& cell) {
      cell.taken = true;
      members.insert(members.end(), cell.keypoints.begin(), cell.keypoints.end());
    });
    std::sort(members.begin(), members.end());
    return members;
  }

  double radius_;
  double size_;
  std::map<CellPlace, Cell> cells_;
};

}  // namespace

std::vector<std::vector<std::size_t>> cluster_keypoints(
    const std::vector<PlacedKeypoint>& keypoints, double radius) {
  return CellGrid(keypoints, radius).clusters();
}

}  // namespace falko_slam
