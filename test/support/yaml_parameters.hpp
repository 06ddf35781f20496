// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <XmlRpcValue.h>
#include <yaml-cpp/yaml.h>

#include <string>

namespace falko_slam {
namespace test {

/// What `rosparam load` makes of a scalar: true or false, an integer, a number, else a text.
inline XmlRpc::XmlRpcValue scalar_parameter(const YAML::Node& node) {
  const bool quoted = node.Tag() == "!";
  bool flag = false;
  int integer = 0;
  double number = 0.0;
  if (quoted) return XmlRpc::XmlRpcValue(node.as<std::string>());
  if (YAML::convert<bool>::decode(node, flag)) return XmlRpc::XmlRpcValue(flag);
  if (YAML::convert<int>::decode(node, integer)) return XmlRpc::XmlRpcValue(integer);
  if (YAML::convert<double>::decode(node, number)) return XmlRpc::XmlRpcValue(number);
  return XmlRpc::XmlRpcValue(node.as<std::string>());
}

/// The parameters of a YAML map as they would stand on the parameter server.
inline XmlRpc::XmlRpcValue parameters_from(const YAML::Node& node) {
  if (node.IsScalar()) return scalar_parameter(node);
  XmlRpc::XmlRpcValue tree;
  tree.begin();  // makes a map of it, even of an empty one
  for (const auto& entry : node)
    tree[entry.first.as<std::string>()] = parameters_from(entry.second);
  return tree;
}

}  // namespace test
}  // namespace falko_slam
