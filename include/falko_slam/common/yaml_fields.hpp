// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "falko_slam/common/yaml_value.hpp"

namespace falko_slam {

/// The fields of a YAML file or of a group in it. Remembers which were asked for, so that what
/// nobody knows can be refused. Also a visitor of parameter fields (feature_extractor_fields.hpp):
/// those that are not in the file keep their value. All errors are those of YamlValue.
class YamlFields {
 public:
  /// The whole file. Throws std::runtime_error that names it, and the line where there is one.
  explicit YamlFields(const std::string& path);
  /// A text as if it were read from a file of this name.
  static YamlFields of_text(const std::string& text, const std::string& name);
  /// What must be a group; nothing at all counts as an empty one.
  explicit YamlFields(const YamlValue& value);

  bool has(const std::string& name) const;
  std::optional<YamlValue> find(const std::string& name) const;
  YamlValue at(const std::string& name) const;  ///< refuses that there is none
  /// The only one of these that is there; refuses none and several.
  std::string one_of(const std::vector<std::string>& names) const;
  /// All, in their order, where the names are the file's own affair.
  std::vector<std::pair<std::string, YamlValue>> all() const;

  void begin(const char* group);
  void end();
  void field(const char* name, double& value) const;
  void field(const char* name, bool& value) const;
  void field(const char* name, int& value) const;
  void field(const char* name, unsigned int& value) const;
  void field(const char* name, unsigned long& value) const;  ///< std::size_t
  void field(const char* name, std::string& value) const;
  template <class Enum>
  void choice(const char* name, Enum& value, const EnumNames<Enum>& names) const;
  /// From now on the visitor's fields must all be there.
  void require_fields() { required_ = true; }

  /// Runs a check that throws std::invalid_argument, "name.of.field = value: why", and says where
  /// that field stands.
  template <class Check>
  void check(const Check& check) const;

  /// Refuses keys that nobody asked for, here and in the groups below that were visited.
  void refuse_unknown() const;

  [[noreturn]] void fail(const std::string& what) const;

 private:
  explicit YamlFields(std::shared_ptr<const YamlTree> tree);

  struct Group {
    const YamlNode* node;  ///< null: the file has no such group
    std::string path;
  };
  const Group& group() const { return groups_.back(); }
  const YamlNode& nearest() const;
  std::string path_of(const std::string& name) const;
  std::optional<YamlValue> visited(const char* name) const;
  [[noreturn]] void fail_check(const std::string& what) const;

  std::shared_ptr<const YamlTree> tree_;
  std::vector<Group> groups_;  ///< the first one is the root of all that is read
  bool required_ = false;
};

template <class Enum>
void YamlFields::choice(const char* name, Enum& value, const EnumNames<Enum>& names) const {
  if (const auto found = visited(name)) value = found->choice(names);
}

template <class Check>
void YamlFields::check(const Check& check) const {
  try {
    check();
  } catch (const std::invalid_argument& error) {
    fail_check(error.what());
  }
}

}  // namespace falko_slam
