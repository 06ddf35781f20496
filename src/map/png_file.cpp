// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/map/png_file.hpp"

#include <png.h>

#include <stdexcept>

#include "falko_slam/common/whole_file.hpp"

namespace falko_slam {

std::string png_bytes(const GrayImage& image) {
  constexpr std::size_t kMaxSide = 1U << 24U;  // so that the products below fit
  if (image.width == 0 || image.height == 0 || image.width > kMaxSide || image.height > kMaxSide ||
      image.pixels.size() != image.width * image.height) {
    throw std::invalid_argument("image of " + std::to_string(image.width) + " x " +
                                std::to_string(image.height) + " pixels holds " +
                                std::to_string(image.pixels.size()));
  }
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_GRAY;
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(png), '\0');
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&png, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr) ==
      0) {
    throw std::runtime_error(std::string("PNG: ") + png.message);
  }
  bytes.resize(size);
  return bytes;
}

void write_png(const std::string& path, const GrayImage& image) {
  write_whole_file(path, png_bytes(image));
}

}  // namespace falko_slam
