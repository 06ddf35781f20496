// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/yaml_value.hpp"

#include <charconv>
#include <optional>
#include <stdexcept>
#include <utility>

#include "falko_slam/common/number_text.hpp"
#include "yaml_tree.hpp"

namespace falko_slam {
namespace {

constexpr double kRadiansPerDegree = 3.14159265358979323846 / 180.0;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool begins(const std::string& text, const char* begin) { return text.rfind(begin, 0) == 0; }

// As rosparam reads it, but without its arithmetic.
std::optional<double> number_or_angle(const std::string& text) {
  const bool degrees = begins(text, "deg(");
  if (!degrees && !begins(text, "rad(")) return number_of(text);
  if (text.back() != ')') return std::nullopt;
  const auto value = number_of(text.substr(4, text.size() - 5));
  return value && degrees ? *value * kRadiansPerDegree : value;
}

std::optional<double> number_or_infinity(const std::string& text) {
  if (text == ".inf" || text == "+.inf") return kInfinity;
  if (text == "-.inf") return -kInfinity;
  return number_or_angle(text);
}

std::string description_of(const NumberRange& range) {
  const NumberRange any;
  const bool from = range.min > any.min;
  const bool to = range.max < any.max;
  if (from && to) return " in [" + exact_text(range.min) + ", " + exact_text(range.max) + "]";
  if (from) return " of at least " + exact_text(range.min);
  if (to) return " of at most " + exact_text(range.max);
  return "";
}

std::string count_of(std::size_t count, const char* what) {
  static const char* const kWords[] = {"no", "one", "two", "three", "four", "five", "six"};
  const bool has_word = count < sizeof kWords / sizeof kWords[0];
  return (has_word ? kWords[count] : std::to_string(count)) + std::string(" ") + what +
         (count == 1 ? "" : "s");
}

std::string whole_numbers_of(std::int64_t min, std::int64_t max) {
  using Limits = std::numeric_limits<std::int64_t>;
  if (min == Limits::min() && max == Limits::max()) return "";
  if (max == Limits::max()) return " of at least " + std::to_string(min);
  return " in [" + std::to_string(min) + ", " + std::to_string(max) + "]";
}

}  // namespace

YamlValue::YamlValue(std::shared_ptr<const YamlTree> tree, const YamlNode& node, std::string path)
    : tree_(std::move(tree)), node_(&node), path_(std::move(path)) {}

// Empty if it is none or quoted: no number, flag or name is.
std::string YamlValue::plain_text() const {
  return node_->kind == YamlNode::Kind::kText && !node_->quoted ? node_->text : "";
}

double YamlValue::number(const NumberRange& range) const {
  const auto value = number_or_infinity(plain_text());
  if (!value || !(*value >= range.min && *value <= range.max)) {
    fail("must be a number" + description_of(range));
  }
  return *value;
}

std::vector<double> YamlValue::numbers(std::size_t count, const NumberRange& range) const {
  std::vector<double> values;
  if (!is_list() || node_->items.size() != count) fail("must be " + count_of(count, "number"));
  for (const YamlValue& item : items()) values.push_back(item.number(range));
  return values;
}

std::int64_t YamlValue::integer(std::int64_t min, std::int64_t max) const {
  const std::string text = plain_text();
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  if (!whole || value < min || value > max) {
    fail("must be a whole number" + whole_numbers_of(min, max));
  }
  return value;
}

bool YamlValue::flag() const {
  const std::string text = plain_text();
  if (text != "true" && text != "false") fail("must be true or false");
  return text == "true";
}

std::string YamlValue::text() const {
  if (node_->kind != YamlNode::Kind::kText) fail("must be a text");
  return node_->text;
}

bool YamlValue::is_list() const { return node_->kind == YamlNode::Kind::kList; }

std::vector<YamlValue> YamlValue::items() const {
  std::vector<YamlValue> items;
  if (node_->kind == YamlNode::Kind::kNothing) return items;
  if (!is_list()) fail("must be a list");
  for (const YamlNode& item : node_->items) {
    items.emplace_back(tree_, item, path_ + "[" + std::to_string(items.size()) + "]");
  }
  return items;
}

void YamlValue::fail(const std::string& what) const {
  throw std::runtime_error(tree_->name + ": line " + std::to_string(node_->line) + ": " +
                           (path_.empty() ? "" : path_ + ": ") + what);
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') result += '\\';
    result += static_cast<unsigned char>(letter) < ' ' ? ' ' : letter;
  }
  return result + "\"";
}

}  // namespace falko_slam
