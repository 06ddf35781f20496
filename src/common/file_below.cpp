// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/file_below.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace falko_slam {
namespace {

namespace fs = std::filesystem;

bool is_below(const fs::path& folder, const fs::path& file) {
  const auto end = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return end.first == folder.end() && end.second != file.end();
}

}  // namespace

std::string file_below(const std::string& folder, const std::string& name) {
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument("file name '" + name + "': " + why);
  };
  const fs::path relative(name);
  if (folder.empty()) refuse("no folder for files is configured");
  if (name.empty()) refuse("is empty");
  if (name.find('\0') != std::string::npos) refuse("holds a zero byte");
  if (relative.is_absolute()) refuse("must be relative to " + folder);
  if (!relative.has_filename() || relative.filename() == ".") refuse("names no file");
  if (std::find(relative.begin(), relative.end(), "..") != relative.end()) {
    refuse("must not hold '..'");
  }
  std::error_code error;
  const fs::path home = fs::weakly_canonical(folder, error);
  if (error) refuse(folder + ": " + error.message());
  const fs::path file = fs::weakly_canonical(home / relative, error);
  if (error) refuse(error.message());
  if (!is_below(home, file)) refuse("leads out of " + folder);
  return (home / relative).string();
}

}  // namespace falko_slam
