// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The core of the calibration's callbacks: a session whose inputs are broken in between.
#include "calibration/session_drive.hpp"
#include "fuzz/fuzz_targets.hpp"
#include "fuzz/input_file.hpp"
#include "fuzz/input_scan.hpp"

namespace falko_slam {
namespace fuzz {
namespace {

ReflectorObservation any_observation(InputNumbers& numbers, Time now) {
  ReflectorObservation seen;
  seen.first_beam = numbers.coin() ? any_stamp(numbers) : now;
  seen.reflectors.resize(numbers.below(12));
  for (SightedReflector& reflector : seen.reflectors) {
    reflector.point = {numbers.any<double>(), numbers.within(30.0)};
    reflector.after_first_beam = from_seconds(numbers.within(1.0));
  }
  return seen;
}

void disturb(CalibrationSession& session, InputNumbers& numbers, Time now) {
  switch (numbers.below(4)) {
    case 0:
      return session.add(any_observation(numbers, now));
    case 1:
      return session.add(
          {any_stamp(numbers), numbers.any<std::uint32_t>(), numbers.any<std::uint32_t>()});
    case 2:
      session.next(any_stamp(numbers));
      return;
    default: {
      ScanObservation observation;
      if (normalize(any_scan(numbers, 100).raw(), {}, observation.scan).usable())
        session.add(observation);
    }
  }
}

}  // namespace

void fuzz_calibration_session(const std::string& input) {
  InputNumbers numbers(input);
  CalibrationSessionParams params = test::short_session(test::SessionDrive::kModel);
  if (numbers.coin()) params.recorder.egomotion = EgomotionSource::kScans;
  CalibrationSession session(params);
  test::SessionDrive drive(session);
  while (!numbers.ended()) {
    for (std::size_t steps = numbers.below(400); steps > 0; --steps) drive.step();
    disturb(session, numbers, drive.vehicle().time());
  }
  session.catch_up();
  try {
    session.evaluate();
  } catch (const std::invalid_argument&) {  // too few arcs
  }
}

}  // namespace fuzz
}  // namespace falko_slam
