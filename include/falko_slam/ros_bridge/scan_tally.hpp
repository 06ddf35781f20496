// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <cstddef>
#include <string>
#include <utility>

#include "falko_slam/ros_bridge/topic_watch.hpp"
#include "falko_slam/sensor/scan_report.hpp"

namespace falko_slam {

/// Keeps count of the scans that a nodelet hears: what /diagnostics of all of them have in common.
/// Times are those of the steady clock [s].
class ScanTally {
 public:
  explicit ScanTally(TopicWatch watch) : watch_(std::move(watch)) {}

  void received(const ScanReport& report, double now);
  /// A scan that tf could not place, and what it lacks.
  void dropped(const std::string& missing);

  /// The worst that is wrong with the scans takes the place of what the status says: WARN if no
  /// message comes on the topic, which is told even before an ERROR, that the last scan was
  /// unusable; then WARN if since the last report scans had to be dropped for want of a transform,
  /// if no beam of the last one was valid, or if count of its beams and angles disagree.
  void summarize(diagnostic_updater::DiagnosticStatusWrapper& status, double now);
  void add_counts(diagnostic_updater::DiagnosticStatusWrapper& status) const;
  void add_last(diagnostic_updater::DiagnosticStatusWrapper& status) const;
  /// What is counted from report to report begins anew.
  void begin_window() { dropped_in_window_ = 0; }

  std::size_t scans() const { return scans_; }
  std::size_t dropped_scans() const { return dropped_; }
  const TopicWatch& watch() const { return watch_; }

 private:
  std::string trouble_of_last() const;

  TopicWatch watch_;
  ScanReport last_;
  std::size_t scans_ = 0, unusable_ = 0, dropped_ = 0, dropped_in_window_ = 0;
  std::string missing_;
};

}  // namespace falko_slam
