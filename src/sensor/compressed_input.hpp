// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/iostreams/filtering_stream.hpp>
#include <memory>
#include <string>

namespace falko_slam {

/// Opens a text file, unpacking it on the fly if its name ends in .gz or .bz2. Damaged data makes
/// reads throw. Throws std::runtime_error with the name if the file cannot be opened.
std::unique_ptr<boost::iostreams::filtering_istream> open_compressed(const std::string& path);

}  // namespace falko_slam
