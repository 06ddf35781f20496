// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/yaml_value.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <locale>
#include <stdexcept>

#include "falko_slam/common/enum_names.hpp"
#include "falko_slam/common/yaml_fields.hpp"

namespace falko_slam {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

enum class Pace { kSlow, kFast };
const EnumNames<Pace> kPaces = {{"slow", Pace::kSlow}, {"fast", Pace::kFast}};

// The value of a.b in a file.
YamlValue parsed(const std::string& text) {
  return YamlFields(YamlFields::of_text("a:\n  b: " + text + "\n", "c.yaml").at("a")).at("b");
}

std::string complaint(const std::string& text, const std::function<void(const YamlValue&)>& read) {
  try {
    read(parsed(text));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

TEST(YamlValue, ReadsNumbersAndAngles) {
  EXPECT_EQ(parsed("-1.5e3").number(), -1500.0);
  EXPECT_EQ(parsed("7").number(), 7.0);
  EXPECT_EQ(parsed("deg(180)").number(), 3.14159265358979323846);
  EXPECT_EQ(parsed("deg(-90.0)").number(), -0.5 * 3.14159265358979323846);
  EXPECT_EQ(parsed("rad(1.2)").number(), 1.2);
  EXPECT_EQ(parsed(".inf").number({0.0, kInfinity}), kInfinity);
  EXPECT_EQ(parsed("[1, deg(0), -3]").numbers(3), (std::vector<double>{1.0, 0.0, -3.0}));
}

TEST(YamlValue, RefusesWhatIsNoNumber) {
  const auto number = [](const YamlValue& value) { value.number(); };
  for (const char* text : {"five",     "1 2",         "1,5",   "\"5\"", "",       "~",      ".nan",
                           ".inf",     "-.inf",       "1e999", "deg(",  "deg()",  "deg(x)", "deg(1",
                           "rad(nan)", "deg(deg(1))", "0x10",  "[1]",   "{c: 1}", "true"}) {
    EXPECT_EQ(complaint(text, number), "c.yaml: line 2: a.b: must be a number") << text;
  }
}

TEST(YamlValue, NamesTheRangeOfANumber) {
  const auto in = [](double min, double max) {
    return [=](const YamlValue& value) { value.number({min, max}); };
  };
  constexpr double kMax = std::numeric_limits<double>::max();
  EXPECT_EQ(complaint("2", in(0.1, 1.0)), "c.yaml: line 2: a.b: must be a number in [0.1, 1]");
  EXPECT_EQ(complaint("-1", in(0.0, kMax)), "c.yaml: line 2: a.b: must be a number of at least 0");
  EXPECT_EQ(complaint("1", in(-kMax, 0.0)), "c.yaml: line 2: a.b: must be a number of at most 0");
  EXPECT_EQ(complaint(".nan", in(0.0, kInfinity)),
            "c.yaml: line 2: a.b: must be a number of at least 0");
}

TEST(YamlValue, NamesTheNumberOfNumbers) {
  const auto three = [](const YamlValue& value) { value.numbers(3); };
  EXPECT_EQ(complaint("[1, 2]", three), "c.yaml: line 2: a.b: must be three numbers");
  EXPECT_EQ(complaint("1", three), "c.yaml: line 2: a.b: must be three numbers");
  EXPECT_EQ(complaint("[1, 2, x]", three), "c.yaml: line 2: a.b[2]: must be a number");
  EXPECT_EQ(complaint("\n    - 1\n    - 2\n    - x", three),
            "c.yaml: line 5: a.b[2]: must be a number");
}

TEST(YamlValue, ReadsWholeNumbers) {
  EXPECT_EQ(parsed("-12").integer(), -12);
  EXPECT_EQ(parsed("4294967295").integer(), 4294967295);
  const auto small = [](const YamlValue& value) { value.integer(0, 10); };
  for (const char* text : {"11", "-1", "1.0", "1e1", "ten", "99999999999999999999", "\"3\"", ""}) {
    EXPECT_EQ(complaint(text, small), "c.yaml: line 2: a.b: must be a whole number in [0, 10]");
  }
}

TEST(YamlValue, ReadsFlagsTextsAndNames) {
  EXPECT_TRUE(parsed("true").flag());
  EXPECT_FALSE(parsed("false").flag());
  EXPECT_EQ(parsed("\"5 m\"").text(), "5 m");
  EXPECT_EQ(parsed("'it''s'").text(), "it's");
  EXPECT_EQ(parsed("fast").choice(kPaces), Pace::kFast);
  const auto flag = [](const YamlValue& value) { value.flag(); };
  const auto text = [](const YamlValue& value) { value.text(); };
  const auto mode = [](const YamlValue& value) { value.choice(kPaces); };
  EXPECT_EQ(complaint("1", flag), "c.yaml: line 2: a.b: must be true or false");
  EXPECT_EQ(complaint("[]", text), "c.yaml: line 2: a.b: must be a text");
  EXPECT_EQ(complaint("slower", mode), "c.yaml: line 2: a.b: must be slow or fast");
}

TEST(YamlValue, ListsItsItems) {
  const auto items = parsed("[1, [2, 3]]").items();
  ASSERT_EQ(items.size(), 2U);
  EXPECT_EQ(items[1].path(), "a.b[1]");
  EXPECT_EQ(items[1].items()[0].path(), "a.b[1][0]");
  EXPECT_TRUE(parsed("").items().empty());
  const auto list = [](const YamlValue& value) { value.items(); };
  EXPECT_EQ(complaint("{}", list), "c.yaml: line 2: a.b: must be a list");
}

TEST(YamlValue, SpeaksNoLanguage) {
  class Comma : public std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  const double value = parsed("1.5").number();
  std::locale::global(before);
  EXPECT_EQ(value, 1.5);
}

}  // namespace
}  // namespace falko_slam
