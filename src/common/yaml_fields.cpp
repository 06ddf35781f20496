// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/yaml_fields.hpp"

#include <algorithm>

#include "yaml_tree.hpp"

namespace falko_slam {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string list_of(const std::vector<std::string>& names, const char* last) {
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) list += i + 1 == names.size() ? last : ", ";
    list += names[i];
  }
  return list;
}

const YamlNode* item_of(const YamlNode& map, const std::string& name) {
  const auto key = std::find(map.keys.begin(), map.keys.end(), name);
  if (key == map.keys.end()) return nullptr;
  return &map.items[static_cast<std::size_t>(key - map.keys.begin())];
}

void remember(const YamlNode& map, const std::string& name) {
  if (!contains(map.known_keys, name)) map.known_keys.push_back(name);
}

void require_group(const YamlValue& value) {
  const YamlNode::Kind kind = value.node().kind;
  if (kind != YamlNode::Kind::kMap && kind != YamlNode::Kind::kNothing) {
    value.fail("must be a group of fields (name: value)");
  }
}

std::string joined(const std::string& path, const std::string& name) {
  return path.empty() ? shown(name) : path + "." + shown(name);
}

// Of a map that nobody has read (known_keys is empty) somebody else takes care.
void refuse_unknown_in(const YamlValue& value) {
  const YamlNode& node = value.node();
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    if (node.known_keys.empty() || node.kind != YamlNode::Kind::kMap) break;
    if (contains(node.known_keys, node.keys[i])) {
      refuse_unknown_in({value.tree(), node.items[i], joined(value.path(), node.keys[i])});
      continue;
    }
    YamlNode unknown;
    unknown.line = node.key_lines[i];
    YamlValue(value.tree(), unknown, joined(value.path(), node.keys[i]))
        .fail("nobody knows this; known are " + list_of(node.known_keys, " and "));
  }
}

}  // namespace

YamlFields::YamlFields(const std::string& path) : YamlFields(read_yaml(path)) {}

YamlFields YamlFields::of_text(const std::string& text, const std::string& name) {
  return YamlFields(parse_yaml(text, name));
}

YamlFields::YamlFields(std::shared_ptr<const YamlTree> tree) : tree_(std::move(tree)) {
  if (tree_->root.kind == YamlNode::Kind::kNothing) {
    throw std::runtime_error(tree_->name + ": is empty");
  }
  require_group({tree_, tree_->root, ""});
  groups_.push_back({&tree_->root, ""});
}

YamlFields::YamlFields(const YamlValue& value) : tree_(value.tree()) {
  require_group(value);
  groups_.push_back({&value.node(), value.path()});
}

std::string YamlFields::path_of(const std::string& name) const {
  return joined(group().path, name);
}

bool YamlFields::has(const std::string& name) const { return find(name).has_value(); }

std::optional<YamlValue> YamlFields::find(const std::string& name) const {
  if (group().node == nullptr) return std::nullopt;
  remember(*group().node, name);
  const YamlNode* item = item_of(*group().node, name);
  if (item == nullptr) return std::nullopt;
  return YamlValue(tree_, *item, path_of(name));
}

YamlValue YamlFields::at(const std::string& name) const {
  const auto value = find(name);
  if (!value) fail(name + " is missing");
  return *value;
}

std::string YamlFields::one_of(const std::vector<std::string>& names) const {
  std::vector<std::string> found;
  for (const std::string& name : names) {
    if (has(name)) found.push_back(name);
  }
  if (found.empty()) fail("must have one of " + list_of(names, " and "));
  if (found.size() > 1) fail("has " + list_of(found, " and ") + ", must have one of them only");
  return found.front();
}

std::vector<std::pair<std::string, YamlValue>> YamlFields::all() const {
  std::vector<std::pair<std::string, YamlValue>> all;
  if (group().node == nullptr) return all;
  for (const std::string& key : group().node->keys) all.emplace_back(key, at(key));
  return all;
}

void YamlFields::begin(const char* name) {
  const auto value = find(name);
  if (value) require_group(*value);
  groups_.push_back({value ? &value->node() : nullptr, path_of(name)});
}

void YamlFields::end() { groups_.pop_back(); }

std::optional<YamlValue> YamlFields::visited(const char* name) const {
  return required_ ? at(name) : find(name);
}

void YamlFields::field(const char* name, double& value) const {
  if (const auto found = visited(name)) value = found->number();
}

void YamlFields::field(const char* name, bool& value) const {
  if (const auto found = visited(name)) value = found->flag();
}

void YamlFields::field(const char* name, int& value) const {
  using Limits = std::numeric_limits<int>;
  const auto found = visited(name);
  if (found) value = static_cast<int>(found->integer(Limits::min(), Limits::max()));
}

void YamlFields::field(const char* name, unsigned int& value) const {
  constexpr std::int64_t kMost = std::numeric_limits<unsigned int>::max();
  if (const auto found = visited(name)) value = static_cast<unsigned int>(found->integer(0, kMost));
}

void YamlFields::field(const char* name, unsigned long& value) const {
  if (const auto found = visited(name)) value = static_cast<unsigned long>(found->integer(0));
}

void YamlFields::field(const char* name, std::string& value) const {
  if (const auto found = visited(name)) value = found->text();
}

void YamlFields::refuse_unknown() const {
  if (group().node != nullptr) refuse_unknown_in({tree_, *group().node, group().path});
}

// The group, or the nearest one around it if the file has none.
const YamlNode& YamlFields::nearest() const {
  return *std::find_if(groups_.rbegin(), groups_.rend(), [](const Group& one) {
            return one.node != nullptr;
          })->node;
}

void YamlFields::fail(const std::string& what) const {
  YamlValue(tree_, nearest(), group().path).fail(what);
}

void YamlFields::fail_check(const std::string& what) const {
  const std::string name = what.substr(0, what.find(' '));
  const YamlNode* place = &nearest();
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('.', begin), name.size());
    const YamlNode* field = item_of(*place, name.substr(begin, end - begin));
    if (field == nullptr) break;
    place = field;
    begin = end + 1;
  }
  const std::string path = group().path.empty() ? "" : group().path + ".";
  YamlValue(tree_, *place, "").fail(path + what);
}

}  // namespace falko_slam
