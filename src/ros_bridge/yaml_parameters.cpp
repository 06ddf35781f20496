// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/yaml_parameters.hpp"

#include <yaml-cpp/yaml.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace falko_slam {
namespace {

using XmlRpc::XmlRpcValue;

XmlRpcValue scalar(const YAML::Node& node) {
  const bool quoted = node.Tag() == "!";
  bool flag = false;
  int integer = 0;
  double number = 0.0;
  if (quoted) return node.Scalar();
  if (YAML::convert<bool>::decode(node, flag)) return flag;
  if (YAML::convert<int>::decode(node, integer)) return integer;
  if (YAML::convert<double>::decode(node, number)) return number;
  return node.Scalar();
}

// The parser goes deeper with each bracket, and a few lines of aliases can stand for more values
// than there is memory.
constexpr std::uintmax_t kMaxBytes = std::uintmax_t{1} << 20U;
constexpr std::size_t kMaxValues = 100000;
constexpr int kMaxDepth = 32;

class TreeBuilder {
 public:
  explicit TreeBuilder(std::string path) : path_(std::move(path)) {}

  XmlRpcValue tree_of(const YAML::Node& node, int depth = 0) {
    if (++values_ > kMaxValues) fail(node, "stands for too many values");
    if (depth > kMaxDepth) fail(node, "goes too deep");
    if (node.IsScalar() || node.IsNull()) return scalar(node);
    if (node.IsSequence()) {
      XmlRpcValue list;
      list.setSize(static_cast<int>(node.size()));
      for (std::size_t i = 0; i < node.size(); ++i) {
        list[static_cast<int>(i)] = tree_of(node[i], depth + 1);
      }
      return list;
    }
    XmlRpcValue tree;
    tree.begin();  // makes a map of it, even of an empty one
    for (const auto& entry : node) {
      tree[entry.first.as<std::string>()] = tree_of(entry.second, depth + 1);
    }
    return tree;
  }

 private:
  [[noreturn]] void fail(const YAML::Node& node, const char* what) const {
    throw std::runtime_error(path_ + ": line " + std::to_string(node.Mark().line + 1) + ": " +
                             what);
  }

  std::string path_;
  std::size_t values_ = 0;
};

}  // namespace

XmlRpcValue read_parameter_file(const std::string& path) {
  try {
    std::error_code missing;
    if (std::filesystem::file_size(path, missing) > kMaxBytes && !missing) {
      throw std::runtime_error(path + ": is too big for a file of parameters");
    }
    const YAML::Node root = YAML::LoadFile(path);
    if (root.IsMap()) return TreeBuilder(path).tree_of(root);
  } catch (const YAML::BadFile&) {
    throw std::runtime_error(path + ": cannot be read");
  } catch (const YAML::Exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
  throw std::runtime_error(path + ": holds no parameters (name: value)");
}

}  // namespace falko_slam
