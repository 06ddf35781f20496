// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <ios>
#include <stdexcept>
#include <string>

#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace fuzz {

/// Writes the bytes to a file of this name, in a folder that all inputs share, and returns its
/// path: in memory where there is such a place, as whole files are forced to the disk.
inline std::string input_file(const std::string& name, const std::string& bytes) {
  static const bool memory = std::filesystem::is_directory("/dev/shm");
  static const test::TemporaryFolder folder(memory ? "/dev/shm" : "/tmp");
  std::ofstream out(folder.file(name), std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return folder.file(name);
}

/// The input as so many texts: what lies between the lines "----". Missing ones are empty.
template <std::size_t Count>
std::array<std::string, Count> parts_of(const std::string& input) {
  static const std::string kBetween = "\n----\n";
  std::array<std::string, Count> parts;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < Count && begin <= input.size(); ++i) {
    const std::size_t end = i + 1 < Count ? input.find(kBetween, begin) : std::string::npos;
    parts[i] = input.substr(begin, end == std::string::npos ? end : end - begin);
    if (end == std::string::npos) break;
    begin = end + kBetween.size();
  }
  return parts;
}

/// Runs what reads a file. It may refuse it by a std::runtime_error that names the file, and by
/// nothing else.
template <class Read>
void read_or_refuse(const std::string& path, Read read) {
  try {
    read();
  } catch (const std::runtime_error& error) {
    if (std::string(error.what()).find(path) != std::string::npos) return;
    std::fprintf(stderr, "an error that does not name the file: %s\n", error.what());
    std::abort();
  }
}

/// What must hold whatever the input is.
inline void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

}  // namespace fuzz
}  // namespace falko_slam
