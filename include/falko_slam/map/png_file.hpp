// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "falko_slam/map/gray_image.hpp"

namespace falko_slam {

/// The bytes of a PNG file, always the same for the same image. Throws std::invalid_argument if it
/// has no pixel or not as many as its size says.
std::string png_bytes(const GrayImage& image);

/// Writes the whole file or nothing. Throws std::runtime_error that names the file, too.
void write_png(const std::string& path, const GrayImage& image);

}  // namespace falko_slam
