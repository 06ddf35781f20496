// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/parameter_reader.hpp"

#include <gtest/gtest.h>

namespace falko_slam {
namespace {

using XmlRpc::XmlRpcValue;

enum class Color { kRed, kGreen, kBlue };
const EnumNames<Color> kColors = {
    {"red", Color::kRed}, {"green", Color::kGreen}, {"blue", Color::kBlue}};

XmlRpcValue tree() {
  XmlRpcValue tree;
  tree["number"] = 2.5;
  tree["count"] = 7;
  tree["flag"] = true;
  tree["text"] = "abc";
  tree["color"] = "blue";
  tree["list"][0] = 1;
  tree["group"]["number"] = 4.5;
  return tree;
}

// What the reader says about the field `name` where `value` stands for the type asked for.
template <class Value>
std::string complaint(const char* name, Value value) {
  ParameterReader reader(tree(), "/node");
  try {
    reader.field(name, value);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(ParameterReader, ReadsEveryType) {
  ParameterReader reader(tree(), "/node");
  double number = 0.0;
  int count = 0;
  bool flag = false;
  std::string text;
  Color color = Color::kRed;
  reader.field("number", number);
  reader.field("count", count);
  reader.field("flag", flag);
  reader.field("text", text);
  reader.choice("color", color, kColors);
  EXPECT_EQ(number, 2.5);
  EXPECT_EQ(count, 7);
  EXPECT_TRUE(flag);
  EXPECT_EQ(text, "abc");
  EXPECT_EQ(color, Color::kBlue);
}

TEST(ParameterReader, ReadsAnIntegerWhereANumberIsNeeded) {
  ParameterReader reader(tree(), "/node");
  double value = 0.0;
  reader.field("count", value);
  EXPECT_EQ(value, 7.0);
}

TEST(ParameterReader, KeepsWhatTheTreeDoesNotHold) {
  double number = 1.25;
  Color color = Color::kGreen;
  for (const XmlRpcValue& nothing : {XmlRpcValue(), XmlRpcValue(3)}) {
    ParameterReader reader(nothing, "/node");
    reader.field("number", number);
    reader.begin("group");
    reader.choice("color", color, kColors);
    reader.end();
    EXPECT_EQ(number, 1.25);
    EXPECT_EQ(color, Color::kGreen);
    EXPECT_TRUE(reader.unknown().empty());
  }
}

TEST(ParameterReader, ReadsGroups) {
  ParameterReader reader(tree(), "/node");
  double inner = 0.0;
  double outer = 0.0;
  reader.begin("group");
  reader.field("number", inner);
  reader.end();
  reader.field("number", outer);
  EXPECT_EQ(inner, 4.5);
  EXPECT_EQ(outer, 2.5);
}

TEST(ParameterReader, RefusesTheWrongType) {
  EXPECT_EQ(complaint("text", 0.0), "/node/text is a text, must be a number");
  EXPECT_EQ(complaint("flag", 0.0), "/node/flag is a boolean, must be a number");
  EXPECT_EQ(complaint("number", 0), "/node/number is a number, must be an integer");
  EXPECT_EQ(complaint("count", false), "/node/count is an integer, must be true or false");
  EXPECT_EQ(complaint("list", std::string()), "/node/list is a list, must be a text");
  EXPECT_EQ(complaint("group", 0.0), "/node/group is a group, must be a number");
}

TEST(ParameterReader, NamesTheGroupOfTheWrongType) {
  ParameterReader reader(tree(), "/node");
  reader.begin("group");
  bool flag = false;
  try {
    reader.field("number", flag);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "/node/group/number is a number, must be true or false");
  }
}

TEST(ParameterReader, RefusesAValueWhereAGroupBelongs) {
  ParameterReader reader(tree(), "/node");
  try {
    reader.begin("count");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "/node/count is an integer, must be a group");
  }
}

TEST(ParameterReader, RefusesAChoiceThatThereIsNot) {
  ParameterReader reader(tree(), "/node");
  Color color = Color::kRed;
  try {
    reader.choice("text", color, kColors);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "/node/text = abc: must be red, green or blue");
  }
  EXPECT_EQ(color, Color::kRed);
}

TEST(ParameterReader, ListsNamesThatNobodyAskedFor) {
  ParameterReader reader(tree(), "/node");
  double value = 0.0;
  reader.field("number", value);
  reader.begin("group");
  reader.field("mumble", value);
  reader.end();
  EXPECT_EQ(
      reader.unknown({"flag", "text"}),
      (std::vector<std::string>{"/node/color", "/node/count", "/node/group/number", "/node/list"}));
}

}  // namespace
}  // namespace falko_slam
