// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "g2o_line.hpp"

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <stdexcept>

#include "falko_slam/common/number_text.hpp"

namespace falko_slam {
namespace {

// Takes numbers from a line, or throws what is there in place of one.
class G2oNumbers {
 public:
  explicit G2oNumbers(const std::string& text) : at_(text.c_str()) {}

  KeyframeId id() {
    skip_blanks();
    char* end = nullptr;
    errno = 0;
    const unsigned long long value = std::strtoull(at_, &end, 10);
    if (end == at_ || *at_ == '-' || errno != 0 || !ends_word(*end)) fail("a node's number");
    at_ = end;
    return {value};
  }
  double number() {
    skip_blanks();
    const char* end = at_;
    const std::optional<double> value = take_number(end);
    if (!value || !ends_word(*end)) fail("a number");
    if (!std::isfinite(*value)) fail("a finite number");
    at_ = end;
    return *value;
  }
  Pose2 pose() {
    const double x = number(), y = number();
    return {x, y, number()};
  }
  bool at_end() {
    skip_blanks();
    return *at_ == '\0';
  }
  void require_end() {
    if (!at_end()) fail("the end of the line");
  }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
  static bool ends_word(char c) { return c == '\0' || is_blank(c); }
  void skip_blanks() {
    while (is_blank(*at_)) ++at_;
  }
  [[noreturn]] void fail(const std::string& wanted) {
    const std::string rest(at_);
    const std::string word = rest.substr(0, rest.find_first_of(" \t\r"));
    throw std::runtime_error(word.empty() ? "ends where " + wanted + " is wanted"
                                          : "\"" + word + "\" where " + wanted + " is wanted");
  }

  const char* at_;
};

// Row and column of each of the six numbers.
using InformationOrder = std::array<std::array<Eigen::Index, 2>, 6>;
constexpr InformationOrder kG2o{{{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};
constexpr InformationOrder kToro{{{0, 0}, {0, 1}, {1, 1}, {2, 2}, {0, 2}, {1, 2}}};

GraphConstraint parse_edge(const std::string& text, const InformationOrder& order) {
  G2oNumbers numbers(text);
  GraphConstraint edge;
  edge.from = numbers.id();
  edge.to = numbers.id();
  edge.from_T_to = numbers.pose();
  for (const auto& [row, column] : order) {
    edge.information(row, column) = edge.information(column, row) = numbers.number();
  }
  numbers.require_end();
  if (edge.from == edge.to) throw std::runtime_error("an edge of a node with itself");
  try {
    square_root_of_information(edge.information);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(error.what());
  }
  return edge;
}

}  // namespace

GraphNode parse_g2o_vertex(const std::string& text) {
  G2oNumbers numbers(text);
  const KeyframeId id = numbers.id();
  const Pose2 pose = numbers.pose();
  numbers.require_end();
  return {id, pose};
}

GraphConstraint parse_g2o_edge(const std::string& text) { return parse_edge(text, kG2o); }
GraphConstraint parse_toro_edge(const std::string& text) { return parse_edge(text, kToro); }

std::vector<KeyframeId> parse_g2o_fix(const std::string& text) {
  G2oNumbers numbers(text);
  std::vector<KeyframeId> ids{numbers.id()};
  while (!numbers.at_end()) ids.push_back(numbers.id());
  return ids;
}

}  // namespace falko_slam
