// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <thread>

namespace falko_slam {

/// Keeps steps of simulated time in step with the machine's steady clock, and says how far behind
/// they are. What was late is caught up with, unless it is more than `most`: then time goes on from
/// there.
class RealTime {
 public:
  using Clock = std::chrono::steady_clock;

  /// `rate` seconds of simulated time pass in one second.
  RealTime(double rate, Clock::duration most) : rate_(rate), most_(most) {}

  /// Waits until as much real time has passed as the simulated time until now asks for.
  void wait_for(std::chrono::nanoseconds simulated) {
    due_ += std::chrono::duration_cast<Clock::duration>(simulated / rate_);
    const Clock::time_point now = Clock::now();
    late_ = now > due_ ? now - due_ : Clock::duration::zero();
    if (late_ > most_) {
      due_ = now;
      ++given_up_;
    }
    std::this_thread::sleep_until(due_);
  }

  double seconds_late() const { return std::chrono::duration<double>(late_).count(); }
  std::uint64_t given_up() const { return given_up_; }

 private:
  double rate_;
  Clock::duration most_;
  Clock::time_point due_ = Clock::now();
  Clock::duration late_{};
  std::uint64_t given_up_ = 0;
};

}  // namespace falko_slam
