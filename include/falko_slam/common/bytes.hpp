// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

namespace falko_slam {

/// Numbers to bytes, little-endian on every machine.
class ByteWriter {
 public:
  void text(const std::string& characters) { bytes_ += characters; }
  void u8(std::uint8_t value) { put(value); }
  void u32(std::uint32_t value) { put(value); }
  void u64(std::uint64_t value) { put(value); }
  void i64(std::int64_t value) { put(static_cast<std::uint64_t>(value)); }
  void f32(float value);
  void f64(double value);

  const std::string& bytes() const& { return bytes_; }
  std::string bytes() && { return std::move(bytes_); }

 private:
  template <class Number>
  void put(Number number);

  std::string bytes_;
};

/// Bytes back to numbers. Throws std::runtime_error("ends too early") where there are too few left.
class ByteReader {
 public:
  /// Borrows the bytes from `begin` to `end`.
  ByteReader(const std::string& bytes, std::size_t begin, std::size_t end)
      : bytes_(bytes), at_(begin), end_(end) {}

  std::uint8_t u8() { return take<std::uint8_t>(); }
  std::uint32_t u32() { return take<std::uint32_t>(); }
  std::uint64_t u64() { return take<std::uint64_t>(); }
  std::int64_t i64() { return static_cast<std::int64_t>(take<std::uint64_t>()); }
  float f32();
  double f64();
  std::string text(std::size_t count);
  std::size_t left() const { return end_ - at_; }

 private:
  template <class Number>
  Number take();

  const std::string& bytes_;
  std::size_t at_;
  std::size_t end_;
};

template <class Number>
void ByteWriter::put(Number number) {
  for (std::size_t i = 0; i < sizeof number; ++i) {
    bytes_.push_back(static_cast<char>((number >> (8 * i)) & 0xFF));
  }
}

template <class Number>
Number ByteReader::take() {
  if (left() < sizeof(Number)) throw std::runtime_error("ends too early");
  Number number = 0;
  for (std::size_t i = 0; i < sizeof number; ++i) {
    const auto byte = static_cast<Number>(static_cast<unsigned char>(bytes_[at_ + i]));
    number = static_cast<Number>(number | static_cast<Number>(byte << (8 * i)));
  }
  at_ += sizeof number;
  return number;
}

/// CRC-32 of the first `size` bytes.
std::uint32_t checksum(const std::string& bytes, std::size_t size);

}  // namespace falko_slam
