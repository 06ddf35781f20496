// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/features/descriptors.hpp"

#include <bitset>
#include <stdexcept>
#include <string>

namespace falko_slam {
namespace {

void require_same_size(std::size_t a, std::size_t b) {
  if (a == b) return;
  throw std::invalid_argument("descriptors of different sizes: " + std::to_string(a) + " and " +
                              std::to_string(b));
}

}  // namespace

int distance(const Bsc& a, const Bsc& b) {
  require_same_size(a.words.size(), b.words.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.words.size(); ++i) {
    different += std::bitset<64>(a.words[i] ^ b.words[i]).count();
  }
  return static_cast<int>(different);
}

double distance(const Cgh& a, const Cgh& b) {
  require_same_size(a.bins.size(), b.bins.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < a.bins.size(); ++i) {
    const double total = static_cast<double>(a.bins[i]) + static_cast<double>(b.bins[i]);
    const double difference = static_cast<double>(a.bins[i]) - static_cast<double>(b.bins[i]);
    if (total > 0.0) sum += difference * difference / total;
  }
  return 0.5 * sum;
}

}  // namespace falko_slam
