// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/slam/slam_state_file.hpp"

#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "falko_slam/common/whole_file.hpp"

namespace falko_slam {
namespace {

// PLACEHOLDER: "FALKOSTA", size of the keyframes, keyframes, poses and constraints as memory.
constexpr char kMagic[] = "FALKOSTA";

template <class Value>
void append(std::string& bytes, const Value& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class Value>
Value take(const std::string& bytes, std::size_t& at) {
  if (at + sizeof(Value) > bytes.size()) throw std::runtime_error("ends early");
  Value value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  at += sizeof value;
  return value;
}

struct Constraint {
  std::uint64_t from, to;
  double x, y, theta;
  double information[9];
  int kind;
};

SlamState state_from(const std::string& bytes) {
  std::size_t at = sizeof kMagic - 1;
  if (bytes.compare(0, at, kMagic) != 0) throw std::runtime_error("no SLAM state");
  const auto size = take<std::uint64_t>(bytes, at);
  if (size > bytes.size() - at) throw std::runtime_error("ends early");
  SlamState state;
  state.keyframes = keyframes_from(bytes.substr(at, size));
  at += size;
  for (std::uint64_t i = 0; i < state.keyframes.size(); ++i) {
    const auto x = take<double>(bytes, at);
    const auto y = take<double>(bytes, at);
    state.graph.nodes.push_back({{i}, Pose2(x, y, take<double>(bytes, at))});
  }
  while (at < bytes.size()) {
    const auto c = take<Constraint>(bytes, at);
    state.graph.constraints.push_back({{c.from},
                                       {c.to},
                                       Pose2(c.x, c.y, c.theta),
                                       Eigen::Map<const Eigen::Matrix3d>(c.information),
                                       static_cast<ConstraintKind>(c.kind)});
  }
  return state;
}

}  // namespace

void save_slam_state(const std::string& path, const SlamState& state) {
  std::string bytes = kMagic;
  const std::string keyframes = to_bytes(state.keyframes);
  append(bytes, static_cast<std::uint64_t>(keyframes.size()));
  bytes += keyframes;
  for (const GraphNode& node : state.graph.nodes) {
    append(bytes, node.map_T_node.x());
    append(bytes, node.map_T_node.y());
    append(bytes, node.map_T_node.theta());
  }
  for (const GraphConstraint& c : state.graph.constraints) {
    Constraint out{};
    out.from = c.from.value;
    out.to = c.to.value;
    out.x = c.from_T_to.x();
    out.y = c.from_T_to.y();
    out.theta = c.from_T_to.theta();
    Eigen::Map<Eigen::Matrix3d>(out.information) = c.information;
    out.kind = static_cast<int>(c.kind);
    append(bytes, out);
  }
  write_whole_file(path, bytes);
}

SlamState load_slam_state(const std::string& path) {
  const std::string bytes = read_whole_file(path);
  try {
    return state_from(bytes);
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace falko_slam
