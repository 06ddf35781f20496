// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/number_text.hpp"

#include <locale.h>  // NOLINT(modernize-deprecated-headers): newlocale is not of the standard

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <locale>
#include <sstream>

namespace falko_slam {

std::optional<double> number_of(const std::string& text) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  double value = 0.0;
  const bool whole =
      in >> std::noskipws >> value && in.peek() == std::istringstream::traits_type::eof();
  return whole ? std::optional<double>(value) : std::nullopt;
}

std::optional<double> take_number(const char*& at) {
  static const locale_t kPlain = newlocale(LC_ALL_MASK, "C", nullptr);
  char* end = nullptr;
  const double value = strtod_l(at, &end, kPlain);
  if (end == at) return std::nullopt;
  at = end;
  return value;
}

std::string exact_text(double value) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  for (int digits = std::numeric_limits<double>::digits10;; ++digits) {
    out.str("");
    out.precision(digits);
    out << value;
    if (digits >= std::numeric_limits<double>::max_digits10 || number_of(out.str()) == value) break;
  }
  return out.str();
}

std::string fixed_text(double value, int digits) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.setf(std::ios::fixed, std::ios::floatfield);
  out.precision(digits);
  out << value;
  std::string text = out.str();
  const bool zero = text.find_first_not_of("-0.") == std::string::npos;
  if (zero) text.erase(std::remove(text.begin(), text.end(), '-'), text.end());
  return text;
}

}  // namespace falko_slam
