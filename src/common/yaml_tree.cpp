// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "yaml_tree.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace falko_slam {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{1} << 20U;
constexpr std::size_t kMaxValues = 200000;
constexpr std::size_t kMaxDepth = 32;  // the parser goes deeper with each bracket
constexpr std::size_t kMaxShown = 60;

[[noreturn]] void fail(const std::string& name, int line, const std::string& what) {
  throw std::runtime_error(name + ": line " + std::to_string(line) + ": " + what);
}

int line_of(const YAML::Mark& mark) { return std::max(mark.line, 0) + 1; }

// Builds the tree while the parser reads, so that it stops where there is too much.
class TreeBuilder : public YAML::EventHandler {
 public:
  explicit TreeBuilder(YamlTree& tree) : tree_(tree) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (begun_) fail(tree_.name, line_of(mark), "a second document begins");
    begun_ = true;
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override {
    if (is_key()) fail(tree_.name, line_of(mark), "a key is empty");
    add(mark, YamlNode::Kind::kNothing);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    fail(tree_.name, line_of(mark), "aliases (*name) are not understood here");
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                const std::string& text) override {
    refuse_tag(mark, tag);
    if (is_key()) return add_key(mark, text);
    YamlNode& node = add(mark, YamlNode::Kind::kText);
    node.text = text;
    node.quoted = tag == "!";
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    open(mark, tag, YamlNode::Kind::kList);
  }
  void OnSequenceEnd() override { open_.pop_back(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {
    open(mark, tag, YamlNode::Kind::kMap);
  }
  void OnMapEnd() override { open_.pop_back(); }

 private:
  bool is_key() const {
    return !open_.empty() && open_.back()->kind == YamlNode::Kind::kMap &&
           open_.back()->keys.size() == open_.back()->items.size();
  }

  void refuse_tag(const YAML::Mark& mark, const std::string& tag) const {
    if (tag.empty() || tag == "?" || tag == "!") return;
    fail(tree_.name, line_of(mark), "tags (" + shown(tag) + ") are not understood here");
  }

  void add_key(const YAML::Mark& mark, const std::string& key) {
    YamlNode& map = *open_.back();
    const auto first = std::find(map.keys.begin(), map.keys.end(), key);
    if (first != map.keys.end()) {
      const int line = map.key_lines[static_cast<std::size_t>(first - map.keys.begin())];
      fail(tree_.name, line_of(mark),
           shown(key) + " stands here twice, first in line " + std::to_string(line));
    }
    map.keys.push_back(key);
    map.key_lines.push_back(line_of(mark));
  }

  YamlNode& add(const YAML::Mark& mark, YamlNode::Kind kind) {
    if (++values_ > kMaxValues) fail(tree_.name, line_of(mark), "holds too many values");
    YamlNode* node = &tree_.root;
    int line = line_of(mark);
    if (!open_.empty()) {
      const YamlNode& parent = *open_.back();
      const bool below_key = kind != YamlNode::Kind::kText && !parent.key_lines.empty();
      if (below_key) line = parent.key_lines.back();
      node = &open_.back()->items.emplace_back();
    }
    node->kind = kind;
    node->line = line;
    return *node;
  }

  void open(const YAML::Mark& mark, const std::string& tag, YamlNode::Kind kind) {
    refuse_tag(mark, tag);
    if (is_key()) fail(tree_.name, line_of(mark), "keys must be texts");
    if (open_.size() >= kMaxDepth) fail(tree_.name, line_of(mark), "goes too deep");
    open_.push_back(&add(mark, kind));
  }

  YamlTree& tree_;
  bool begun_ = false;
  std::size_t values_ = 0;
  std::vector<YamlNode*> open_;  // from the root down; only the last one grows
};

}  // namespace

std::string shown(const std::string& text) {
  std::string clean = text.substr(0, kMaxShown);
  for (char& letter : clean) {
    if (static_cast<unsigned char>(letter) < 0x20U || letter == 0x7F) letter = '?';
  }
  return text.size() > kMaxShown ? clean + "..." : clean;
}

std::shared_ptr<const YamlTree> parse_yaml(const std::string& text, const std::string& name) {
  if (text.size() > kMaxBytes) throw std::runtime_error(name + ": is too big for a YAML file");
  auto tree = std::make_shared<YamlTree>();
  tree->name = name;
  TreeBuilder builder(*tree);
  try {
    std::istringstream in(text);
    YAML::Parser parser(in);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const YAML::Exception& error) {
    fail(name, line_of(error.mark), error.msg);
  }
  return tree;
}

std::shared_ptr<const YamlTree> read_yaml(const std::string& path) {
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  in.peek();
  if (!in.is_open() || in.bad()) {
    throw std::runtime_error(path + ": cannot be read: " + std::strerror(errno));
  }
  std::string text(kMaxBytes + 1, '\0');
  in.clear();
  in.read(&text[0], static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return parse_yaml(text, path);
}

}  // namespace falko_slam
