// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/map/png_file.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <stdexcept>

#include "falko_slam/common/whole_file.hpp"
#include "falko_slam/map/gray_image.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

GrayImage decode(const std::string& bytes) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  GrayImage image;
  if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) return image;
  EXPECT_EQ(png.format, 0U);  // gray, no colour map, no alpha
  png.format = PNG_FORMAT_GRAY;
  image = {png.width, png.height, std::vector<std::uint8_t>(PNG_IMAGE_SIZE(png))};
  png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr);
  return image;
}

TEST(PngFile, DecodesToTheSamePixels) {
  GrayImage image{300, 200, {}};
  for (std::size_t i = 0; i < 300 * 200; ++i) {
    image.pixels.push_back(static_cast<std::uint8_t>(i * i / 7));
  }
  const test::TemporaryFolder folder;
  write_png(folder.file("map.png"), image);
  const std::string bytes = read_whole_file(folder.file("map.png"));
  EXPECT_EQ(bytes, png_bytes(image));
  const GrayImage decoded = decode(bytes);
  EXPECT_EQ(decoded.width, 300U);
  EXPECT_EQ(decoded.height, 200U);
  EXPECT_EQ(decoded.pixels, image.pixels);
}

TEST(PngFile, RefusesImagesWithoutPixelsOrWithTooFew) {
  EXPECT_THROW(png_bytes({}), std::invalid_argument);
  EXPECT_THROW(png_bytes({2, 2, {1, 2, 3}}), std::invalid_argument);
  EXPECT_THROW(png_bytes({std::size_t{1} << 33U, std::size_t{1} << 33U, {}}),
               std::invalid_argument);
}

TEST(PngFile, DrawsTheLastRowOfTheMapOnTop) {
  const GridMap map{2, 2, 0.05, {}, {0, 100, -1, 50}};
  EXPECT_EQ(trinary_image(map).pixels, (std::vector<std::uint8_t>{205, 205, 254, 0}));
  EXPECT_EQ(raw_image(map).pixels, (std::vector<std::uint8_t>{255, 50, 0, 100}));
}

}  // namespace
}  // namespace falko_slam
