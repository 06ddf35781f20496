// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace falko_slam {

/// The names under which the values of an enumeration stand in files.
template <class Enum>
using EnumNames = std::vector<std::pair<const char*, Enum>>;

template <class Enum>
const char* name_of(Enum value, const EnumNames<Enum>& names) {
  for (const auto& [name, candidate] : names) {
    if (candidate == value) return name;
  }
  return "?";
}

template <class Enum>
std::optional<Enum> value_of(const std::string& name, const EnumNames<Enum>& names) {
  for (const auto& [candidate, value] : names) {
    if (name == candidate) return value;
  }
  return std::nullopt;
}

/// "a, b or c", for messages.
template <class Enum>
std::string list_names(const EnumNames<Enum>& names) {
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) list += i + 1 == names.size() ? " or " : ", ";
    list += names[i].first;
  }
  return list;
}

}  // namespace falko_slam
