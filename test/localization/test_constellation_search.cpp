// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/constellation_search.hpp"

#include <gtest/gtest.h>

#include <random>

#include "falko_slam/localization/localizer.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

const Pose2 kBaseTLaser(0.4, 0.1, 0.2);
constexpr double kNoise = 0.01;

std::vector<Landmark> scattered(std::size_t count, double side, std::mt19937_64& random) {
  std::uniform_real_distribution<double> coordinate(0.0, side);
  std::vector<Landmark> landmarks;
  for (std::uint32_t i = 0; i < count; ++i) {
    landmarks.push_back({i, {coordinate(random), coordinate(random)}, Eigen::Matrix2d::Zero()});
  }
  return landmarks;
}

LandmarkObservation observed(const Eigen::Vector2d& in_laser) {
  return {
      ObservationModel::kCartesian, in_laser, kNoise * kNoise * Eigen::Matrix2d::Identity(), {}};
}

std::vector<LandmarkObservation> seen_from(const Pose2& map_T_base,
                                           const std::vector<Landmark>& landmarks, double range,
                                           std::mt19937_64& random) {
  std::normal_distribution<double> noise(0.0, kNoise);
  const Pose2 laser_T_map = (map_T_base * kBaseTLaser).inverse();
  std::vector<LandmarkObservation> observations;
  for (const Landmark& landmark : landmarks) {
    const Eigen::Vector2d point = laser_T_map * landmark.position;
    if (point.norm() > range) continue;
    observations.push_back(observed(point + Eigen::Vector2d(noise(random), noise(random))));
  }
  return observations;
}

TEST(ConstellationSearch, FindsThePlaceAmongAThousandLandmarks) {
  std::mt19937_64 random = test::seeded_random();
  const auto map = std::make_shared<LandmarkIndex>(scattered(1000, 200.0, random));
  ConstellationSearch search({}, kBaseTLaser, map);
  for (int i = 0; i < 20; ++i) {
    const Pose2 truth(30.0 + 7.0 * i, 170.0 - 6.0 * i, 0.7 * i);
    const auto seen = seen_from(truth, map->landmarks(), 12.0, random);

    const std::vector<PlaceCandidate> places = search.search(seen);

    ASSERT_FALSE(places.empty()) << i;
    EXPECT_TRUE(are_same_place(places.front().map_T_base, truth)) << i;
    EXPECT_EQ(places.front().explained, seen.size()) << i;
  }
}

TEST(ConstellationSearch, GivesBothPlacesOfATwofoldMap) {
  std::mt19937_64 random = test::seeded_random();
  std::vector<Landmark> landmarks = scattered(6, 10.0, random);
  const Pose2 other(40.0, 5.0, 1.0);
  for (std::uint32_t i = 0; i < 6; ++i) {
    landmarks.push_back({6 + i, other * landmarks[i].position, Eigen::Matrix2d::Zero()});
  }
  const auto map = std::make_shared<LandmarkIndex>(landmarks);
  const Pose2 truth(5.0, 5.0, -0.4);

  const auto places =
      ConstellationSearch({}, kBaseTLaser, map).search(seen_from(truth, landmarks, 15.0, random));

  ASSERT_EQ(places.size(), 2U);
  for (const Pose2& expected : {truth, other * truth}) {
    EXPECT_TRUE(are_same_place(places[0].map_T_base, expected) ||
                are_same_place(places[1].map_T_base, expected));
  }
}

TEST(ConstellationSearch, TakesNoCornerForAReflector) {
  std::mt19937_64 random = test::seeded_random();
  std::vector<Landmark> landmarks = scattered(8, 20.0, random);
  const std::vector<LandmarkObservation> seen =
      seen_from({10.0, 10.0, 0.0}, landmarks, 30.0, random);
  for (Landmark& landmark : landmarks) landmark.kind = LandmarkKind::kFeature;
  ConstellationSearch search({}, kBaseTLaser, std::make_shared<LandmarkIndex>(landmarks));

  EXPECT_TRUE(search.search(seen).empty());

  std::vector<LandmarkObservation> corners = seen;
  for (LandmarkObservation& corner : corners) corner.kind = LandmarkKind::kFeature;
  EXPECT_FALSE(search.search(corners).empty());
}

TEST(ConstellationSearch, DoesNotTakeAMirrorImage) {
  std::mt19937_64 random = test::seeded_random();
  const auto map = std::make_shared<LandmarkIndex>(scattered(8, 20.0, random));
  std::vector<LandmarkObservation> mirrored =
      seen_from({10.0, 10.0, 0.0}, map->landmarks(), 30.0, random);
  for (LandmarkObservation& observation : mirrored) observation.value.y() *= -1.0;

  for (const PlaceCandidate& place : ConstellationSearch({}, kBaseTLaser, map).search(mirrored)) {
    EXPECT_LT(place.explained, 4U);
  }
}

