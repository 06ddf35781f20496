// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "calibration_report.hpp"

#include <cmath>
#include <cstdio>
#include <string>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace cli {
namespace {

using Parameter = CalibrationParameter;

struct Column {
  Parameter parameter;
  const char* title;
};
constexpr Column kColumns[] = {{Parameter::kSteerOffsetForward, "alpha_F [cdeg]"},
                               {Parameter::kSteerOffsetBackward, "alpha_B [cdeg]"},
                               {Parameter::kDrivingScale, "s_w [1e-5 mm/tick]"},
                               {Parameter::kLaserX, "l_x [mm]"},
                               {Parameter::kLaserY, "l_y [mm]"},
                               {Parameter::kLaserTheta, "l_theta [cdeg]"}};

template <class... Values>
std::string text(const char* format, Values... values) {
  char line[128];
  std::snprintf(line, sizeof line, format, values...);
  return line;
}

template <class Cell>
void print_row(const std::string& label, Cell cell) {
  std::printf("%-32s", label.c_str());
  for (const Column& column : kColumns) std::printf(" %19s", cell(column.parameter).c_str());
  std::printf("\n");
}

void print_header(const std::string& title) {
  std::printf("\n%s\n%-32s", title.c_str(), " no. n_seg  alpha    beta   v_w");
  for (const Column& column : kColumns) std::printf(" %19s", column.title);
  std::printf("\n");
}

std::string label_of(const StudiedCondition& studied) {
  const CalibrationCondition& condition = studied.report.condition;
  return text("%3zu  %3d  %2.0f-%2.0f deg  %3.0f deg  %.1f m/s", studied.number,
              condition.arcs_per_phase, radians_to_degrees(condition.min_steering),
              radians_to_degrees(condition.max_steering), radians_to_degrees(condition.turn),
              condition.wheel_speed);
}

void print_deviations(const CalibrationStudy& study) {
  const DeviationScatter scatter = scatter_of_deviation(study.conditions.front().report.runs);
  print_header("Standard deviations: closed form / maximum likelihood / Cramer-Rao bound");
  for (const StudiedCondition& condition : study.conditions) {
    print_row(label_of(condition), [&](Parameter parameter) {
      const ParameterStatistics& here = condition.report.parameters[index_of(parameter)];
      const double unit = thesis_unit(parameter);
      const std::string bound = here.bound > 0.0 ? text("%.2f", unit * here.bound) : "-";
      return text("%.2f/%.2f/%s", unit * here.closed_form_deviation, unit * here.deviation,
                  bound.c_str());
    });
  }
  if (study.conditions.front().report.parameters[0].bound > 0.0) {
    print_row("likelihood / bound: rms, greatest", [&](Parameter parameter) {
      const StudiedParameter all = over_all(study, parameter, study.model);
      return text("%.3f %.3f", all.over_bound, all.greatest_over_bound);
    });
  }
  std::printf("A deviation of %d runs is, in 95 of 100 cases, %.3f to %.3f of the true one.\n",
              study.conditions.front().report.runs, scatter.low, scatter.high);
}

void print_honesty(const CalibrationStudy& study) {
  print_header("Bias [deviations] and share of the 95 % intervals that contain the truth [%]");
  for (const StudiedCondition& condition : study.conditions) {
    print_row(label_of(condition), [&](Parameter parameter) {
      const ParameterStatistics& here = condition.report.parameters[index_of(parameter)];
      const double bias = here.deviation > 0.0 ? here.bias / here.deviation : 0.0;
      return text("%+.2f %5.1f", bias, 100.0 * here.coverage);
    });
  }
  int runs = 0, refused = 0;
  for (const StudiedCondition& condition : study.conditions) {
    runs += condition.report.runs;
    refused += condition.report.refused;
  }
  print_row("greatest bias, all intervals", [&](Parameter parameter) {
    const StudiedParameter all = over_all(study, parameter, study.model);
    return text("%.2f %5.1f", all.greatest_bias, 100.0 * all.coverage);
  });
  std::printf("%d calibrations, %d refused\n", runs, refused);
}

void print_published(const CalibrationStudy& study) {
  const bool standard = study.model == TricycleModel::kStandard;
  print_header(std::string("Standard deviations: ours, thesis Table 5.1 (STC), Table 5.2 (ATC); ") +
               "!: not less than " + (standard ? "5.1" : "5.2"));
  for (const StudiedCondition& condition : study.conditions) {
    print_row(label_of(condition), [&](Parameter parameter) {
      const auto row = static_cast<Eigen::Index>(index_of(parameter));
      const double unit = thesis_unit(parameter);
      const double ours = condition.report.parameters[index_of(parameter)].deviation;
      return text("%.2f%s %5.2f %5.2f", unit * ours,
                  ours < condition.published.of(study.model).deviation[row] ? " " : "!",
                  unit * condition.published.standard.deviation[row],
                  unit * condition.published.asymmetric.deviation[row]);
    });
  }
  print_row("root mean square", [&](Parameter parameter) {
    const double unit = thesis_unit(parameter);
    const auto stc = over_all(study, parameter, TricycleModel::kStandard);
    const auto atc = over_all(study, parameter, TricycleModel::kAsymmetric);
    const StudiedParameter& ours = standard ? stc : atc;
    return text("%.2f%s %5.2f %5.2f", unit * ours.deviation,
                ours.deviation < ours.published_deviation ? " " : "!",
                unit * stc.published_deviation, unit * atc.published_deviation);
  });
  print_row("rows with less", [&](Parameter parameter) {
    return text("%d of %zu", over_all(study, parameter, study.model).narrower,
                study.conditions.size());
  });
  std::printf("A deviation of the thesis is of 3 or 4 calibrations, good to about half of it.\n");
}

nlohmann::json json_of(const ParameterStatistics& statistics) {
  nlohmann::json json = {{"closed_form_deviation", statistics.closed_form_deviation},
                         {"deviation", statistics.deviation},
                         {"bias", statistics.bias},
                         {"coverage", statistics.coverage},
                         {"half_width", statistics.half_width}};
  if (statistics.bound > 0.0) json["bound"] = statistics.bound;
  return json;
}

nlohmann::json json_of(const PublishedCalibration& published, Parameter parameter) {
  const auto row = static_cast<Eigen::Index>(index_of(parameter));
  return {{"mean", published.mean[row]}, {"deviation", published.deviation[row]}};
}

nlohmann::json json_of(const StudiedCondition& studied) {
  const MonteCarloReport& report = studied.report;
  nlohmann::json json = {{"number", studied.number},
                         {"arcs_per_phase", report.condition.arcs_per_phase},
                         {"min_steering", report.condition.min_steering},
                         {"max_steering", report.condition.max_steering},
                         {"turn", report.condition.turn},
                         {"wheel_speed", report.condition.wheel_speed},
                         {"runs", report.runs},
                         {"refused", report.refused},
                         {"outlier_share", report.outlier_share},
                         {"mean_chi2", report.mean_chi2}};
  for (const Column& column : kColumns) {
    nlohmann::json& here = json["parameters"][name_of(column.parameter)];
    here = json_of(report.parameters[index_of(column.parameter)]);
    here["table_5_1"] = json_of(studied.published.standard, column.parameter);
    here["table_5_2"] = json_of(studied.published.asymmetric, column.parameter);
  }
  return json;
}

}  // namespace

void print_report(const CalibrationStudy& study) {
  if (study.conditions.empty()) return;
  print_deviations(study);
  print_honesty(study);
  print_published(study);
}

nlohmann::json as_json(const CalibrationStudy& study) {
  nlohmann::json json = {
      {"model", study.model == TricycleModel::kStandard ? "standard" : "asymmetric"},
      {"conditions", nlohmann::json::array()}};
  for (const StudiedCondition& condition : study.conditions) {
    json["conditions"].push_back(json_of(condition));
  }
  for (const Column& column : kColumns) {
    const StudiedParameter all = over_all(study, column.parameter, study.model);
    const auto row = static_cast<Eigen::Index>(index_of(column.parameter));
    json["truth"][name_of(column.parameter)] = vector_of(study.truth)[row];
    json["all"][name_of(column.parameter)] = {{"deviation", all.deviation},
                                              {"published_deviation", all.published_deviation},
                                              {"over_bound", all.over_bound},
                                              {"greatest_over_bound", all.greatest_over_bound},
                                              {"greatest_bias", all.greatest_bias},
                                              {"coverage", all.coverage},
                                              {"narrower", all.narrower}};
  }
  return json;
}

}  // namespace cli
}  // namespace falko_slam
