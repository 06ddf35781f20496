// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

namespace falko_slam {
namespace cli {

/// Shows on a terminal how far the work has come, on standard error; silent elsewhere.
class Progress {
 public:
  /// `total` 0: not known.
  explicit Progress(std::string what, std::size_t total = 0);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void step();

 private:
  void show() const;

  std::string what_;
  std::size_t total_;
  std::size_t done_ = 0;
  bool terminal_;
  std::chrono::steady_clock::time_point shown_;
};

/// Wall time, processor time and peak memory of this process since its start.
std::string describe_resources();

/// Memory of this process that is in the machine's just now [byte]; 0 where the system does not
/// say.
double resident_memory();

/// Writes to `path`, or to standard output if that is "-". Throws std::runtime_error.
void write_json(const std::string& path, const nlohmann::json& document);

}  // namespace cli
}  // namespace falko_slam
