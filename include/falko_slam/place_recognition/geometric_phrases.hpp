// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace falko_slam {

struct PhraseParams {
  /// A word makes a phrase with each of so many that follow it. Greater values forgive more
  /// keypoints that come and go in between, and tell less. [1, 1000]
  int reach = 5;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const PhraseParams& params);

/// Two words in the order in which the laser sees them.
using Phrase = std::pair<std::size_t, std::size_t>;

/// How often each phrase occurs in a scan.
using PhraseBag = std::map<Phrase, int>;

/// Geometrical FLIRT phrases (\cite tipaldi2013gfp): what stands beside what in a scan. `words` are
/// those of the keypoints, counter-clockwise by bearing; on a closed scan the first follows the
/// last.
///
/// The thesis does not define phrases. Here they are pairs of words, whose order a laser keeps
/// wherever it stands and however it is turned: the weak geometry. Two scans with m words in the
/// same order then share m (m - 1) / 2 phrases, the count of \cite zhang2011phrases for phrases of
/// two words.
PhraseBag geometric_phrases(const std::vector<std::size_t>& words, bool closed,
                            const PhraseParams& params = {});

}  // namespace falko_slam
