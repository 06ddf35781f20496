// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace falko_slam {
namespace test {

/// What std::invalid_argument, thrown by `act`, says; empty if it throws nothing.
template <class Act>
std::string refusal_of(Act&& act) {
  try {
    act();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

/// Expects that `act` refuses with all of these words.
template <class Act>
void expect_refused(Act&& act, const std::vector<std::string>& words) {
  const std::string text = refusal_of(act);
  for (const std::string& word : words) {
    EXPECT_NE(text.find(word), std::string::npos) << word << " in: " << text;
  }
}

}  // namespace test
}  // namespace falko_slam
