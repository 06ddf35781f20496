// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dynamic_reconfigure/Config.h>

#include <stdexcept>
#include <string>

#include "falko_slam/common/enum_names.hpp"

namespace falko_slam {

/// Visitors of parameter fields (see feature_extractor_fields.hpp) between our structs and a
/// dynamic_reconfigure configuration that has fields of the same names.

class ReconfigureReader {
 public:
  explicit ReconfigureReader(const dynamic_reconfigure::Config& config) : config_(config) {}

  void field(const char* name, double& value) const { take(config_.doubles, name, value); }
  void field(const char* name, int& value) const { take(config_.ints, name, value); }
  void field(const char* name, std::string& value) const { take(config_.strs, name, value); }
  void field(const char* name, bool& value) const { take(config_.bools, name, value); }

  template <class Enum>
  void choice(const char* name, Enum& value, const EnumNames<Enum>& names) const {
    std::string text = name_of(value, names);
    field(name, text);
    const auto found = value_of(text, names);
    if (!found) {
      throw std::invalid_argument(std::string(name) + " = " + text + ": must be " +
                                  list_names(names));
    }
    value = *found;
  }

 private:
  template <class List, class Value>
  static void take(const List& list, const char* name, Value& value) {
    for (const auto& entry : list) {
      if (entry.name == name) value = static_cast<Value>(entry.value);
    }
  }

  const dynamic_reconfigure::Config& config_;
};

class ReconfigureWriter {
 public:
  void field(const char* name, double value) { put(config_.doubles, name, value); }
  void field(const char* name, int value) { put(config_.ints, name, value); }
  void field(const char* name, const std::string& value) { put(config_.strs, name, value); }
  void field(const char* name, bool value) { put(config_.bools, name, value); }

  template <class Enum>
  void choice(const char* name, Enum value, const EnumNames<Enum>& names) {
    field(name, std::string(name_of(value, names)));
  }

  const dynamic_reconfigure::Config& config() const { return config_; }

 private:
  template <class List, class Value>
  static void put(List& list, const char* name, const Value& value) {
    typename List::value_type entry;
    entry.name = name;
    entry.value = static_cast<decltype(entry.value)>(value);
    list.push_back(entry);
  }

  dynamic_reconfigure::Config config_;
};

}  // namespace falko_slam
