// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace falko_slam {

/// Ends in .bag.gz or .bag.bz2.
bool is_packed_bag(const std::string& path);

/// A packed bag as a file that can be searched; it is in the system's folder for temporary files as
/// long as this object lives.
class UnpackedBag {
 public:
  /// Throws std::runtime_error that names the packed file if it cannot be read or is damaged.
  explicit UnpackedBag(const std::string& packed);
  ~UnpackedBag();
  UnpackedBag(const UnpackedBag&) = delete;
  UnpackedBag& operator=(const UnpackedBag&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace falko_slam
