// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/number_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace falko_slam {
namespace {

TEST(NumberText, ExactTextComesBackWithTheFewestDigits) {
  EXPECT_EQ(exact_text(0.05), "0.05");
  EXPECT_EQ(exact_text(-3.0), "-3");
  EXPECT_EQ(exact_text(0.1 + 0.2), "0.30000000000000004");
  for (const double value : {1.0 / 3.0, -2e-308, 1.7976931348623157e308, 12345.678, 0.0}) {
    EXPECT_EQ(number_of(exact_text(value)), value);
  }
}

TEST(NumberText, FixedTextHasNoNegativeZero) {
  EXPECT_EQ(fixed_text(-0.0004, 3), "0.000");
  EXPECT_EQ(fixed_text(-0.0006, 3), "-0.001");
  EXPECT_EQ(fixed_text(1234567.25, 1), "1234567.2");
}

TEST(NumberText, OnlyWholeFiniteNumbersAreNumbers) {
  EXPECT_EQ(number_of("-1.5e3"), -1500.0);
  for (const char* text : {"", " 1", "1 ", "1,5", "1x", "nan", "inf", "1e999", "0x10", "--1"}) {
    EXPECT_EQ(number_of(text), std::nullopt) << text;
  }
}

TEST(NumberText, TakesOneNumberAfterTheOther) {
  const std::string line = " 1.5 -2e3\t7x nan";
  const char* at = line.c_str();

  EXPECT_EQ(take_number(at), 1.5);
  EXPECT_EQ(take_number(at), -2000.0);
  EXPECT_EQ(take_number(at), 7.0);
  EXPECT_EQ(take_number(at), std::nullopt);
  EXPECT_STREQ(at, "x nan");
  EXPECT_TRUE(std::isnan(take_number(++at).value()));
  EXPECT_EQ(take_number(at), std::nullopt);
}

}  // namespace
}  // namespace falko_slam
