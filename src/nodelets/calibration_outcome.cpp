// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What comes of the arcs that the Calibration nodelet has driven, or that somebody else has.
#include <boost/date_time/posix_time/posix_time.hpp>
#include <filesystem>
#include <numeric>

#include "calibration_nodelet.hpp"
#include "falko_slam/common/file_below.hpp"
#include "falko_slam/ros_bridge/topics.hpp"

namespace falko_slam {
namespace {

std::string date_of_today() {
  return boost::posix_time::to_iso_extended_string(
             boost::posix_time::second_clock::universal_time()) +
         "Z";
}

RecordedCalibration calibrate_given(const std::vector<CalibrationArc>& arcs,
                                    const CalibratorParams& params) {
  std::vector<PathSegment> segments;
  segments.reserve(arcs.size());
  for (const CalibrationArc& arc : arcs) segments.push_back(from_message(arc));
  RecordedCalibration calibration;
  calibration.result = calibrate(segments, params);
  calibration.recorded.resize(segments.size());
  std::iota(calibration.recorded.begin(), calibration.recorded.end(), std::size_t{0});
  return calibration;
}

std::string summary_of(const CalibrationOutcome& outcome) {
  std::string text = outcome.verdict;
  for (const std::string& remark : outcome.remarks) text += "; " + remark;
  return text;
}

}  // namespace

std::vector<CalibrationArc> CalibrationNodelet::driven_arcs() const {
  std::vector<CalibrationArc> arcs;
  for (const SessionArc& arc : driven_) arcs.push_back(to_message(arc));
  return arcs;
}

std::string CalibrationNodelet::keep(const CalibrationResult& result, TricycleModel model,
                                     const KeepWish& wish, CalibrationOutcome& outcome) const {
  std::string summary = summary_of(outcome);
  if (wish.file.empty()) return summary;
  if (result.verdict == CalibrationVerdict::kWeak && !wish.accept_weak) {
    return summary + "; not written, accept_weak would do so";
  }
  const std::string path = file_below(params_.folder, wish.file);
  std::filesystem::create_directories(std::filesystem::path(path).parent_path());
  write_calibration(path, stored_calibration(result, model, date_of_today()));
  outcome.file = path;
  return summary + "; written to " + path;
}

bool CalibrationNodelet::conclude(const RecordedCalibration& calibration, CalibrateResult& result) {
  driven_ = session_->arcs();
  markers_->set_arcs(driven_);
  markers_->set_result(calibration);
  result.outcome = to_message(calibration.result);
  result.outcome.arcs = driven_arcs();
  add_reports(result.outcome.arcs, calibration.result, calibration.recorded);
  if (!calibration.result.estimate) {
    result.message = summary_of(result.outcome);
    return false;
  }
  result.message = keep(calibration.result, running_.calibrator.model, {file_, params_.accept_weak},
                        result.outcome);
  return true;
}

bool CalibrationNodelet::on_compute(ComputeCalibration::Request& request,
                                    ComputeCalibration::Response& response) {
  try {
    if (session_) throw std::runtime_error("a calibration is being driven");
    CalibratorParams params = params_.session.calibrator;
    if (!request.model.empty()) params.model = tricycle_model_of(request.model);
    params.free_wheelbase = params.free_wheelbase || request.free_wheelbase;
    params.free_steer_gain = params.free_steer_gain || request.free_steer_gain;
    if (request.arcs.empty() && driven_.empty()) throw std::runtime_error("there are no arcs");
    const double lasting_noise = params_.session.recorder.reflectors.lasting_noise;
    const RecordedCalibration calibration =
        request.arcs.empty() ? calibrate_recorded(segments_of(driven_), params, lasting_noise)
                             : calibrate_given(request.arcs, params);
    response.outcome = to_message(calibration.result);
    response.outcome.arcs = request.arcs.empty() ? driven_arcs() : request.arcs;
    add_reports(response.outcome.arcs, calibration.result, calibration.recorded);
    response.message = summary_of(response.outcome);
    if (!calibration.result.estimate) return true;
    response.message = keep(calibration.result, params.model,
                            {request.file, request.accept_weak != 0}, response.outcome);
    response.success = request.file.empty() || !response.outcome.file.empty();
  } catch (const std::exception& error) {
    response.message = error.what();
    NODELET_ERROR_STREAM("no calibration: " << error.what());
  }
  return true;
}

}  // namespace falko_slam
