// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "pgm_image.hpp"

#include <stdexcept>

namespace falko_slam {
namespace {

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Reads the header: words between blanks, comments from # to the end of the line.
class HeaderReader {
 public:
  HeaderReader(const std::string& bytes, std::size_t at) : bytes_(bytes), at_(at) {}

  std::size_t next_number(const char* name, std::size_t max) {
    skip_blanks_and_comments();
    std::size_t value = 0;
    const std::size_t begin = at_;
    for (; at_ < bytes_.size() && is_digit(bytes_[at_]); ++at_) {
      value = 10 * value + static_cast<std::size_t>(bytes_[at_] - '0');
      if (value > max) fail(name, "must be at most " + std::to_string(max));
    }
    if (at_ == begin) fail(name, "is not a number");
    if (value == 0) fail(name, "is 0");
    return value;
  }

  /// Where the pixels begin: behind the one blank after the last number.
  std::size_t end() const {
    if (at_ >= bytes_.size() || !is_blank(bytes_[at_])) {
      throw std::runtime_error("PGM header ends too early");
    }
    return at_ + 1;
  }

 private:
  [[noreturn]] static void fail(const char* name, const std::string& what) {
    throw std::runtime_error(std::string("PGM ") + name + " " + what);
  }
  void skip_blanks_and_comments() {
    while (at_ < bytes_.size() && (is_blank(bytes_[at_]) || bytes_[at_] == '#')) {
      at_ = bytes_[at_] == '#' ? bytes_.find_first_of("\r\n", at_) : at_ + 1;
    }
  }

  const std::string& bytes_;
  std::size_t at_;
};

}  // namespace

std::string pgm_bytes(const GrayImage& image, const std::string& comment) {
  std::string bytes = "P5\n# " + comment + "\n" + std::to_string(image.width) + " " +
                      std::to_string(image.height) + "\n255\n";
  bytes.append(image.pixels.begin(), image.pixels.end());
  return bytes;
}

GrayImage parse_pgm(const std::string& bytes) {
  if (bytes.size() < 3 || bytes.compare(0, 2, "P5") != 0 ||
      !(is_blank(bytes[2]) || bytes[2] == '#')) {
    throw std::runtime_error("is not a binary PGM image (P5)");
  }
  HeaderReader header(bytes, 2);
  GrayImage image;
  image.width = header.next_number("width", kMaxGridCells);
  image.height = header.next_number("height", kMaxGridCells / image.width);
  const std::size_t white = header.next_number("maximum (8 bits are read)", 255);
  const std::size_t begin = header.end();
  const std::size_t count = image.width * image.height;
  if (bytes.size() - begin < count) {
    throw std::runtime_error("PGM of " + std::to_string(image.width) + " x " +
                             std::to_string(image.height) + " pixels holds " +
                             std::to_string(bytes.size() - begin));
  }
  image.pixels.reserve(count);
  for (std::size_t i = begin; i < begin + count; ++i) {
    const std::size_t value = static_cast<unsigned char>(bytes[i]);
    if (value > white) throw std::runtime_error("PGM holds a value above its maximum");
    image.pixels.push_back(static_cast<std::uint8_t>((255 * value + white / 2) / white));
  }
  return image;
}

}  // namespace falko_slam
