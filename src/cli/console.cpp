// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "console.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <utility>

namespace falko_slam {
namespace cli {
namespace {

const std::chrono::steady_clock::time_point kStart = std::chrono::steady_clock::now();
constexpr std::chrono::milliseconds kShowPeriod(100);

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

Progress::Progress(std::string what, std::size_t total)
    : what_(std::move(what)),
      total_(total),
      terminal_(::isatty(STDERR_FILENO) == 1),
      shown_(std::chrono::steady_clock::now()) {}

Progress::~Progress() {
  if (!terminal_) return;
  show();
  std::cerr << "\n";
}

void Progress::step() {
  ++done_;
  if (!terminal_) return;
  const auto now = std::chrono::steady_clock::now();
  if (now - shown_ < kShowPeriod) return;
  shown_ = now;
  show();
}

void Progress::show() const {
  constexpr std::size_t kWidth = 30;
  std::cerr << "\r" << what_ << " ";
  if (total_ > 0) {
    const std::size_t filled = kWidth * done_ / total_;
    std::cerr << "[" << std::string(filled, '=') << std::string(kWidth - filled, ' ') << "] ";
  }
  std::cerr << done_;
  if (total_ > 0) std::cerr << "/" << total_;
  std::cerr << std::flush;
}

std::string describe_resources() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const double wall =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - kStart).count();
  char text[128];
  std::snprintf(text, sizeof text, "%.2f s wall, %.2f s processor, %.0f MB peak memory", wall,
                seconds(usage.ru_utime) + seconds(usage.ru_stime),
                static_cast<double>(usage.ru_maxrss) / 1024.0);
  return text;
}

double resident_memory() {
  std::ifstream pages("/proc/self/statm");
  double size = 0.0, resident = 0.0;
  pages >> size >> resident;
  return pages ? resident * static_cast<double>(sysconf(_SC_PAGESIZE)) : 0.0;
}

void write_json(const std::string& path, const nlohmann::json& document) {
  if (path == "-") {
    std::cout << document.dump(2) << "\n";
    return;
  }
  std::ofstream out(path);
  out << document.dump(2) << "\n";
  if (!out.flush()) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace cli
}  // namespace falko_slam
