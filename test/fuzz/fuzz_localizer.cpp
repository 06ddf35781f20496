// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The core of the localizer's callbacks: a drive whose inputs come late, out of order, with wrong
// stamps and with broken fields.
#include "falko_slam/localization/localizer.hpp"

#include "fuzz/fuzz_targets.hpp"
#include "fuzz/input_file.hpp"
#include "fuzz/input_scan.hpp"
#include "localization/localizer_drive.hpp"

namespace falko_slam {
namespace fuzz {
namespace {

constexpr int kMostScans = 10;  // they are what costs time

class Player {
 public:
  explicit Player(const std::string& input)
      : numbers_(input), localizer_(drive().localizer_at_start()) {}

  void play() {
    while (!numbers_.ended() && scans_ < kMostScans) {
      step();
      look();
    }
  }

 private:
  static const test::LocalizerDrive& drive() { return test::LocalizerDrive::shared(); }

  void step() {
    switch (numbers_.below(10)) {
      case 0:
        return skip(numbers_.any<std::uint8_t>());
      case 1:
        shift_ += from_seconds(numbers_.within(numbers_.coin() ? 1.0 : 1e5));
        return;
      case 2:
        return add_motion();
      case 3:
        return add_scan(any_scan(numbers_, 720).raw());
      case 4:
        return add_broken_scan();
      case 5:
        localizer_.check(now_ + from_seconds(numbers_.within(20.0)));
        return;
      case 6:
        return set_pose();
      case 7:
        return add_reflectors();
      default:
        return go_on(1 + numbers_.below(32));
    }
  }

  const DriveInputEvent& event() const { return drive().events()[at_ % drive().events().size()]; }

  void skip(std::size_t events) { at_ += events; }

  void go_on(std::size_t events) {
    for (; events > 0 && scans_ < kMostScans; --events, ++at_) {
      now_ = event().stamp + shift_;
      if (event().motion) localizer_.add_motion(now_, *event().motion);
      if (event().scan) add_scan(*event().scan);
    }
  }

  void add_scan(LaserScan scan) {
    ++scans_;
    scan.first_beam_time += shift_;
    localizer_.add_scan(scan);
  }

  void add_scan(const RawScan& raw) {
    LaserScan scan;
    RawScan now = raw;
    now.stamp = event().stamp;
    if (normalize(now, {}, scan).usable()) add_scan(scan);
  }

  // The next scan with some of its fields changed.
  void add_broken_scan() {
    while (!event().scan) ++at_;
    const LaserScan& scan = *event().scan;
    InputScan broken;
    broken.ranges.assign(scan.ranges.begin(), scan.ranges.end());
    broken.intensities = scan.intensities;
    broken.fields.angle_min = scan.angle_min;
    broken.fields.angle_increment = scan.angle_increment;
    broken.fields.time_increment = to_seconds(scan.time_increment);
    broken.fields.range_max = scan.range_max;
    for (std::size_t i = numbers_.below(4); i > 0; --i) change_any_field(broken.fields, numbers_);
    for (std::size_t i = numbers_.below(16); i > 0; --i) {
      broken.ranges[numbers_.below(broken.ranges.size())] = any_range(numbers_);
    }
    if (numbers_.below(4) == 0) broken.ranges.resize(numbers_.below(8));
    add_scan(broken.raw());
  }

  void add_motion() {
    PoseEstimate motion;
    motion.pose = Pose2(numbers_.any<double>(), numbers_.within(1e3), numbers_.within(10.0));
    motion.covariance = pose_covariance(numbers_.any<double>(), numbers_.within(1.0));
    localizer_.add_motion(any_stamp(numbers_), motion);
  }

  void set_pose() {
    const Pose2 pose(numbers_.within(50.0), numbers_.within(50.0), numbers_.within(kPi));
    try {
      switch (numbers_.below(3)) {
        case 0:
          return localizer_.globalize();
        case 1:
          return localizer_.set_pose(
              any_stamp(numbers_),
              PoseEstimate{pose, pose_covariance(numbers_.any<double>(), 0.1)});
        default:
          return localizer_.set_pose(now_, PoseEstimate{pose, pose_covariance(1.0, 0.1)});
      }
    } catch (const std::invalid_argument&) {  // what is no pose may be refused so
    }
  }

  void add_reflectors() {
    std::vector<LandmarkObservation> observations(numbers_.below(40));
    for (LandmarkObservation& observation : observations) {
      observation.value = {numbers_.any<double>(), numbers_.within(30.0)};
      observation.covariance = numbers_.any<double>() * Eigen::Matrix2d::Identity();
    }
    ++scans_;
    localizer_.add_reflectors(now_, observations);
  }

  void look() const {
    const LocalizerReport& report = localizer_.state();
    if (!report.map_T_base) return;
    require(report.map_T_base->pose.translation().allFinite() &&
                std::isfinite(report.map_T_base->pose.theta()) &&
                report.map_T_base->covariance.allFinite(),
            "the pose is finite");
    require((report.map_T_base->covariance.diagonal().array() >= 0.0).all(),
            "variances are not negative");
  }

  InputNumbers numbers_;
  Localizer localizer_;
  std::size_t at_ = 0;  // in the drive
  Time now_{};
  Duration shift_{};
  int scans_ = 0;
};

}  // namespace

void fuzz_localizer(const std::string& input) { Player(input).play(); }

}  // namespace fuzz
}  // namespace falko_slam
