// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace falko_slam {

struct VocabularyParams {
  /// k of the k-means: more words tell more places apart, and the same point is seen as the same
  /// word less often. [1, 10000]
  int words = 100;
  /// At most so many rounds; fewer if no descriptor changes its word. [1, 1000]
  int rounds = 30;
  /// Of more descriptors so many are drawn to learn from. [1, 10000000]
  int samples = 20000;
  std::uint64_t seed = 1;  ///< of the first words and of the draw
};
/// Throws std::invalid_argument with the field and its value.
void validate(const VocabularyParams& params);

/// Descriptors of keypoints as words: each is the nearest of some typical ones, in the Euclidean
/// distance (\cite tipaldi2013gfp).
class Vocabulary {
 public:
  using Descriptor = std::vector<float>;

  /// The words themselves. Throws std::invalid_argument if they differ in size.
  explicit Vocabulary(std::vector<Descriptor> words);

  /// Means of the descriptors that are nearest to each of them: k-means by Lloyd's rounds, the
  /// first words drawn far from each other (k-means++). Fewer words than asked for if there are
  /// fewer different descriptors; the same ones for the same descriptors and seed. Costs samples
  /// times words times rounds. Throws std::invalid_argument if the descriptors differ in size.
  static Vocabulary learned(const std::vector<Descriptor>& descriptors,
                            const VocabularyParams& params = {});

  /// Number of the word; of equally near ones the first. Throws std::invalid_argument if the
  /// vocabulary is empty or the descriptor of another size.
  std::size_t word_of(const Descriptor& descriptor) const;

  std::size_t size() const { return words_.size(); }
  const std::vector<Descriptor>& words() const { return words_; }

 private:
  std::vector<Descriptor> words_;
};

}  // namespace falko_slam
