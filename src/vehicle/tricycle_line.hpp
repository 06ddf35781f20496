// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "falko_slam/vehicle/tricycle_log.hpp"

namespace falko_slam {

/// A "time:" line. Empty if it is cut short or too long, holds no number where one belongs, or one
/// that its field cannot hold.
std::optional<TricycleRecord> parse_tricycle_record(const std::string& line);

/// Collects the lines of a header, which are understood as a whole only.
class TricycleHeaderParser {
 public:
  void add(const std::string& comment);

  /// Throws std::runtime_error that says what is missing.
  TricycleLogHeader header() const;

 private:
  using Words = std::vector<std::string>;

  const Words& line(const std::string& key) const;
  double value(const std::string& list, const std::string& name) const;
  std::uint32_t ticks(const std::string& name) const;
  std::vector<double> numbers(const std::string& key, std::size_t count) const;

  std::map<std::string, Words> lines_;
};

}  // namespace falko_slam
