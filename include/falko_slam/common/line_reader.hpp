// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <istream>
#include <memory>
#include <string>

namespace falko_slam {

/// Reads a text file line by line, unpacking it on the fly if its name ends in .gz or .bz2.
class LineReader {
 public:
  /// Throws std::runtime_error that names the file if it cannot be opened.
  explicit LineReader(const std::string& path);

  /// False at the end. Throws std::runtime_error with the file's name where packed data are
  /// damaged or a line is longer than 16 MiB.
  bool next(std::string& line);

  std::size_t lines() const { return lines_; }  ///< read so far: the number of the last one

  /// Throws std::runtime_error, "file: line 7: what".
  [[noreturn]] void fail(const std::string& what) const;

 private:
  std::string path_;
  std::unique_ptr<std::istream> in_;
  std::size_t lines_ = 0;
};

}  // namespace falko_slam
