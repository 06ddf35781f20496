// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/parameter_reader.hpp"

#include <utility>

namespace falko_slam {
namespace {

using XmlRpc::XmlRpcValue;

std::string type_name(const XmlRpcValue& value) {
  switch (value.getType()) {
    case XmlRpcValue::TypeBoolean:
      return "a boolean";
    case XmlRpcValue::TypeInt:
      return "an integer";
    case XmlRpcValue::TypeDouble:
      return "a number";
    case XmlRpcValue::TypeString:
      return "a text";
    case XmlRpcValue::TypeArray:
      return "a list";
    case XmlRpcValue::TypeStruct:
      return "a group";
    default:
      return "something else";
  }
}

}  // namespace

ParameterReader::ParameterReader(const XmlRpcValue& tree, std::string name)
    : tree_(tree), name_(std::move(name)) {}

void ParameterReader::begin(const char* group) {
  XmlRpcValue* found = find(group);
  if (found != nullptr && found->getType() != XmlRpcValue::TypeStruct)
    fail(group, *found, "a group");
  groups_.emplace_back(group);
}

void ParameterReader::end() { groups_.pop_back(); }

std::string ParameterReader::path_of(const std::string& name) const {
  std::string path;
  for (const std::string& group : groups_) path += group + "/";
  return path + name;
}

XmlRpcValue* ParameterReader::find(const char* name) {
  known_.insert(path_of(name));
  XmlRpcValue* level = &tree_;
  for (const std::string& group : groups_) {
    if (level->getType() != XmlRpcValue::TypeStruct || !level->hasMember(group)) return nullptr;
    level = &(*level)[group];
  }
  if (level->getType() != XmlRpcValue::TypeStruct) return nullptr;
  return level->hasMember(name) ? &(*level)[name] : nullptr;
}

void ParameterReader::fail(const char* name, const XmlRpcValue& found,
                           const std::string& needed) const {
  throw std::invalid_argument(name_ + "/" + path_of(name) + " is " + type_name(found) +
                              ", must be " + needed);
}

void ParameterReader::field(const char* name, double& value) {
  XmlRpcValue* found = find(name);
  if (found == nullptr) return;
  if (found->getType() == XmlRpcValue::TypeInt) {
    value = static_cast<int>(*found);
  } else if (found->getType() == XmlRpcValue::TypeDouble) {
    value = static_cast<double>(*found);
  } else {
    fail(name, *found, "a number");
  }
}

void ParameterReader::field(const char* name, int& value) {
  XmlRpcValue* found = find(name);
  if (found == nullptr) return;
  if (found->getType() != XmlRpcValue::TypeInt) fail(name, *found, "an integer");
  value = static_cast<int>(*found);
}

void ParameterReader::field(const char* name, std::size_t& value) {
  int whole = 0;
  const XmlRpcValue* found = find(name);
  if (found == nullptr) return;
  field(name, whole);
  if (whole < 0) fail(name, *found, "an integer above -1");
  value = static_cast<std::size_t>(whole);
}

void ParameterReader::field(const char* name, bool& value) {
  XmlRpcValue* found = find(name);
  if (found == nullptr) return;
  if (found->getType() != XmlRpcValue::TypeBoolean) fail(name, *found, "true or false");
  value = static_cast<bool>(*found);
}

void ParameterReader::field(const char* name, std::string& value) {
  XmlRpcValue* found = find(name);
  if (found == nullptr) return;
  if (found->getType() != XmlRpcValue::TypeString) fail(name, *found, "a text");
  value = static_cast<std::string>(*found);
}

void ParameterReader::add_unknown(XmlRpcValue& level, const std::string& path,
                                  std::vector<std::string>& names) const {
  if (level.getType() != XmlRpcValue::TypeStruct) return;
  for (auto& [name, value] : level) {
    const std::string place = path + name;
    if (known_.count(place) == 0) {
      names.push_back(name_ + "/" + place);
    } else {
      add_unknown(value, place + "/", names);
    }
  }
}

std::vector<std::string> ParameterReader::unknown(const std::set<std::string>& ignored) const {
  std::vector<std::string> names;
  XmlRpcValue tree = tree_;  // iteration is not const in this library
  if (tree.getType() != XmlRpcValue::TypeStruct) return names;
  XmlRpcValue asked_for;
  for (auto& [name, value] : tree) {
    if (ignored.count(name) == 0) asked_for[name] = value;
  }
  add_unknown(asked_for, "", names);
  return names;
}

XmlRpcValue parameter_tree(const ros::NodeHandle& node) {
  XmlRpcValue tree;
  node.getParam(node.getNamespace(), tree);
  return tree;
}

}  // namespace falko_slam
