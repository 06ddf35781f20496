// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/drive_recording.hpp"

#include <gtest/gtest.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/String.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>
#include <stdexcept>

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/ros_bridge/bag_file.hpp"
#include "falko_slam/ros_bridge/carmen_bag.hpp"
#include "support/carmen_lines.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

struct Drive {
  std::vector<RecordedScan> scans;
  std::vector<float> first_ranges;
  DriveRecordingReport report;
};

Drive read(const std::string& path, const DriveRecordingParams& params = {}) {
  Drive drive;
  drive.report = read_drive(path, params, [&](const RecordedScan& scan) {
    drive.scans.push_back(scan);
    drive.first_ranges.push_back(scan.raw.ranges[0]);
  });
  return drive;
}

std::string error_of(const std::string& path, const DriveRecordingParams& params = {}) {
  try {
    read(path, params);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

void expect_near(const Pose2& a, const Pose2& b) {
  EXPECT_LT((a.translation() - b.translation()).norm(), 1e-6) << a << " and " << b;
  EXPECT_LT(std::abs(angle_between(a.theta(), b.theta())), 1e-6) << a << " and " << b;
}

class DriveRecordingOfALog : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string lines;
    for (int i = 0; i < 8; ++i) {
      robot_.emplace_back(0.4 * i, -0.1 * i, 0.3 * i - 1.0);
      const Pose2 laser = robot_.back() * mount_;
      lines += test::robotlaser_line({1.0F + static_cast<float>(i), 2.0F, 3.0F}, laser,
                                     robot_.back(), 100.0 + 0.2 * i);
    }
    log_ = folder_.write("drive.log", lines);
  }

  test::TemporaryFolder folder_;
  const Pose2 mount_{0.25, 0.1, 0.05};
  std::vector<Pose2> robot_;
  std::string log_;
};

TEST_F(DriveRecordingOfALog, HasTheOdometryOfEachLine) {
  const Drive drive = read(log_);
  ASSERT_EQ(drive.scans.size(), robot_.size());
  for (std::size_t i = 0; i < robot_.size(); ++i) {
    ASSERT_TRUE(drive.scans[i].odom_T_base) << i;
    expect_near(*drive.scans[i].odom_T_base, robot_[i]);
    expect_near(drive.scans[i].base_T_laser, mount_);
    EXPECT_FALSE(drive.scans[i].upside_down);
    EXPECT_EQ(drive.first_ranges[i], 1.0F + static_cast<float>(i));
  }
  EXPECT_EQ(drive.report.scans, robot_.size());
  EXPECT_EQ(drive.report.without_odometry, 0U);
  EXPECT_TRUE(drive.report.base_known);
}

TEST_F(DriveRecordingOfALog, IsTheSameFromABagOfIt) {
  const std::string bag = folder_.file("drive.bag");
  convert_carmen_log(log_, bag, {});
  const Drive from_log = read(log_);
  const Drive from_bag = read(bag);
  ASSERT_EQ(from_bag.scans.size(), from_log.scans.size());
  for (std::size_t i = 0; i < from_log.scans.size(); ++i) {
    ASSERT_TRUE(from_bag.scans[i].odom_T_base) << i;
    expect_near(*from_bag.scans[i].odom_T_base, *from_log.scans[i].odom_T_base);
    expect_near(from_bag.scans[i].base_T_laser, from_log.scans[i].base_T_laser);
    EXPECT_EQ(from_bag.scans[i].raw.stamp, from_log.scans[i].raw.stamp);
    EXPECT_EQ(from_bag.first_ranges[i], from_log.first_ranges[i]);
  }
  EXPECT_EQ(from_bag.report.without_odometry, 0U);
  EXPECT_NE(from_bag.report.description.find("8 scans on /scan"), std::string::npos);
}

TEST_F(DriveRecordingOfALog, LeavesTheOdometryAwayIfTold) {
  const std::string bag = folder_.file("drive.bag");
  convert_carmen_log(log_, bag, {});
  DriveRecordingParams params;
  params.use_odometry = false;
  for (const std::string& path : {log_, bag}) {
    const Drive drive = read(path, params);
    EXPECT_EQ(drive.report.without_odometry, robot_.size()) << path;
    for (const RecordedScan& scan : drive.scans) {
      EXPECT_FALSE(scan.odom_T_base);
      expect_near(scan.base_T_laser, mount_);
    }
  }
}

TEST_F(DriveRecordingOfALog, SaysThatALogHasNoScans) {
  const std::string path = folder_.write("odometry.log", test::odom_line({}, 1.0));
  EXPECT_EQ(error_of(path).find(path + ": no laser scan in 1 lines"), 0U) << error_of(path);
}

struct BagLayout {
  std::string slash;  // before the names of frames
  double roll = 0.0;  // of the laser [rad]
  bool odometry = true;
  bool mount = true;
};

