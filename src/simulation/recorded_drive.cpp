// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "falko_slam/simulation/driver.hpp"

namespace falko_slam {
namespace {

// Both begin with the simulation: their own times only tell how long after the first one.
template <class Record>
class Recording {
 public:
  explicit Recording(std::vector<Record> records) : records_(std::move(records)) {}

 protected:
  std::vector<Record> records_;
  std::size_t next_ = 0;
  std::optional<Time> begin_;  // of the simulation
};

class RecordedCommands : public Driver, Recording<std::pair<Time, WheelCommand>> {
 public:
  RecordedCommands(std::vector<std::pair<Time, WheelCommand>> commands, Duration timeout)
      : Recording(std::move(commands)), timeout_(timeout) {}

  std::optional<DriveInput> next(const SimulatedVehicle& vehicle, Duration) override {
    if (records_.empty()) return std::nullopt;
    if (!begin_) begin_ = vehicle.time();
    const Duration now = vehicle.time() - *begin_;
    while (next_ < records_.size() && records_[next_].first - records_[0].first <= now) ++next_;
    const auto& [stamp, command] = records_[next_ - 1];
    const bool old = now - (stamp - records_[0].first) > timeout_;
    if (!old) return DriveInput(command);
    const bool over = next_ == records_.size() && vehicle.wheel_speed() == 0.0;
    if (over) return std::nullopt;
    return DriveInput(WheelCommand{0.0, vehicle.steering()});
  }

 private:
  Duration timeout_;
};

class RecordedEncoders : public Driver, Recording<EncoderReading> {
 public:
  RecordedEncoders(std::vector<EncoderReading> readings, const EncoderParams& params)
      : Recording(std::move(readings)), params_(params) {
    if (!records_.empty()) steering_ = steering_of(params_, records_.front().steer_ticks);
  }

  std::optional<DriveInput> next(const SimulatedVehicle& vehicle, Duration period) override {
    if (records_.size() < 2) return std::nullopt;
    if (!begin_) {  // the wheel turns to where it stood
      begin_ = vehicle.time() + period;
      last_ = at(Duration::zero());
      return DriveInput(EncoderMotion{0.0, last_.steering});
    }
    const Duration now = vehicle.time() - *begin_;
    if (now >= records_.back().stamp - records_.front().stamp) return std::nullopt;
    const State end = at(now + period);
    const EncoderMotion motion{end.ticks - last_.ticks, end.steering};
    last_ = end;
    return DriveInput(motion);
  }

 private:
  struct State {
    double ticks = 0.0;  // since the first reading
    double steering = 0.0;
  };

  // Between two readings evenly; `elapsed` never falls from call to call.
  State at(Duration elapsed) {
    const auto since = [&](std::size_t i) { return records_[i].stamp - records_[0].stamp; };
    while (next_ + 2 < records_.size() && since(next_ + 1) <= elapsed) {
      const EncoderReading& from = records_[next_];
      const EncoderReading& to = records_[++next_];
      ticks_ += ticks_between(from.drive_ticks, to.drive_ticks);
      steering_ += steering_between(params_, from.steer_ticks, to.steer_ticks);
    }
    const EncoderReading& from = records_[next_];
    const EncoderReading& to = records_[next_ + 1];
    const double share =
        std::min(1.0, to_seconds(elapsed - since(next_)) / to_seconds(to.stamp - from.stamp));
    const double turn = steering_between(params_, from.steer_ticks, to.steer_ticks);
    return {ticks_ + share * ticks_between(from.drive_ticks, to.drive_ticks),
            steering_ + share * turn};
  }

  EncoderParams params_;
  State last_;
  double ticks_ = 0.0;     // from the first reading to that before
  double steering_ = 0.0;  // at that before, not wrapped [rad]
};

}  // namespace

std::unique_ptr<Driver> recorded_commands(std::vector<std::pair<Time, WheelCommand>> commands,
                                          Duration timeout) {
  for (std::size_t i = 1; i < commands.size(); ++i) {
    if (commands[i].first < commands[i - 1].first) {
      throw std::invalid_argument("recorded commands: stamps run back at number " +
                                  std::to_string(i));
    }
  }
  return std::make_unique<RecordedCommands>(std::move(commands), timeout);
}

std::unique_ptr<Driver> recorded_encoders(std::vector<EncoderReading> readings,
                                          const EncoderParams& params) {
  validate(params);
  for (std::size_t i = 1; i < readings.size(); ++i) {
    if (readings[i].stamp <= readings[i - 1].stamp) {
      throw std::invalid_argument("recorded encoders: stamps do not rise at number " +
                                  std::to_string(i));
    }
  }
  return std::make_unique<RecordedEncoders>(std::move(readings), params);
}

}  // namespace falko_slam
