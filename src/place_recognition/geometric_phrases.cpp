// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/geometric_phrases.hpp"

#include <algorithm>

#include "falko_slam/common/validation.hpp"

namespace falko_slam {

void validate(const PhraseParams& params) { require_in_range("reach", params.reach, 1, 1000); }

PhraseBag geometric_phrases(const std::vector<std::size_t>& words, bool closed,
                            const PhraseParams& params) {
  validate(params);
  PhraseBag bag;
  const std::size_t count = words.size();
  for (std::size_t i = 0; i < count; ++i) {
    // Around a closed scan as far as to the word itself.
    const std::size_t left = closed ? count - 1 : count - 1 - i;
    const std::size_t reach = std::min(left, static_cast<std::size_t>(params.reach));
    for (std::size_t step = 1; step <= reach; ++step) {
      ++bag[{words[i], words[(i + step) % count]}];
    }
  }
  return bag;
}

}  // namespace falko_slam
