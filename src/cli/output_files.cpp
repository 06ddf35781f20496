// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "output_files.hpp"

#include <filesystem>
#include <stdexcept>

namespace falko_slam {
namespace cli {

void require_new(const std::string& path, bool replace) {
  if (!replace && std::filesystem::exists(path)) {
    throw std::runtime_error(path + ": exists already; --force replaces it");
  }
}

void make_output_folder(const std::string& folder, bool replace) {
  require_new(folder + "/report.json", replace);
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw std::runtime_error(folder + ": cannot be made: " + error.message());
}

}  // namespace cli
}  // namespace falko_slam
