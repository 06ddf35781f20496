// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "falko_slam/map/gray_image.hpp"

namespace falko_slam {

/// The bytes of a binary PGM file (P5) of 8 bits; the comment must be one line.
std::string pgm_bytes(const GrayImage& image, const std::string& comment);

/// Throws std::runtime_error that says what is wrong. Gray values are stretched to 0..255; bytes
/// behind the first image are left alone.
GrayImage parse_pgm(const std::string& bytes);

}  // namespace falko_slam
