// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/wall_registration.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "wall_pairs.hpp"

namespace falko_slam {
namespace {

// The pairs of one part of a wall, whose distances have an error in common.
struct Part {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d feigned = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  // of half of chi2
  Eigen::Vector3d common = Eigen::Vector3d::Zero();    // sum of w J
  double weight = 0.0, distance = 0.0;                 // sums of w and w r
  double squares = 0.0;

  void add(const WallPair& pair) {
    const double w = 1.0 / pair.variance;
    information += w * pair.gradient * pair.gradient.transpose();
    feigned += w * pair.angle_variance * pair.feigned_gradient * pair.feigned_gradient.transpose();
    gradient += w * pair.distance * pair.gradient;
    common += w * pair.gradient;
    weight += w;
    distance += w * pair.distance;
    squares += w * pair.distance * pair.distance;
  }
  // Share of the whole part's weight that the common error takes away (Woodbury's formula).
  double loss(double lasting_variance) const {
    return lasting_variance / (1.0 + lasting_variance * weight);
  }
  double mean() const { return distance / weight; }
  double chi2_of_mean(double lasting_variance) const {
    return mean() * mean() / (1.0 / weight + lasting_variance);
  }
};

struct Equations {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d feigned = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
};

using Parts = std::map<std::size_t, Part>;

Equations equations_of(const Parts& parts, double lasting_variance) {
  Equations sum;
  for (const auto& [number, part] : parts) {
    const double loss = part.loss(lasting_variance);
    sum.information += part.information - loss * part.common * part.common.transpose();
    sum.gradient += part.gradient - loss * part.distance * part.common;
    // A turn of the normal moves all of the part: it can feign no more than the part's weight.
    sum.feigned += part.feigned / (1.0 + lasting_variance * part.weight);
  }
  return sum;
}

// In the eigenvectors of what is feigned relative to the information each direction keeps its true
// share; none where half may be feigned.
Eigen::Matrix3d honest(const Equations& sum) {
  constexpr double kFeignedShare = 0.5;
  const Eigen::LLT<Eigen::Matrix3d> cholesky(sum.information);
  if (cholesky.info() != Eigen::Success) return sum.information;
  const Eigen::Matrix3d lower = cholesky.matrixL();
  const Eigen::Matrix3d inverse = cholesky.matrixL().solve(Eigen::Matrix3d::Identity().eval());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> shares(inverse * sum.feigned *
                                                              inverse.transpose());
  const Eigen::Vector3d kept = shares.eigenvalues().unaryExpr(
      [](double share) { return share < kFeignedShare ? 1.0 - share : 0.0; });
  const Eigen::Matrix3d& vectors = shares.eigenvectors();
  return lower * vectors * kept.asDiagonal() * vectors.transpose() * lower.transpose();
}

class Fit {
 public:
  Fit(const WallScan& target, const WallScan& source, const Pose2& initial,
      const Eigen::Matrix3d& prior, const WallRegistrationParams& params)
      : target_(target),
        source_(source),
        initial_(initial),
        prior_(prior),
        params_(params),
        lasting_variance_(2.0 * params.lasting_noise * params.lasting_noise),
        pose_(initial) {}

  std::optional<WallRegistration> run() {
    constexpr int kIterations = 30;
    constexpr double kSmallStep = 1e-7;  // [m], [rad]
    double gate = params_.first_gate;
    for (int i = 0; i < kIterations; ++i) {
      pair_up(gate);
      const auto length = step();
      if (!length) return std::nullopt;
      if (gate <= params_.last_gate && *length < kSmallStep && !drop_worst()) break;
      gate = std::max(params_.last_gate, 0.5 * gate);
    }
    pair_up(params_.last_gate);
    return result();
  }

 private:
  void pair_up(double gate) {
    const WallPairs found = pair_walls(target_, source_, pose_, {gate, params_.max_angle});
    parts_.clear();
    agreeing_ = 0.0;
    contradicting_ = found.contradicting_length;
    for (const WallPair& pair : found.pairs) {
      if (dropped_.count(pair.part) > 0) {
        contradicting_ += pair.length;
        continue;
      }
      agreeing_ += pair.length;
      parts_[pair.part].add(pair);
    }
  }

  std::optional<double> step() {
    const Equations sum = equations_of(parts_, lasting_variance_);
    const Eigen::LDLT<Eigen::Matrix3d> solver(sum.information + prior_);
    const Eigen::Vector3d pivots = solver.vectorD();
    constexpr double kOpen = 1e-12;
    if (!(pivots.minCoeff() > kOpen * pivots.maxCoeff())) return std::nullopt;
    const Eigen::Vector3d way = solver.solve(-sum.gradient - prior_ * difference(pose_, initial_));
    pose_ = Pose2(pose_.translation() + way.head<2>(), pose_.theta() + way.z());
    return way.cwiseAbs().maxCoeff();
  }

