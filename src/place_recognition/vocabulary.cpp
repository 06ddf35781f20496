// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/vocabulary.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>

#include "falko_slam/common/validation.hpp"

namespace falko_slam {
namespace {

using Descriptor = Vocabulary::Descriptor;

float squared_distance(const Descriptor& a, const Descriptor& b) {
  float sum = 0.0F;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

struct Nearest {
  std::size_t word = 0;
  float square = std::numeric_limits<float>::max();
};

Nearest nearest(const std::vector<Descriptor>& words, const Descriptor& descriptor) {
  Nearest best;
  for (std::size_t word = 0; word < words.size(); ++word) {
    const float square = squared_distance(words[word], descriptor);
    if (square < best.square) best = {word, square};
  }
  return best;
}

void require_same_size(const std::vector<Descriptor>& descriptors) {
  for (const Descriptor& descriptor : descriptors) {
    if (descriptor.size() == descriptors.front().size()) continue;
    throw std::invalid_argument("descriptors of " + std::to_string(descriptors.front().size()) +
                                " and of " + std::to_string(descriptor.size()) + " numbers");
  }
}

std::vector<Descriptor> drawn(const std::vector<Descriptor>& descriptors, std::size_t count,
                              std::mt19937_64& random) {
  if (descriptors.size() <= count) return descriptors;
  std::vector<Descriptor> samples;
  std::sample(descriptors.begin(), descriptors.end(), std::back_inserter(samples), count, random);
  return samples;
}

// Each is drawn with a probability that grows with the square of its distance to those before.
std::vector<Descriptor> first_words(const std::vector<Descriptor>& samples, std::size_t count,
                                    std::mt19937_64& random) {
  std::vector<Descriptor> words;
  std::vector<double> weights(samples.size(), 1.0);
  while (words.size() < count &&
         std::any_of(weights.begin(), weights.end(), [](double weight) { return weight > 0.0; })) {
    std::discrete_distribution<std::size_t> any(weights.begin(), weights.end());
    words.push_back(samples[any(random)]);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double square = squared_distance(words.back(), samples[i]);
      weights[i] = words.size() == 1 ? square : std::min(weights[i], square);
    }
  }
  return words;
}

// Moves each word to the mean of its samples; one without any stays where it is.
void move_to_means(const std::vector<Descriptor>& samples, const std::vector<std::size_t>& word_of,
                   std::vector<Descriptor>& words) {
  const std::size_t size = samples.front().size();
  std::vector<std::vector<double>> sums(words.size(), std::vector<double>(size, 0.0));
  std::vector<double> counts(words.size(), 0.0);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    counts[word_of[i]] += 1.0;
    for (std::size_t k = 0; k < size; ++k) sums[word_of[i]][k] += samples[i][k];
  }
  for (std::size_t word = 0; word < words.size(); ++word) {
    if (counts[word] == 0.0) continue;
    for (std::size_t k = 0; k < size; ++k) {
      words[word][k] = static_cast<float>(sums[word][k] / counts[word]);
    }
  }
}

}  // namespace

void validate(const VocabularyParams& params) {
  require_in_range("words", params.words, 1, 10000);
  require_in_range("rounds", params.rounds, 1, 1000);
  require_in_range("samples", params.samples, 1, 10000000);
}

Vocabulary::Vocabulary(std::vector<Descriptor> words) : words_(std::move(words)) {
  require_same_size(words_);
}

Vocabulary Vocabulary::learned(const std::vector<Descriptor>& descriptors,
                               const VocabularyParams& params) {
  validate(params);
  require_same_size(descriptors);
  std::mt19937_64 random(params.seed);
  const auto samples = drawn(descriptors, static_cast<std::size_t>(params.samples), random);
  auto words = first_words(samples, static_cast<std::size_t>(params.words), random);
  std::vector<std::size_t> word_of(samples.size(), words.size());
  for (int round = 0; round < params.rounds; ++round) {
    bool changed = false;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const std::size_t word = nearest(words, samples[i]).word;
      changed = changed || word != word_of[i];
      word_of[i] = word;
    }
    if (!changed) break;
    move_to_means(samples, word_of, words);
  }
  return Vocabulary(std::move(words));
}

std::size_t Vocabulary::word_of(const Descriptor& descriptor) const {
  if (words_.empty()) throw std::invalid_argument("vocabulary: it has no words");
  if (descriptor.size() != words_.front().size()) {
    throw std::invalid_argument("descriptor of " + std::to_string(descriptor.size()) +
                                " numbers; those of the words have " +
                                std::to_string(words_.front().size()));
  }
  return nearest(words_, descriptor).word;
}

}  // namespace falko_slam
