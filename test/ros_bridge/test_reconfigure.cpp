// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/reconfigure.hpp"

#include <gtest/gtest.h>

#include "support/field_values.hpp"

namespace falko_slam {
namespace {

enum class Signal { kRed, kGreen };
const EnumNames<Signal> kSignals = {{"red", Signal::kRed}, {"green", Signal::kGreen}};

TEST(Reconfigure, EveryTypeComesBackAsItWent) {
  ReconfigureWriter writer;
  writer.field("number", 0.1);
  writer.field("count", -3);
  writer.field("flag", true);
  writer.field("text", std::string("abc"));
  writer.choice("color", Signal::kGreen, kSignals);
  const ReconfigureReader reader(writer.config());
  double number = 0.0;
  int count = 0;
  bool flag = false;
  std::string text;
  Signal color = Signal::kRed;
  reader.field("number", number);
  reader.field("count", count);
  reader.field("flag", flag);
  reader.field("text", text);
  reader.choice("color", color, kSignals);
  EXPECT_EQ(number, 0.1);
  EXPECT_EQ(count, -3);
  EXPECT_TRUE(flag);
  EXPECT_EQ(text, "abc");
  EXPECT_EQ(color, Signal::kGreen);
}

TEST(Reconfigure, FalkoParametersComeBackAsTheyWent) {
  FalkoParams params;
  test::FieldChanger changer;
  visit_falko_fields(params, changer);
  ReconfigureWriter writer;
  visit_falko_fields(static_cast<const FalkoParams&>(params), writer);
  FalkoParams back;
  ReconfigureReader reader(writer.config());
  visit_falko_fields(back, reader);
  EXPECT_EQ(test::values_of(back), test::values_of(params));
}

TEST(Reconfigure, KeepsWhatTheConfigurationDoesNotHold) {
  const dynamic_reconfigure::Config nothing;
  double number = 1.25;
  Signal color = Signal::kGreen;
  const ReconfigureReader reader(nothing);
  reader.field("number", number);
  reader.choice("color", color, kSignals);
  EXPECT_EQ(number, 1.25);
  EXPECT_EQ(color, Signal::kGreen);
}

TEST(Reconfigure, RefusesAChoiceThatThereIsNot) {
  ReconfigureWriter writer;
  writer.field("color", std::string("pink"));
  Signal color = Signal::kRed;
  try {
    ReconfigureReader(writer.config()).choice("color", color, kSignals);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "color = pink: must be red or green");
  }
}

}  // namespace
}  // namespace falko_slam
