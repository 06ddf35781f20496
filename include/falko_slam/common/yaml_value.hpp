// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "falko_slam/common/enum_names.hpp"

namespace falko_slam {

struct YamlNode;
struct YamlTree;

/// What a number may be: finite, unless an end is infinity.
struct NumberRange {
  double min = std::numeric_limits<double>::lowest();
  double max = std::numeric_limits<double>::max();
};

/// A value of a YAML file that knows where it stands. Whatever it is not throws std::runtime_error,
/// "warehouse.yaml: line 12: world[3].box.size: must be two numbers".
class YamlValue {
 public:
  /// `path` are the keys that lead to it, "world[3].box.size"; empty: the file itself.
  YamlValue(std::shared_ptr<const YamlTree> tree, const YamlNode& node, std::string path);

  /// As 90, 9e1, deg(90), rad(1.57), or .inf where the range asks for it.
  double number(const NumberRange& range = {}) const;
  std::vector<double> numbers(std::size_t count, const NumberRange& range = {}) const;
  std::int64_t integer(std::int64_t min = std::numeric_limits<std::int64_t>::min(),
                       std::int64_t max = std::numeric_limits<std::int64_t>::max()) const;
  bool flag() const;         ///< true or false
  std::string text() const;  ///< may be empty, ""
  template <class Enum>
  Enum choice(const EnumNames<Enum>& names) const;

  bool is_list() const;
  /// Of a list; nothing at all counts as an empty one.
  std::vector<YamlValue> items() const;

  const std::string& path() const { return path_; }
  const YamlNode& node() const { return *node_; }
  const std::shared_ptr<const YamlTree>& tree() const { return tree_; }

  /// Throws "file: line: path: what".
  [[noreturn]] void fail(const std::string& what) const;

 private:
  std::string plain_text() const;

  std::shared_ptr<const YamlTree> tree_;
  const YamlNode* node_;
  std::string path_;
};

/// A text in double quotes, as YAML reads it back; a control character becomes a blank.
std::string quoted(const std::string& text);

template <class Enum>
Enum YamlValue::choice(const EnumNames<Enum>& names) const {
  const auto value = value_of(plain_text(), names);
  if (!value) fail("must be " + list_names(names));
  return *value;
}

}  // namespace falko_slam
