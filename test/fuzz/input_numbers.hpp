// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace falko_slam {
namespace fuzz {

/// The input as numbers, one after the other; zeros after its end.
class InputNumbers {
 public:
  explicit InputNumbers(const std::string& bytes) : bytes_(bytes) {}

  bool ended() const { return at_ >= bytes_.size(); }

  /// Any value of the type, for floating-point numbers NaN and infinities included.
  template <class Number>
  Number any() {
    Number number{};
    const std::size_t count = std::min(sizeof number, bytes_.size() - at_);
    std::memcpy(&number, bytes_.data() + at_, count);
    at_ += count;
    return number;
  }

  bool coin() { return (any<std::uint8_t>() & 1U) != 0; }

  /// Of [0, count).
  std::size_t below(std::size_t count) { return any<std::uint16_t>() % count; }

  /// Of [-size, size], in steps that are fine enough to meet what is usual.
  double within(double size) { return size * any<std::int16_t>() / 32768.0; }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0;
};

}  // namespace fuzz
}  // namespace falko_slam
