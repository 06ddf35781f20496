// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/localizer_params.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "falko_slam/localization/localizer_fields.hpp"

namespace falko_slam {
namespace {

// Remembers where each number of the parameters stands, by its whole name.
class NumberCollector {
 public:
  void begin(const char* group) { groups_.push_back(group); }
  void end() { groups_.pop_back(); }
  template <class Value>
  void field(const char* name, Value& value) {
    add(name, value);
  }
  template <class Enum, class Names>
  void choice(const char*, Enum&, const Names&) {}

  struct Number {
    std::string name;
    double* value;
  };
  std::vector<Number> numbers;

 private:
  template <class Value>
  void add(const char*, Value&) {}
  void add(const char* name, double& value) {
    std::string whole;
    for (const std::string& group : groups_) whole += group + ".";
    numbers.push_back({whole + name, &value});
  }
  std::vector<std::string> groups_;
};

TEST(LocalizerParams, AreGoodAsTheyAre) { EXPECT_NO_THROW(validate(LocalizerParams{})); }

// Each of the numbers that files can set, by its name.
TEST(LocalizerParams, NameTheFieldThatIsNoNumber) {
  LocalizerParams params;
  NumberCollector collector;
  visit_localizer_fields(params, collector);
  EXPECT_GT(collector.numbers.size(), 50U);
  for (const auto& [name, value] : collector.numbers) {
    const double good = *value;
    *value = std::numeric_limits<double>::quiet_NaN();
    try {
      validate(params);
      ADD_FAILURE() << name << " may be NaN";
    } catch (const std::invalid_argument& error) {
      const std::string field = name.substr(name.find_last_of('.') + 1);
      EXPECT_NE(std::string(error.what()).find(field), std::string::npos) << error.what();
    }
    *value = good;
  }
}

}  // namespace
}  // namespace falko_slam