  bool drop_worst() {
    constexpr double kSignificant = 15.1;  // chi2 of one degree of freedom, 99.99 %
    constexpr double kMedian = 0.455;      // of the same
    constexpr std::size_t kLeastParts = 4;
    if (parts_.size() <= kLeastParts) return false;
    const auto worst =
        std::max_element(parts_.begin(), parts_.end(), [&](const auto& a, const auto& b) {
          return a.second.chi2_of_mean(lasting_variance_) <
                 b.second.chi2_of_mean(lasting_variance_);
        });
    const double usual = std::max(1.0, median_chi2() / kMedian);
    if (worst->second.chi2_of_mean(lasting_variance_) < kSignificant * usual) return false;
    dropped_.insert(worst->first);
    return true;
  }

  double median_chi2() const {
    std::vector<double> chi2;
    for (const auto& [number, part] : parts_) chi2.push_back(part.chi2_of_mean(lasting_variance_));
    const auto middle = chi2.begin() + static_cast<std::ptrdiff_t>(chi2.size() / 2);
    std::nth_element(chi2.begin(), middle, chi2.end());
    return *middle;
  }

  double chi2_per_freedom() const {
    double chi2 = 0.0;
    for (const auto& [number, part] : parts_) chi2 += part.chi2_of_mean(lasting_variance_);
    return chi2 / std::max(1.0, static_cast<double>(parts_.size()) - 3.0);
  }

  std::optional<WallRegistration> result() const {
    WallRegistration found;
    found.target_T_source = pose_;
    const Eigen::Matrix3d information = honest(equations_of(parts_, lasting_variance_));
    const Eigen::Matrix3d without = honest(equations_of(parts_, 0.0));
    const double freedom = std::max(1.0, static_cast<double>(parts_.size()) - 3.0);
    found.chi2_per_freedom = chi2_per_freedom();
    const bool beyond_chance = found.chi2_per_freedom > 1.0 + 3.0 * std::sqrt(2.0 / freedom);
    const double worse = beyond_chance ? found.chi2_per_freedom : 1.0;
    found.information = information / worse;
    const Eigen::FullPivLU<Eigen::Matrix3d> both(found.information + prior_);
    if (!both.isInvertible()) return std::nullopt;
    found.covariance = both.inverse();
    found.lasting_covariance = found.covariance - (without / worse + prior_).inverse();
    for (const auto& [number, part] : parts_) {
      Parts others = parts_;
      others.erase(number);
      const Eigen::Matrix3d rest = honest(equations_of(others, lasting_variance_)) / worse + prior_;
      found.deviation_without_a_part =
          std::max(found.deviation_without_a_part, greatest_deviation(rest.inverse()));
    }
    found.agreeing_length = agreeing_;
    // What the target has seen through is told by the pieces of the source, and the other way
    // round.
    found.contradicting_length = contradicting_ + pair_walls(source_, target_, pose_.inverse(),
                                                             {params_.last_gate, params_.max_angle})
                                                      .contradicting_length;
    found.parts = parts_.size();
    double squares = 0.0, weight = 0.0;
    for (const auto& [number, part] : parts_) squares += part.squares, weight += part.weight;
    found.rms_residual = weight > 0.0 ? std::sqrt(squares / weight) : 0.0;
    return found;
  }

  const WallScan& target_;
  const WallScan& source_;
  const Pose2 initial_;
  const Eigen::Matrix3d prior_;
  const WallRegistrationParams& params_;
  const double lasting_variance_;
  Pose2 pose_;
  Parts parts_;
  std::set<std::size_t> dropped_;
  double agreeing_ = 0.0, contradicting_ = 0.0;
};

}  // namespace

double greatest_deviation(const Eigen::Matrix3d& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(
      Eigen::Matrix2d(covariance.topLeftCorner<2, 2>()));
  return std::sqrt(std::max(0.0, axes.eigenvalues().maxCoeff()));
}

void validate(const WallRegistrationParams& params) {
  require_in_range("first_gate", params.first_gate, 1e-3, 10.0);
  require_in_range("last_gate", params.last_gate, 1e-3, 10.0);
  require_in_range("max_angle", params.max_angle, 1e-3, 1.0);
  require_in_range("lasting_noise", params.lasting_noise, 0.0, 1.0);
}

std::optional<WallRegistration> register_walls(const WallScan& target, const WallScan& source,
                                               const Pose2& initial, const Eigen::Matrix3d& prior,
                                               const WallRegistrationParams& params) {
  return Fit(target, source, initial, prior, params).run();
}

}  // namespace falko_slam
