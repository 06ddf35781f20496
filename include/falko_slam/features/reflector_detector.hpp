// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

/// Defaults: a SICK NAV350 (\cite sick2017nav350) and its usual reflectors.
struct ReflectorDetectorParams {
  enum class Shape {
    kCylinder,  ///< its axis is what is found
    kFlat,      ///< a strip on a wall: the middle of what is seen of its face is found
  };
  Shape shape = Shape::kCylinder;
  /// Of the cylinder, or the width of the strip. [0.01, 1] [m]
  double diameter = 0.08;
  /// What of the diameter must be seen at least; less is taken for a bright speck. [0.1, 1]
  double min_visible = 0.5;
  /// Fewer beams are no reflector. [1, 100]
  int min_hits = 2;
  /// Farther reflectors are not looked for. [0, 1000] [m]
  double max_range = 70.0;

  /// Of the beam where it leaves the scanner. It smears a reflector: greater values admit wider
  /// ones. [0, 0.5] [m]
  double beam_diameter = 0.020;
  /// Growth of the beam's diameter per metre. [0, 0.1]
  double beam_divergence = 0.005;
  /// Standard deviation of the range of one beam. [1e-4, 1] [m]
  double range_noise = 0.008;
  /// Standard deviation of what is common to all beams on one reflector: how deep its face is seen
  /// and what brightness does to a range. [0, 0.1] [m]
  double range_bias = 0.002;
  /// Standard deviation of the direction of one beam. [0, 0.1] [rad]
  double bearing_noise = 3.5e-4;

  /// A reflector's brightest beam exceeds this at a range of 1 m; 0: so many times (`contrast`)
  /// what ordinary surfaces at its range reach. [0, 1e9] [units of the intensities]
  double threshold = 0.0;
  /// The threshold falls with the range to this power. [0, 4]
  double threshold_falloff = 0.0;
  /// Greater values ask for brighter reflectors. [1.05, 1000]
  double contrast = 2.0;
  /// Scans after which what was learnt of ordinary surfaces has faded to a third; 0: every scan is
  /// judged by itself, and nothing depends on the scans before. [0, 1e6] [scans]
  int memory = 100;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const ReflectorDetectorParams& params);

/// A reflector seen in one scan.
struct DetectedReflector {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();          ///< in the laser frame [m]
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();  ///< of the centre [m^2]
  std::size_t first_beam = 0;
  std::size_t last_beam = 0;    ///< less than the first one across the seam of a closed scan
  std::size_t hits = 0;         ///< beams
  double middle_beam = 0.0;     ///< where its middle is seen, in [0, beams): for de-skewing
  Time time{};                  ///< when that was
  double mean_intensity = 0.0;  ///< of its beams
  double peak_intensity = 0.0;
  bool partly_hidden = false;  ///< something nearer, or the end of the scan, cuts it off
};

/// Why no reflectors can be found in a scan, however many there are.
enum class IntensityFault { kNone, kMissing, kAllZero, kAllTheSame };

/// For messages, such as "the scan has no intensities: ..." with what to do about it; empty for
/// kNone.
std::string describe(IntensityFault fault);

/// Why something bright is no reflector.
enum class ReflectorRefusal { kTooWide, kTooNarrow, kTooFewBeams };
constexpr std::size_t kReflectorRefusalCount = 3;

/// What became of a scan: nothing bright is dropped without being counted here.
struct ReflectorReport {
  IntensityFault fault = IntensityFault::kNone;
  /// No ordinary surface has been seen yet: whatever is as wide as a reflector is taken for one.
  bool nothing_to_compare = false;
  std::array<std::size_t, kReflectorRefusalCount> refused{};  ///< by ReflectorRefusal

  std::size_t count(ReflectorRefusal refusal) const {
    return refused[static_cast<std::size_t>(refusal)];
  }
};

/// Reflectors of a scan from its intensities: bright beams side by side, as wide as a reflector.
///
/// Threshold: ordinary surfaces are those wider than a reflector. How bright they get at each range
/// is kept as a histogram (`memory`); beams that exceed its 98 % quantile by `contrast` are bright.
///
/// Centre, with u the place of a beam across the line of sight and w its intensity above that of
/// ordinary surfaces: across, the mean of u weighted by w; along, the mean over the beams of the
/// range and of how deep the face lies before the axis within that beam's footprint, weighted by
/// the light that a retroreflecting cylinder returns from there. Where one side is hidden, the
/// other edge and the diameter give the centre. Covariance: along and across the line of sight.
///
/// Nothing is corrected for motion. Turning a closed scan by k beams turns what is found, exactly,
/// as long as nothing is remembered. O(beams). Not thread-safe; keeps its memory between scans.
class ReflectorDetector {
 public:
  explicit ReflectorDetector(const ReflectorDetectorParams& params = {});
  ~ReflectorDetector();
  ReflectorDetector(ReflectorDetector&&) noexcept;
  ReflectorDetector& operator=(ReflectorDetector&&) noexcept;

  /// Replaces `reflectors` by those of the scan, in the order of their first beams.
  ReflectorReport detect(const LaserScan& scan, std::vector<DetectedReflector>& reflectors);
  /// The same. Throws std::runtime_error, describe(fault), where there are no intensities.
  std::vector<DetectedReflector> detect(const LaserScan& scan);

  /// What the brightest beam of a reflector at this range must exceed by now [units of the
  /// intensities]; 0 where nothing is known.
  double threshold(double range) const;

  const ReflectorDetectorParams& params() const { return params_; }

 private:
  struct Workspace;
  ReflectorDetectorParams params_;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace falko_slam