// A row of reflectors at even distances fits in many places.
TEST(Localizer, DoesNotDecideBetweenPlacesThatLookAlike) {
  std::mt19937_64 random = test::seeded_random();
  LandmarkMap map;
  for (int i = 0; i < 20; ++i) {
    MapLandmark landmark;
    landmark.id = i;
    landmark.position = {5.0 * i, 0.0};
    map.landmarks.push_back(landmark);
  }
  std::vector<Landmark> landmarks;
  for (const MapLandmark& landmark : map.landmarks) {
    landmarks.push_back(
        {static_cast<std::uint32_t>(landmark.id), landmark.position, Eigen::Matrix2d::Zero()});
  }
  LocalizerParams params;
  params.base_T_laser = kBaseTLaser;
  Localizer localizer(params, map);

  for (int i = 0; i < 40; ++i) {
    const Time stamp{std::chrono::milliseconds(125 * i)};
    localizer.add_motion(stamp, {});
    const auto& report =
        localizer.add_reflectors(stamp, seen_from({50.0, 3.0, 0.1}, landmarks, 12.0, random));
    EXPECT_FALSE(report.map_T_base);
  }

  EXPECT_EQ(localizer.state().reason, LocalizationReason::kAmbiguous);
}

// Two reflectors that fit in many places, and corners that tell which one it is.
class CornersBesideReflectors : public ::testing::Test {
 protected:
  CornersBesideReflectors() : random_(test::seeded_random()) {
    std::vector<Landmark> corners = scattered(60, 100.0, random_);
    for (std::uint32_t i = 0; i < 10; ++i) {
      add({i, {10.0 * i, 50.0}, Eigen::Matrix2d::Zero()});
    }
    for (Landmark& corner : corners) {
      corner.id += 100;
      corner.kind = LandmarkKind::kFeature;
      add(corner);
    }
    params_.base_T_laser = kBaseTLaser;
  }

  void add(const Landmark& landmark) {
    landmarks_.push_back(landmark);
    MapLandmark copy;
    copy.id = static_cast<int>(landmark.id);
    copy.position = landmark.position;
    copy.kind = landmark.kind;
    map_.landmarks.push_back(copy);
  }

  // What the vehicle sees, of 20 scans while it stands.
  LocalizerReport stand_at(const Pose2& truth) {
    Localizer localizer(params_, map_);
    for (int i = 0; i < 20; ++i) {
      const Time stamp{std::chrono::milliseconds(125 * i)};
      localizer.add_motion(stamp, {});
      std::vector<LandmarkObservation> seen;
      for (const Landmark& landmark : landmarks_) {
        for (LandmarkObservation& one : seen_from(truth, {landmark}, 25.0, random_)) {
          one.kind = landmark.kind;
          seen.push_back(one);
        }
      }
      localizer.add_reflectors(stamp, seen);
    }
    return localizer.state();
  }

  std::mt19937_64 random_;
  LandmarkMap map_;
  std::vector<Landmark> landmarks_;
  LocalizerParams params_;
};

TEST_F(CornersBesideReflectors, TellWhereItIs) {
  const Pose2 truth(50.0, 46.0, 0.3);

  const LocalizerReport report = stand_at(truth);

  ASSERT_TRUE(report.map_T_base);
  EXPECT_TRUE(are_same_place(report.map_T_base->pose, truth));
}

TEST_F(CornersBesideReflectors, AreNotAskedIfNotWanted) {
  params_.recovery.corners = false;

  EXPECT_FALSE(stand_at({50.0, 46.0, 0.3}).map_T_base);
}

TEST_F(CornersBesideReflectors, DoNotMakeAPoseOkWithoutReflectors) {
  const LocalizerReport report = stand_at({50.0, 15.0, 0.3});  // 35 m from all reflectors

  ASSERT_TRUE(report.map_T_base);
  EXPECT_EQ(report.status, LocalizationStatus::kDegraded);
}

TEST(Localizer, KeepsItsPoseAmongGhostReflections) {
  std::mt19937_64 random = test::seeded_random();
  const std::vector<Landmark> landmarks = scattered(30, 40.0, random);
  LandmarkMap map;
  for (const Landmark& landmark : landmarks) {
    MapLandmark copy;
    copy.id = static_cast<int>(landmark.id);
    copy.position = landmark.position;
    map.landmarks.push_back(copy);
  }
  LocalizerParams params;
  params.base_T_laser = kBaseTLaser;
  Localizer localizer(params, map);
  Pose2 truth(10.0, 20.0, 0.0);
  localizer.set_pose(Time{}, PoseEstimate{truth, pose_covariance(0.05, 0.01)});
  const PoseEstimate motion{{0.1, 0.0, 0.0}, pose_covariance(1e-3, 2e-4)};

  for (int i = 1; i < 100; ++i) {
    const Time stamp{std::chrono::milliseconds(125 * i)};
    truth = truth * motion.pose;
    localizer.add_motion(stamp, motion);
    std::vector<LandmarkObservation> seen = seen_from(truth, landmarks, 15.0, random);
    const std::size_t real = seen.size();
    for (std::size_t k = 0; k < real / 2; ++k) {  // a mirror along y = 26
      const Pose2 map_T_laser = truth * kBaseTLaser;
      const Eigen::Vector2d point = map_T_laser * seen[k].value;
      seen.push_back(
          observed(map_T_laser.inverse() * Eigen::Vector2d(point.x(), 52.0 - point.y())));
    }
    const auto& report = localizer.add_reflectors(stamp, seen);
    ASSERT_TRUE(report.map_T_base) << i << " " << name_of(report.reason);
    EXPECT_LT((report.map_T_base->pose.translation() - truth.translation()).norm(), 0.03) << i;
  }
}

}  // namespace
}  // namespace falko_slam
