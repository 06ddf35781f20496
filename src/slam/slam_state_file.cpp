// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/slam/slam_state_file.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "falko_slam/common/sealed_bytes.hpp"
#include "falko_slam/common/whole_file.hpp"
#include "falko_slam/geometry/pose_bytes.hpp"

namespace falko_slam {
namespace {

const FileKind kKind{"FALKOMAP", 1, "a SLAM state"};
constexpr std::size_t kConstraintBytes =
    2 * sizeof(std::uint64_t) + kPoseBytes + 6 * sizeof(double) + 1;

void put(ByteWriter& out, const GraphConstraint& constraint) {
  out.u64(constraint.from.value);
  out.u64(constraint.to.value);
  put(out, constraint.from_T_to);
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = i; j < 3; ++j) out.f64(constraint.information(i, j));
  }
  out.u8(static_cast<std::uint8_t>(constraint.kind));
}

KeyframeId take_id(ByteReader& in, std::size_t count) {
  const KeyframeId id{in.u64()};
  require_sound(id.value < count, "keyframe " + std::to_string(id.value) + " is not there");
  return id;
}

GraphConstraint take_constraint(ByteReader& in, std::size_t keyframes) {
  GraphConstraint result;
  result.from = take_id(in, keyframes);
  result.to = take_id(in, keyframes);
  require_sound(result.from != result.to, "a constraint of a keyframe with itself");
  result.from_T_to = take_pose(in);
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = i; j < 3; ++j) {
      result.information(i, j) = result.information(j, i) = in.f64();
    }
  }
  estimate_of(result);  // throws unless the information is that of an estimate
  const std::uint8_t kind = in.u8();
  require_sound(kind <= static_cast<std::uint8_t>(ConstraintKind::kClosure),
                "a constraint of unknown kind " + std::to_string(kind));
  result.kind = static_cast<ConstraintKind>(kind);
  return result;
}

std::size_t take_count(ByteReader& in, std::size_t bytes_each) {
  const std::uint64_t count = in.u64();
  require_sound(count <= in.left() / bytes_each, "ends too early");
  return static_cast<std::size_t>(count);
}

}  // namespace

std::string to_bytes(const SlamState& state) {
  ByteWriter out = begin_sealed(kKind);
  const std::string keyframes = to_bytes(state.keyframes);
  out.u64(keyframes.size());
  out.text(keyframes);
  out.u64(state.graph.nodes.size());
  for (const GraphNode& node : state.graph.nodes) put(out, node.map_T_node);
  out.u64(state.graph.constraints.size());
  for (const GraphConstraint& constraint : state.graph.constraints) put(out, constraint);
  out.u64(state.graph.fixed.size());
  for (const KeyframeId id : state.graph.fixed) out.u64(id.value);
  return seal(std::move(out));
}

SlamState slam_state_from(const std::string& bytes) try {
  ByteReader in = open_sealed(bytes, kKind);
  SlamState state;
  state.keyframes = keyframes_from(in.text(take_count(in, 1)));
  const std::size_t count = take_count(in, kPoseBytes);
  require_sound(count == state.keyframes.size(), std::to_string(state.keyframes.size()) +
                                                     " keyframes, but " + std::to_string(count) +
                                                     " poses");
  for (std::size_t i = 0; i < count; ++i) state.graph.nodes.push_back({{i}, take_pose(in)});
  const std::size_t constraints = take_count(in, kConstraintBytes);
  for (std::size_t i = 0; i < constraints; ++i) {
    state.graph.constraints.push_back(take_constraint(in, count));
  }
  const std::size_t fixed = take_count(in, 8);
  for (std::size_t i = 0; i < fixed; ++i) state.graph.fixed.push_back(take_id(in, count));
  require_end(in);
  return state;
} catch (const std::invalid_argument& error) {
  throw std::runtime_error(error.what());
}

void save_slam_state(const std::string& path, const SlamState& state) {
  if (state.keyframes.empty()) throw std::runtime_error(path + ": there is no keyframe to save");
  write_sealed_file(path, to_bytes(state), kKind);
}

SlamState load_slam_state(const std::string& path) {
  const std::string bytes = read_whole_file(path);
  try {
    return slam_state_from(bytes);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace falko_slam
