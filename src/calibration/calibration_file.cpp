// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/calibration_file.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "calibration_fields.hpp"
#include "falko_slam/common/validation.hpp"
#include "falko_slam/common/whole_file.hpp"
#include "falko_slam/common/yaml_fields.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

constexpr double kRounding = 1e-9;  // of a correlation
constexpr double kFar = 1e3;        // [m]

std::string text_of(const CalibrationRemark& remark) {
  return std::string(name_of(remark.verdict)) + ": " + remark.reason +
         (remark.remedy.empty() ? "" : "; " + remark.remedy);
}

// In correlations, so that it does not matter that ticks are short and metres long.
bool is_covariance(const CalibrationMatrix& covariance) {
  if (!covariance.allFinite() || covariance.diagonal().minCoeff() < 0.0) return false;
  const CalibrationVector scale =
      (covariance.diagonal().array() > 0.0).select(covariance.diagonal().cwiseSqrt(), 1.0);
  const CalibrationVector by = scale.cwiseInverse();
  const CalibrationMatrix correlation = by.asDiagonal() * covariance * by.asDiagonal();
  if ((correlation - correlation.transpose()).cwiseAbs().maxCoeff() > kRounding) return false;
  return Eigen::SelfAdjointEigenSolver<CalibrationMatrix>(correlation).eigenvalues()[0] >
         -kRounding;
}

CalibrationMatrix covariance_in(const YamlFields& file) {
  const YamlValue value = file.at("covariance");
  const std::vector<YamlValue> rows = value.items();
  if (rows.size() != kCalibrationParameters) value.fail("must have 8 rows");
  CalibrationMatrix covariance;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const std::vector<double> numbers = rows[row].numbers(kCalibrationParameters);
    covariance.row(static_cast<Eigen::Index>(row)) =
        CalibrationVector::Map(numbers.data()).transpose();
  }
  if (!is_covariance(covariance)) value.fail("must be symmetric and positive semidefinite");
  return covariance;
}

void read_intervals(YamlFields& file, StoredCalibration& stored) {
  const YamlFields intervals(file.at("intervals"));
  for (std::size_t i = 0; i < kCalibrationParameters; ++i) {
    const YamlValue value = intervals.at(name_of(static_cast<CalibrationParameter>(i)));
    const std::vector<double> ends = value.numbers(2);
    if (ends[0] > ends[1]) value.fail("must not end before it begins");
    stored.intervals[i] = {ends[0], ends[1]};
  }
  intervals.refuse_unknown();
}

// Of both kinds of results.
template <class Result>
StoredCalibration stored_estimate(const Result& result) {
  if (!result.estimate) {
    throw std::invalid_argument(std::string("verdict = ") + name_of(result.verdict) +
                                ": there is nothing to write");
  }
  const CalibrationEstimate& estimate = *result.estimate;
  StoredCalibration stored;
  stored.verdict = result.verdict;
  stored.calibration = estimate.calibration;
  stored.covariance = estimate.covariance;
  stored.intervals = estimate.intervals;
  const auto used = std::count_if(estimate.segments.begin(), estimate.segments.end(),
                                  [](const SegmentReport& segment) { return segment.used; });
  stored.conditions.segments = static_cast<int>(estimate.segments.size());
  stored.conditions.left_out = stored.conditions.segments - static_cast<int>(used);
  stored.conditions.chi2 = estimate.chi2;
  stored.conditions.degrees_of_freedom = estimate.degrees_of_freedom;
  for (const CalibrationRemark& remark : result.remarks) stored.remarks.push_back(text_of(remark));
  return stored;
}

}  // namespace

void validate(const StoredCalibration& stored) {
  const CalibrationVector vector = vector_of(stored.calibration);
  require_in_range("parameters.steer_offset_forward", vector[0], -kPi, kPi);
  require_in_range("parameters.steer_offset_backward", vector[1], -kPi, kPi);
  require_in_range("parameters.driving_scale", vector[2], 1e-9, 1.0);
  require_in_range("parameters.laser_x", vector[3], -kFar, kFar);
  require_in_range("parameters.laser_y", vector[4], -kFar, kFar);
  require_in_range("parameters.laser_theta", vector[5], -kPi, kPi);
  require_in_range("parameters.wheelbase", vector[6], 0.05, 20.0);
  require_in_range("parameters.steer_gain", vector[7], 0.01, 100.0);
}

StoredCalibration stored_calibration(const CalibrationResult& result, TricycleModel model,
                                     const std::string& date) {
  StoredCalibration stored = stored_estimate(result);
  stored.date = date;
  stored.model = model;
  stored.conditions.forward_condition = result.observability.forward_condition;
  stored.conditions.backward_condition = result.observability.backward_condition;
  stored.conditions.laser_condition = result.observability.laser_condition;
  return stored;
}

StoredCalibration stored_calibration(const TrajectoryCalibrationResult& result, TricycleModel model,
                                     const std::string& date) {
  StoredCalibration stored = stored_estimate(result);
  stored.date = date;
  stored.model = model;
  return stored;
}

std::string previous_calibration_path(const std::string& path) {
  const std::filesystem::path whole(path);
  return (whole.parent_path() / (whole.stem().string() + ".previous" + whole.extension().string()))
      .string();
}

void write_calibration(const std::string& path, const StoredCalibration& stored) {
  validate(stored);
  if (!is_covariance(stored.covariance)) {
    throw std::invalid_argument("covariance: must be symmetric and positive semidefinite");
  }
  if (stored.verdict > CalibrationVerdict::kWeak) {
    throw std::invalid_argument(std::string("verdict = ") + name_of(stored.verdict) +
                                ": there is nothing to write");
  }
  if (std::filesystem::exists(path)) {
    write_whole_file(previous_calibration_path(path), read_whole_file(path));
  }
  write_whole_file(path, calibration_text(stored));
}

StoredCalibration read_calibration(const std::string& path) {
  YamlFields file(path);
  file.require_fields();
  file.at("calibration_version").integer(kCalibrationFileVersion, kCalibrationFileVersion);
  StoredCalibration stored;
  CalibrationVector vector = CalibrationVector::Zero();
  visit_calibration_fields(file, stored, vector);
  stored.calibration = calibration_of(vector);
  file.check([&vector] { require_in_range("parameters.laser_theta", vector[5], -kPi, kPi); });
  file.check([&stored] { validate(stored); });
  read_intervals(file, stored);
  stored.covariance = covariance_in(file);
  if (const auto remarks = file.find("remarks")) {
    for (const YamlValue& remark : remarks->items()) stored.remarks.push_back(remark.text());
  }
  if (!file.at("complete").flag()) file.at("complete").fail("must be true");
  file.refuse_unknown();
  return stored;
}

}  // namespace falko_slam
