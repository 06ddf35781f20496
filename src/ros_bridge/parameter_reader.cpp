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
  known_.insert(group);
  group_ = group;
  if (tree_.getType() != XmlRpcValue::TypeStruct || !tree_.hasMember(group_)) return;
  if (tree_[group_].getType() != XmlRpcValue::TypeStruct) {
    group_.clear();
    fail(group, tree_[group], "a group");
  }
}

void ParameterReader::end() { group_.clear(); }

std::string ParameterReader::full_name(const std::string& name) const {
  return name_ + "/" + (group_.empty() ? name : group_ + "/" + name);
}

XmlRpcValue* ParameterReader::find(const char* name) {
  known_.insert(group_.empty() ? name : group_ + "/" + name);
  if (tree_.getType() != XmlRpcValue::TypeStruct) return nullptr;
  XmlRpcValue* level = &tree_;
  if (!group_.empty()) {
    if (!tree_.hasMember(group_)) return nullptr;
    level = &tree_[group_];
  }
  return level->hasMember(name) ? &(*level)[name] : nullptr;
}

void ParameterReader::fail(const char* name, const XmlRpcValue& found,
                           const std::string& needed) const {
  throw std::invalid_argument(full_name(name) + " is " + type_name(found) + ", must be " + needed);
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

std::vector<std::string> ParameterReader::unknown(const std::set<std::string>& ignored) const {
  std::vector<std::string> names;
  if (tree_.getType() != XmlRpcValue::TypeStruct) return names;
  XmlRpcValue tree = tree_;  // iteration is not const in this library
  for (auto& [name, value] : tree) {
    if (ignored.count(name) > 0) continue;
    if (known_.count(name) == 0) {
      names.push_back(name_ + "/" + name);
    } else if (value.getType() == XmlRpcValue::TypeStruct) {
      for (auto& [inner, unused] : value) {
        (void)unused;
        const std::string inner_name = std::string(name).append("/").append(inner);
        if (known_.count(inner_name) == 0) names.push_back(name_ + "/" + inner_name);
      }
    }
  }
  return names;
}

XmlRpcValue parameter_tree(const ros::NodeHandle& node) {
  XmlRpcValue tree;
  node.getParam(node.getNamespace(), tree);
  return tree;
}

}  // namespace falko_slam
