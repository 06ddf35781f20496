// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "falko_slam/common/keyframe_id.hpp"
#include "falko_slam/place_recognition/signature.hpp"

namespace falko_slam {

struct SignatureMatch {
  KeyframeId id;
  std::uint32_t distance = 0;
  int shift = 0;  ///< the query turned by `shift` rows comes nearest to the signature found
};

/// Finds the signatures nearest to a query by shifted_distance(): exactly those that a search
/// through all of them finds, in the order of (distance, id).
///
/// A forest of static trees, each at least twice as large as the next: a new signature costs
/// O(log^2 n) amortised. The boxes of the trees bound the column sums of what they hold, which no
/// rotation changes; where the bound of a box, then that of a signature, exceeds the distance of
/// the worst answer so far, nothing in it is compared. Not thread-safe for changes; const calls
/// are.
class SignatureIndex {
 public:
  /// Throws std::invalid_argument unless the shape has 1 to 64 rows and at least one column.
  SignatureIndex(int rows, int columns);
  ~SignatureIndex();
  SignatureIndex(SignatureIndex&&) noexcept;
  SignatureIndex& operator=(SignatureIndex&&) noexcept;

  /// Throws std::invalid_argument if the shape is another one or the id is there already.
  void add(KeyframeId id, const Signature& signature);
  /// False if there is no such id.
  bool remove(KeyframeId id);
  bool contains(KeyframeId id) const;
  std::size_t size() const;
  int rows() const;
  int columns() const;

  /// Which ids may be answers, such as those outside of an exclusion window. Empty: all.
  using Admission = std::function<bool(KeyframeId)>;
  /// At most `count` of them; fewer if there are fewer. Throws as add().
  std::vector<SignatureMatch> nearest(const Signature& query, std::size_t count,
                                      const Admission& admits = {}) const;
  /// The same without any bound, for comparison.
  std::vector<SignatureMatch> nearest_by_brute_force(const Signature& query, std::size_t count,
                                                     const Admission& admits = {}) const;

  /// Writes beside the file and renames: an old one is replaced by a whole new one or not at all.
  /// Throws std::runtime_error that names the file.
  void save(const std::string& path) const;
  /// Throws std::runtime_error that names the file and what is wrong with it.
  static SignatureIndex load(const std::string& path);

 private:
  struct Forest;
  std::unique_ptr<Forest> forest_;
};

}  // namespace falko_slam
