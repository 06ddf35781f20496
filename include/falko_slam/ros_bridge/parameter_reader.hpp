// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <XmlRpcValue.h>
#include <ros/node_handle.h>

#include <cstddef>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "falko_slam/common/enum_names.hpp"

namespace falko_slam {

/// A visitor of parameter fields (see feature_extractor_fields.hpp) that takes their values from a
/// tree of ROS parameters. What the tree does not hold keeps its value; what has the wrong type
/// throws std::invalid_argument with the full name, the type found and the one needed.
class ParameterReader {
 public:
  /// `name` stands before the names in messages.
  ParameterReader(const XmlRpc::XmlRpcValue& tree, std::string name);

  void begin(const char* group);
  void end();
  void field(const char* name, double& value);
  void field(const char* name, int& value);
  void field(const char* name, std::size_t& value);
  void field(const char* name, bool& value);
  void field(const char* name, std::string& value);
  template <class Enum>
  void choice(const char* name, Enum& value, const EnumNames<Enum>& names);

  /// Names in the tree that no field has: misspelt ones, most likely. `ignored` are top-level names
  /// that somebody else reads.
  std::vector<std::string> unknown(const std::set<std::string>& ignored = {}) const;

 private:
  std::string path_of(const std::string& name) const;
  void add_unknown(XmlRpc::XmlRpcValue& level, const std::string& path,
                   std::vector<std::string>& names) const;
  XmlRpc::XmlRpcValue* find(const char* name);
  [[noreturn]] void fail(const char* name, const XmlRpc::XmlRpcValue& found,
                         const std::string& needed) const;

  XmlRpc::XmlRpcValue tree_;
  std::string name_;
  std::vector<std::string> groups_;  // each within the one before
  std::set<std::string> known_;
};

/// All parameters in the namespace of the node handle; an empty tree if there are none.
XmlRpc::XmlRpcValue parameter_tree(const ros::NodeHandle& node);

template <class Enum>
void ParameterReader::choice(const char* name, Enum& value, const EnumNames<Enum>& names) {
  std::string text = name_of(value, names);
  field(name, text);
  const auto found = value_of(text, names);
  if (!found) {
    throw std::invalid_argument(name_ + "/" + path_of(name) + " = " + text + ": must be " +
                                list_names(names));
  }
  value = *found;
}

}  // namespace falko_slam
