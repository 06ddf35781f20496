// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/keyframe_file.hpp"
#include "fuzz/fuzz_targets.hpp"
#include "fuzz/input_file.hpp"
#include "fuzz/sealed_input.hpp"

void falko_slam::fuzz::fuzz_keyframe_file(const std::string& input) {
  for (const std::string& bytes : {input, sealed_input("FALKOKEY", input)}) {
    const std::string path = input_file("keyframes.bin", bytes);
    read_or_refuse(path, [&] {
      const std::string written = to_bytes(read_keyframe_file(path));
      require(to_bytes(keyframes_from(written)) == written, "what was written is read as the same");
    });
  }
}
