// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/yaml_parameters.hpp"

#include <yaml-cpp/yaml.h>

#include <stdexcept>

namespace falko_slam {
namespace {

using XmlRpc::XmlRpcValue;

XmlRpcValue scalar(const YAML::Node& node) {
  const bool quoted = node.Tag() == "!";
  bool flag = false;
  int integer = 0;
  double number = 0.0;
  if (quoted) return XmlRpcValue(node.Scalar());
  if (YAML::convert<bool>::decode(node, flag)) return XmlRpcValue(flag);
  if (YAML::convert<int>::decode(node, integer)) return XmlRpcValue(integer);
  if (YAML::convert<double>::decode(node, number)) return XmlRpcValue(number);
  return XmlRpcValue(node.Scalar());
}

XmlRpcValue tree_of(const YAML::Node& node) {
  if (node.IsScalar() || node.IsNull()) return scalar(node);
  if (node.IsSequence()) {
    XmlRpcValue list;
    list.setSize(static_cast<int>(node.size()));
    for (std::size_t i = 0; i < node.size(); ++i) list[static_cast<int>(i)] = tree_of(node[i]);
    return list;
  }
  XmlRpcValue tree;
  tree.begin();  // makes a map of it, even of an empty one
  for (const auto& entry : node) tree[entry.first.as<std::string>()] = tree_of(entry.second);
  return tree;
}

}  // namespace

XmlRpcValue read_parameter_file(const std::string& path) {
  try {
    const YAML::Node root = YAML::LoadFile(path);
    if (root.IsMap()) return tree_of(root);
  } catch (const YAML::BadFile&) {
    throw std::runtime_error(path + ": cannot be read");
  } catch (const YAML::Exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
  throw std::runtime_error(path + ": holds no parameters (name: value)");
}

}  // namespace falko_slam
