// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ordinary_intensity.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace falko_slam {
namespace {

constexpr float kEnough = 20.0F;    // beams for a level of their own
constexpr float kFoil = 4.0F;       // times the median
constexpr float kSteepest = -2.0F;  // power of the range: light spreads so, receivers compress it
constexpr int kExponentBias = 127;  // of single precision
constexpr int kMantissaBits = 23;

// Cells by the bits of a number, 2^bits_per_octave in each octave from 2^lowest on: linear within
// an octave, which is near enough to a logarithm and costs nothing.
std::uint16_t cell_in_octaves(float value, int lowest, int bits_per_octave, std::size_t cells) {
  std::uint32_t pattern = 0;
  std::memcpy(&pattern, &value, sizeof pattern);
  const int shift = kMantissaBits - bits_per_octave;
  const int cell =
      static_cast<int>(pattern >> shift) - ((lowest + kExponentBias) << bits_per_octave);
  return static_cast<std::uint16_t>(std::clamp(cell, 0, static_cast<int>(cells) - 1));
}

constexpr int kLowestRange = -4, kRangeBits = 2;
constexpr int kLowestIntensity = -10, kIntensityBits = 3;

// The upper end of a cell of intensities.
float intensity_above(std::size_t cell) {
  const auto first =
      static_cast<std::uint32_t>((kLowestIntensity + kExponentBias) << kIntensityBits);
  const std::uint32_t pattern = (first + static_cast<std::uint32_t>(cell) + 1U)
                                << (kMantissaBits - kIntensityBits);
  float value = 0.0F;
  std::memcpy(&value, &pattern, sizeof value);
  return value;
}

}  // namespace

OrdinaryIntensity::Cell OrdinaryIntensity::cell_of(double range, float intensity) {
  const float seen = intensity > 0.0F ? intensity : 0.0F;  // NaN is not
  return {cell_in_octaves(static_cast<float>(range), kLowestRange, kRangeBits, kRangeCells),
          cell_in_octaves(seen, kLowestIntensity, kIntensityBits, kIntensityCells)};
}

OrdinaryIntensity::OrdinaryIntensity() : weight_(kRangeCells * kIntensityCells, 0.0F) {}

void OrdinaryIntensity::add(Cell cell, float weight) {
  weight_[cell.range * kIntensityCells + cell.intensity] += weight;
  sum_[cell.range] += weight;
  darkest_ = std::min<std::size_t>(darkest_, cell.intensity);
  brightest_ = std::max<std::size_t>(brightest_, cell.intensity);
}

void OrdinaryIntensity::fade(float share) {
  for (float& weight : weight_) weight *= share;
  for (float& sum : sum_) sum *= share;
}

float OrdinaryIntensity::quantile_of(const Pool& pool, float share, std::size_t end) const {
  float sum = 0.0F;
  for (std::size_t cell = darkest_; cell < end; ++cell) sum += pool[cell];
  float above = 0.0F;
  for (std::size_t cell = end; cell-- > darkest_;) {
    above += pool[cell];
    if (above > (1.0F - share) * sum) return intensity_above(cell);
  }
  return intensity_above(darkest_);
}

// Of a cell and its two neighbours. Much brighter surfaces than the middle one are reflecting foil,
// however wide, and not ordinary.
float OrdinaryIntensity::level_of(std::size_t range, float share) const {
  const std::size_t first = range > 0 ? range - 1 : 0;
  const std::size_t last = std::min(range + 1, kRangeCells - 1);
  float sum = 0.0F;
  for (std::size_t i = first; i <= last; ++i) sum += sum_[i];
  if (sum < kEnough) return 0.0F;
  Pool pool{};
  for (std::size_t i = first; i <= last; ++i) {
    const float* weight = &weight_[i * kIntensityCells];
    for (std::size_t cell = darkest_; cell <= brightest_; ++cell) pool[cell] += weight[cell];
  }
  const float middle = quantile_of(pool, 0.5F, brightest_ + 1);
  if (share <= 0.5F) return middle;
  const std::size_t foil = cell_of(1.0, kFoil * middle).intensity;
  return quantile_of(pool, share, std::min(foil, brightest_ + 1));
}

// Where there is nothing but foil at some range: it outshines the surfaces up to an octave nearer
// and farther by more than the square of the ranges explains, and as much again.
void OrdinaryIntensity::lower_foil() {
  constexpr std::size_t kOctave = 1U << kRangeBits;
  const std::array<float, kRangeCells> seen = level_;
  for (std::size_t i = 0; i < kRangeCells; ++i) {
    for (std::size_t j = i > kOctave ? i - kOctave : 0; j <= std::min(i + kOctave, kRangeCells - 1);
         ++j) {
      if (seen[i] <= 0.0F || seen[j] <= 0.0F) continue;
      const float octaves = j > i ? static_cast<float>(j - i) / kOctave : 0.0F;
      level_[i] = std::min(level_[i], 2.0F * seen[j] * std::exp2(-kSteepest * octaves));
    }
  }
}

// Least squares of log level = a + slope log range where a level is known; both in cells.
void OrdinaryIntensity::fill_gaps() {
  float n = 0.0F, sx = 0.0F, sy = 0.0F, sxx = 0.0F, sxy = 0.0F;
  std::array<float, kRangeCells> log{};
  for (std::size_t i = 0; i < kRangeCells; ++i) {
    if (level_[i] <= 0.0F) continue;
    const float x = static_cast<float>(i) / (1U << kRangeBits);
    log[i] = std::log2(level_[i]);
    n += 1.0F, sx += x, sy += log[i], sxx += x * x, sxy += x * log[i];
  }
  if (n == 0.0F) return;
  const float spread = n * sxx - sx * sx;
  const float slope =
      spread > 0.0F ? std::clamp((n * sxy - sx * sy) / spread, kSteepest, 0.0F) : 0.0F;
  const std::array<float, kRangeCells> known = level_;
  for (std::size_t i = 0; i < kRangeCells; ++i) {
    if (known[i] > 0.0F) continue;
    std::size_t away = 1;
    while (!(i >= away && known[i - away] > 0.0F) &&
           !(i + away < kRangeCells && known[i + away] > 0.0F)) {
      ++away;
    }
    const bool below = i >= away && known[i - away] > 0.0F;
    const std::size_t from = below ? i - away : i + away;
    const float octaves = (static_cast<float>(i) - static_cast<float>(from)) / (1U << kRangeBits);
    level_[i] = known[from] * std::exp2(slope * octaves);
  }
}

void OrdinaryIntensity::settle(float share) {
  for (std::size_t i = 0; i < kRangeCells; ++i) level_[i] = level_of(i, share);
  lower_foil();
  fill_gaps();
}

}  // namespace falko_slam
