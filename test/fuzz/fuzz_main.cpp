// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// One target, FALKO_SLAM_FUZZ_TARGET, for libFuzzer.
#include <cstddef>
#include <cstdint>
#include <string>

#include "fuzz/fuzz_targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  falko_slam::fuzz::FALKO_SLAM_FUZZ_TARGET(
      size == 0 ? std::string() : std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
