// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

#include "falko_slam/place_recognition/geometric_phrases.hpp"

namespace falko_slam {

struct PhraseMatch {
  std::size_t scan = 0;     ///< its place among those indexed
  double similarity = 0.0;  ///< (0, 1]
};

/// Finds the scans that share the most telling phrases with a query. A phrase that occurs tf times
/// in a scan and in n of the N scans has the weight
///
///     tf ln(N / n);
///
/// the similarity is the cosine of the weights of two scans: tf-idf (\cite tipaldi2013gfp). An
/// inverted file looks only at scans that share something.
///
/// How telling a phrase is depends on all scans: the index is made of all of them at once.
class PhraseIndex {
 public:
  explicit PhraseIndex(const std::vector<PhraseBag>& scans);

  using Admission = std::function<bool(std::size_t scan)>;
  /// At most `count`, the most alike first, of equals the first; only such that share a phrase that
  /// tells something. Empty admission: all.
  std::vector<PhraseMatch> nearest(const PhraseBag& query, std::size_t count,
                                   const Admission& admits = {}) const;

  std::size_t size() const { return size_; }

 private:
  struct Entry {
    std::size_t scan;
    double weight;  ///< over the length of the scan's vector
  };
  struct Occurrences {
    double inverse_frequency = 0.0;  ///< ln(N / n)
    std::vector<Entry> entries;
  };

  std::size_t size_ = 0;
  std::map<Phrase, Occurrences> occurrences_;
};

}  // namespace falko_slam
