// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>

#include "falko_slam/common/sealed_bytes.hpp"

namespace falko_slam {
namespace fuzz {

/// The input behind the letters and the version of a kind of file, with the checksum set right:
/// beyond it no fuzzer would ever come.
inline std::string sealed_input(const std::string& letters, const std::string& input) {
  ByteWriter out = begin_sealed({letters, 1, {}});
  out.text(input);
  return seal(std::move(out));
}

}  // namespace fuzz
}  // namespace falko_slam
