// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace falko_slam {

/// With the home folder for a leading "~/".
std::string with_home(const std::string& path);

/// falko_slam below $ROS_HOME, or below ~/.ros where that is not set.
std::string default_file_folder();

/// A whole path as it is, a relative one below the folder; empty stays empty.
std::string path_in(const std::string& folder, const std::string& path);

}  // namespace falko_slam
