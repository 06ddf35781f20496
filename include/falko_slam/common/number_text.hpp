// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace falko_slam {

// Numbers in files: always with a point, whatever language the program speaks.

/// The whole text as a finite number, without blanks around it.
std::optional<double> number_of(const std::string& text);

/// The number at the beginning of a text, after blanks; infinite and NaN are numbers, too. `at`
/// moves behind it, or stays where there is none. For the long lines of logs.
std::optional<double> take_number(const char*& at);

/// The fewest digits that give the same number again.
std::string exact_text(double value);

/// With this many digits behind the point; never "-0.00".
std::string fixed_text(double value, int digits);

}  // namespace falko_slam
