// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/slam/slam_state_file.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "falko_slam/slam/slam_record.hpp"
#include "fuzz/fuzz_targets.hpp"
#include "fuzz/input_file.hpp"
#include "fuzz/sealed_input.hpp"

namespace falko_slam {
namespace fuzz {
namespace {

// Two bytes say how much of the input are the keyframes, which are sealed by themselves.
std::string state_bytes(const std::string& input) {
  std::size_t length = 0;
  for (std::size_t i = 0; i < std::min<std::size_t>(2, input.size()); ++i) {
    length = 256 * length + static_cast<unsigned char>(input[i]);
  }
  const std::string rest = input.substr(std::min<std::size_t>(2, input.size()));
  const std::string keyframes = sealed_input("FALKOKEY", rest.substr(0, length));
  ByteWriter out;
  out.u64(keyframes.size());
  out.text(keyframes);
  out.text(rest.substr(std::min(length, rest.size())));
  return sealed_input("FALKOMAP", out.bytes());
}

}  // namespace

void fuzz_slam_state(const std::string& input) {
  const std::string path = input_file("state.bin", state_bytes(input));
  read_or_refuse(path, [&] {
    const SlamState state = load_slam_state(path);
    try {
      FeatureSlam slam({}, state);
      slam.finish();
      map_of(slam);
    } catch (const std::runtime_error&) {     // more cells than any map has
    } catch (const std::invalid_argument&) {  // the parts do not belong together
    }
  });
}

}  // namespace fuzz
}  // namespace falko_slam
