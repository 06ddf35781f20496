// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/simulation/driver.hpp"
#include "support/simulated_worlds.hpp"
#include "support/times.hpp"

namespace falko_slam {
namespace {

using std::chrono::milliseconds;
using test::kBegin;

SimulatedVehicle led(Driver& driver, const VehicleModel& model) {
  SimulatedVehicle vehicle(model, {}, kBegin, 1);
  for (int i = 0; i < 100000; ++i) {
    const auto input = driver.next(vehicle, test::kControlPeriod);
    if (!input) break;
    std::visit([&](const auto& motion) { vehicle.drive(test::kControlPeriod, motion); }, *input);
  }
  return vehicle;
}

VehicleModel counting_from(std::uint32_t ticks) {
  VehicleModel model;
  model.first_drive_ticks = ticks;
  model.encoders.steer_ticks_per_turn = 8192;
  return model;
}

TEST(RecordedDrive, EncodersCountWhatTheRecordedOnesDid) {
  constexpr std::uint32_t kFirst = 4294959756U;
  std::vector<EncoderReading> readings;
  Time stamp{std::chrono::seconds(1668091584)};
  std::uint32_t ticks = kFirst;
  for (int i = 0; i < 200; ++i) {  // over both ends: of the counter, of the steering's turn
    const int steer = i < 100 ? i : 200 - i;
    readings.push_back({stamp, ticks, static_cast<std::uint32_t>((8192 + 50 - steer) % 8192)});
    stamp += milliseconds(i % 2 == 0 ? 38 : 51);
    ticks += i < 150 ? 137U : static_cast<std::uint32_t>(-61);
  }
  const VehicleModel model = counting_from(kFirst);
  const auto driver = recorded_encoders(readings, model.encoders);

  const SimulatedVehicle vehicle = led(*driver, model);

  EXPECT_EQ(vehicle.reading().drive_ticks, readings.back().drive_ticks);
  EXPECT_EQ(vehicle.reading().steer_ticks, readings.back().steer_ticks);
  const double driven = to_seconds(readings.back().stamp - readings.front().stamp);
  EXPECT_NEAR(to_seconds(vehicle.time() - kBegin), driven + 0.02, 0.021);
}

TEST(RecordedDrive, EncodersMustRiseInTime) {
  const EncoderReading reading{kBegin, 0, 0};
  EXPECT_THROW(recorded_encoders({reading, reading}, {}), std::invalid_argument);
}

TEST(RecordedDrive, CommandsHoldUntilTheNextOneOrTheTimeout) {
  VehicleModel model;
  const auto driver = recorded_commands(
      {{Time(milliseconds(5000)), {0.5, 0.0}}, {Time(milliseconds(5400)), {0.5, 0.2}}},
      milliseconds(500));
  SimulatedVehicle vehicle(model, {}, kBegin, 1);

  vehicle.drive(test::kControlPeriod,
                std::get<WheelCommand>(*driver->next(vehicle, test::kControlPeriod)));
  EXPECT_GT(vehicle.wheel_speed(), 0.0);
  const SimulatedVehicle halted = led(*driver, model);
  EXPECT_EQ(halted.wheel_speed(), 0.0);
  EXPECT_GT(halted.steering(), 0.15);
  EXPECT_GT(halted.world_T_base().x(), 0.15);
  EXPECT_LT(to_seconds(halted.time() - kBegin), 2.5);
}

TEST(RecordedDrive, CommandsMustNotRunBack) {
  EXPECT_THROW(
      recorded_commands({{kBegin, {}}, {kBegin - test::kControlPeriod, {}}}, test::kControlPeriod),
      std::invalid_argument);
}

TEST(RecordedDrive, NothingRecordedIsOverAtOnce) {
  EXPECT_EQ(led(*recorded_commands({}, test::kControlPeriod), {}).time(), kBegin);
  EXPECT_EQ(led(*recorded_encoders({}, {}), {}).time(), kBegin);
}

}  // namespace
}  // namespace falko_slam