class DriveRecordingOfABag : public ::testing::Test {
 protected:
  static geometry_msgs::TransformStamped transform(const std::string& parent,
                                                   const std::string& child, double x, double yaw,
                                                   double roll, const ros::Time& stamp) {
    geometry_msgs::TransformStamped result;
    result.header.frame_id = parent;
    result.header.stamp = stamp;
    result.child_frame_id = child;
    result.transform.translation.x = x;
    const double cy = std::cos(0.5 * yaw), sy = std::sin(0.5 * yaw);
    const double cr = std::cos(0.5 * roll), sr = std::sin(0.5 * roll);
    result.transform.rotation.w = cy * cr;
    result.transform.rotation.x = cy * sr;
    result.transform.rotation.y = sy * sr;
    result.transform.rotation.z = sy * cr;
    return result;
  }

  // Four scans a second apart, 1 m of way between them.
  std::string write(const BagLayout& layout) const {
    const std::string path = folder_.file("drive.bag");
    BagFile bag(path, true);
    for (unsigned second = 1; second <= 4; ++second) {
      const Time time(std::chrono::seconds{second});
      const ros::Time stamp(second, 0);
      tf2_msgs::TFMessage tf;
      if (layout.odometry) {
        tf.transforms.push_back(transform(layout.slash + "odom", layout.slash + "base_link",
                                          1.0 * second, 0.2, 0.0, stamp));
      }
      if (layout.mount) {
        tf.transforms.push_back(transform(layout.slash + "base_link", layout.slash + "laser", 0.4,
                                          0.1, layout.roll, stamp));
      }
      bag.write("tf", time, tf);
      sensor_msgs::LaserScan scan;
      scan.header.stamp = stamp;
      scan.header.frame_id = layout.slash + "laser";
      scan.ranges = {1.0F};
      bag.write("scan", time, scan);
      bag.write("chatter", time, std_msgs::String());
    }
    bag.finish();
    return path;
  }

  test::TemporaryFolder folder_;
};

TEST_F(DriveRecordingOfABag, TakesFramesWithALeadingSlash) {
  for (const char* slash : {"", "/"}) {
    const Drive drive = read(write({slash}));
    ASSERT_EQ(drive.scans.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
      ASSERT_TRUE(drive.scans[i].odom_T_base) << i;
      expect_near(*drive.scans[i].odom_T_base, {1.0 + static_cast<double>(i), 0.0, 0.2});
      expect_near(drive.scans[i].base_T_laser, {0.4, 0.0, 0.1});
    }
  }
}

TEST_F(DriveRecordingOfABag, HasNoOdometryWhereTfHasNone) {
  const Drive drive = read(write({"", 0.0, false}));
  EXPECT_EQ(drive.report.without_odometry, 4U);
  EXPECT_TRUE(drive.report.base_known);
  for (const RecordedScan& scan : drive.scans) {
    EXPECT_FALSE(scan.odom_T_base);
    expect_near(scan.base_T_laser, {0.4, 0.0, 0.1});
  }
}

TEST_F(DriveRecordingOfABag, SaysThatTheMountIsNotKnown) {
  const Drive drive = read(write({"", 0.0, true, false}));
  EXPECT_FALSE(drive.report.base_known);
  EXPECT_EQ(drive.report.without_odometry, 4U);
  for (const RecordedScan& scan : drive.scans) expect_near(scan.base_T_laser, {});
}

TEST_F(DriveRecordingOfABag, TurnsALaserUprightThatHangsUpsideDown) {
  const Drive drive = read(write({"", kPi}));
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_TRUE(drive.scans[i].upside_down);
    expect_near(drive.scans[i].base_T_laser, {0.4, 0.0, 0.1});
    ASSERT_TRUE(drive.scans[i].odom_T_base);
    expect_near(*drive.scans[i].odom_T_base, {1.0 + static_cast<double>(i), 0.0, 0.2});
  }
}

TEST_F(DriveRecordingOfABag, TakesOtherNamesOfFrames) {
  DriveRecordingParams params;
  params.odom_frame = "/odom";
  params.base_frame = "/base_link";
  EXPECT_EQ(read(write({}), params).report.without_odometry, 0U);
  params.odom_frame = "elsewhere";
  EXPECT_EQ(read(write({}), params).report.without_odometry, 4U);
}

TEST_F(DriveRecordingOfABag, NamesTheTopicsWhereTheOneAskedForIsNotThere) {
  const std::string path = write({});
  DriveRecordingParams params;
  params.topic = "front";
  EXPECT_EQ(error_of(path, params), path +
                                        ": no LaserScan on front. LaserScan topics: /scan; all "
                                        "topics: /chatter, /scan, /tf");
  EXPECT_EQ(error_of(folder_.file("missing.bag")).find(folder_.file("missing.bag") + ": "), 0U);
}

}  // namespace
}  // namespace falko_slam
