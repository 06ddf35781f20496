// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "calibration_fields.hpp"
#include "falko_slam/common/number_text.hpp"
#include "falko_slam/common/yaml_value.hpp"

namespace falko_slam {
namespace {

template <class Numbers>
std::string list_text(const Numbers& numbers) {
  std::string text = "[";
  for (const double number : numbers) text += (text.size() > 1 ? ", " : "") + exact_text(number);
  return text + "]";
}

// A visitor of fields that writes them.
class YamlText {
 public:
  void field(const char* name, const std::string& value) { line(name, quoted(value)); }
  void field(const char* name, double value) { line(name, exact_text(value)); }
  void field(const char* name, int value) { line(name, std::to_string(value)); }
  template <class Enum>
  void choice(const char* name, Enum value, const EnumNames<Enum>& names) {
    line(name, name_of(value, names));
  }
  void begin(const char* name) {
    text_ += std::string(name) + ":\n";
    indent_ = "  ";
  }
  void end() { indent_.clear(); }
  void line(const std::string& name, const std::string& value) {
    text_ += indent_ + name + ": " + value + "\n";
  }
  void item(const std::string& value) { text_ += indent_ + "- " + value + "\n"; }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::string indent_;
};

}  // namespace

std::string calibration_text(const StoredCalibration& stored) {
  YamlText out;
  out.field("calibration_version", kCalibrationFileVersion);
  const CalibrationVector vector = vector_of(stored.calibration);
  visit_calibration_fields(out, stored, vector);
  out.begin("intervals");
  for (std::size_t i = 0; i < kCalibrationParameters; ++i) {
    const ParameterInterval& interval = stored.intervals[i];
    out.line(name_of(static_cast<CalibrationParameter>(i)),
             list_text(std::array<double, 2>{interval.low, interval.high}));
  }
  out.end();
  out.begin("covariance");
  for (Eigen::Index row = 0; row < stored.covariance.rows(); ++row) {
    std::array<double, kCalibrationParameters> numbers{};
    CalibrationVector::Map(numbers.data()) = stored.covariance.row(row).transpose();
    out.item(list_text(numbers));
  }
  out.end();
  if (!stored.remarks.empty()) {
    out.begin("remarks");
    for (const std::string& remark : stored.remarks) out.item(quoted(remark));
    out.end();
  }
  out.line("complete", "true");
  return "# Calibration of a tricycle and its laser: m, rad, m per tick. The rows of the "
         "covariance\n"
         "# are in the order of the parameters; what was held has none. Intervals: 95 %.\n" +
         out.text();
}

}  // namespace falko_slam
