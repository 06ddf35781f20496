// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <map>
#include <string>

#include "falko_slam/features/feature_extractor_fields.hpp"

namespace falko_slam {
namespace test {

/// A visitor of parameter fields that lists their values by name, "group/name" where in a group.
class FieldValues {
 public:
  void begin(const char* group) { prefix_ += std::string(group) + "/"; }
  void end() { prefix_.erase(prefix_.rfind('/', prefix_.size() - 2) + 1); }
  void field(const char* name, double value) { values_[prefix_ + name] = number(value); }
  void field(const char* name, int value) { values_[prefix_ + name] = number(value); }
  void field(const char* name, unsigned int value) { values_[prefix_ + name] = number(value); }
  void field(const char* name, unsigned long value) {
    values_[prefix_ + name] = number(static_cast<double>(value));
  }
  void field(const char* name, const std::string& value) { values_[prefix_ + name] = value; }
  void field(const char* name, bool value) { values_[prefix_ + name] = value ? "true" : "false"; }
  template <class Enum>
  void choice(const char* name, Enum value, const EnumNames<Enum>& names) {
    values_[prefix_ + name] = name_of(value, names);
  }

  const std::map<std::string, std::string>& values() const { return values_; }

 private:
  static std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", value);
    return text;
  }

  std::string prefix_;
  std::map<std::string, std::string> values_;
};

inline std::map<std::string, std::string> values_of(const FeatureExtractorParams& params) {
  FieldValues values;
  visit_feature_extractor_fields(params, values);
  return values.values();
}

inline std::map<std::string, std::string> values_of(const FalkoParams& params) {
  FieldValues values;
  visit_falko_fields(params, values);
  return values.values();
}

/// A visitor that gives every field another value.
class FieldChanger {
 public:
  void begin(const char*) {}
  void end() {}
  void field(const char*, double& value) const { value += 0.5; }
  void field(const char*, int& value) const { value += 3; }
  void field(const char*, unsigned int& value) const { value += 3; }
  void field(const char*, unsigned long& value) const { value += 3; }
  void field(const char*, bool& value) const { value = !value; }
  void field(const char*, std::string& value) const { value += "_"; }
  template <class Enum>
  void choice(const char*, Enum& value, const EnumNames<Enum>& names) const {
    value = names[0].second == value ? names[1].second : names[0].second;
  }
};

}  // namespace test
}  // namespace falko_slam
