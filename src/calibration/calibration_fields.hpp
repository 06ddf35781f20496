// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "falko_slam/calibration/calibration_file.hpp"
#include "falko_slam/common/enum_names.hpp"

namespace falko_slam {

constexpr int kCalibrationFileVersion = 1;

inline const EnumNames<TricycleModel>& tricycle_model_names() {
  static const EnumNames<TricycleModel> names = {{"standard", TricycleModel::kStandard},
                                                 {"asymmetric", TricycleModel::kAsymmetric}};
  return names;
}

/// Those that come with numbers.
inline const EnumNames<CalibrationVerdict>& stored_verdict_names() {
  static const EnumNames<CalibrationVerdict> names = {{"OK", CalibrationVerdict::kOk},
                                                      {"WEAK", CalibrationVerdict::kWeak}};
  return names;
}

/// Calls the visitor for all fields but the lists, in the order of the file. `vector` are the
/// values of the parameters.
template <class Visitor, class Stored, class Vector>
void visit_calibration_fields(Visitor& visitor, Stored& stored, Vector& vector) {
  visitor.field("date", stored.date);
  visitor.choice("model", stored.model, tricycle_model_names());
  visitor.choice("verdict", stored.verdict, stored_verdict_names());
  visitor.begin("parameters");
  for (std::size_t i = 0; i < kCalibrationParameters; ++i) {
    visitor.field(name_of(static_cast<CalibrationParameter>(i)),
                  vector[static_cast<Eigen::Index>(i)]);
  }
  visitor.end();
  visitor.begin("conditions");
  visitor.field("segments", stored.conditions.segments);
  visitor.field("left_out", stored.conditions.left_out);
  visitor.field("chi2", stored.conditions.chi2);
  visitor.field("degrees_of_freedom", stored.conditions.degrees_of_freedom);
  visitor.field("forward_condition", stored.conditions.forward_condition);
  visitor.field("backward_condition", stored.conditions.backward_condition);
  visitor.field("laser_condition", stored.conditions.laser_condition);
  visitor.end();
}

/// Throws std::invalid_argument, "covariance = ...", for what no calibration can be.
void validate(const StoredCalibration& stored);

/// The whole file.
std::string calibration_text(const StoredCalibration& stored);

}  // namespace falko_slam
