// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/phrase_index.hpp"

#include <algorithm>
#include <cmath>

namespace falko_slam {

PhraseIndex::PhraseIndex(const std::vector<PhraseBag>& scans) : size_(scans.size()) {
  for (std::size_t scan = 0; scan < scans.size(); ++scan) {
    for (const auto& [phrase, times] : scans[scan]) {
      occurrences_[phrase].entries.push_back({scan, static_cast<double>(times)});
    }
  }
  std::vector<double> squares(scans.size(), 0.0);
  for (auto& [phrase, found] : occurrences_) {
    found.inverse_frequency =
        std::log(static_cast<double>(size_) / static_cast<double>(found.entries.size()));
    for (Entry& entry : found.entries) {
      entry.weight *= found.inverse_frequency;
      squares[entry.scan] += entry.weight * entry.weight;
    }
  }
  for (auto& [phrase, found] : occurrences_) {
    for (Entry& entry : found.entries) {
      if (entry.weight > 0.0) entry.weight /= std::sqrt(squares[entry.scan]);
    }
  }
}

std::vector<PhraseMatch> PhraseIndex::nearest(const PhraseBag& query, std::size_t count,
                                              const Admission& admits) const {
  std::vector<double> products(size_, 0.0);
  double squares = 0.0;
  for (const auto& [phrase, times] : query) {
    const auto found = occurrences_.find(phrase);
    if (found == occurrences_.end()) continue;
    const double weight = times * found->second.inverse_frequency;
    squares += weight * weight;
    for (const Entry& entry : found->second.entries) products[entry.scan] += weight * entry.weight;
  }
  std::vector<PhraseMatch> matches;
  for (std::size_t scan = 0; scan < size_; ++scan) {
    if (products[scan] <= 0.0 || (admits && !admits(scan))) continue;
    matches.push_back({scan, products[scan] / std::sqrt(squares)});
  }
  const auto more_alike = [](const PhraseMatch& a, const PhraseMatch& b) {
    return a.similarity != b.similarity ? a.similarity > b.similarity : a.scan < b.scan;
  };
  const auto end = matches.begin() + static_cast<std::ptrdiff_t>(std::min(count, matches.size()));
  std::partial_sort(matches.begin(), end, matches.end(), more_alike);
  matches.erase(end, matches.end());
  return matches;
}

}  // namespace falko_slam
