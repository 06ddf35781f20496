// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace falko_slam {

/// A value of a YAML file and all that is in it.
struct YamlNode {
  enum class Kind { kNothing, kText, kList, kMap };

  Kind kind = Kind::kNothing;
  int line = 0;                   ///< of its key, or where it begins; the first is 1
  std::string text;               ///< of kText
  bool quoted = false;            ///< a text that is no number even if it looks like one
  std::vector<std::string> keys;  ///< of kMap, one for each item
  std::vector<int> key_lines;
  std::vector<YamlNode> items;  ///< of kList and kMap

  /// Whoever reads a map notes here what it may hold.
  mutable std::vector<std::string> known_keys;
};

/// A whole file.
struct YamlTree {
  std::string name;  ///< as it stands in messages
  YamlNode root;
};

/// Throws std::runtime_error, "name: line 3: what": syntax, duplicate keys, what goes too deep or
/// is too big; and aliases and tags, of which our files have none.
std::shared_ptr<const YamlTree> parse_yaml(const std::string& text, const std::string& name);
std::shared_ptr<const YamlTree> read_yaml(const std::string& path);

/// Somebody else's text in a message: not all of it if it is long, and nothing that moves a cursor.
std::string shown(const std::string& text);

}  // namespace falko_slam
