// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/scan_recording.hpp"

#include <gtest/gtest.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/String.h>

#include <fstream>
#include <iterator>

#include "falko_slam/common/whole_file.hpp"
#include "falko_slam/ros_bridge/bag_file.hpp"
#include "support/carmen_lines.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

constexpr float kMarker = 12345.678F;

class ReadScans : public ::testing::Test {
 protected:
  // Two scans on each topic, at seconds 1 and 2, and a message of another type.
  void write_bag(const std::vector<std::string>& topics) const {
    BagFile file(bag_, true);
    for (const unsigned second : {1U, 2U}) {
      const Time time(std::chrono::seconds{second});
      for (const std::string& topic : topics) {
        sensor_msgs::LaserScan scan;
        scan.header.stamp = ros::Time(second, 0);
        scan.ranges = {kMarker, static_cast<float>(topic.size())};
        file.write(topic, time, scan);
      }
      file.write("chatter", time, std_msgs::String());
    }
    file.finish();
  }
  std::string read(const std::string& path, const std::string& topic = "") {
    return read_scans(path, topic, [this](const RawScan& raw) {
      stamps_.push_back(to_seconds(raw.stamp.time_since_epoch()));
      last_ranges_.push_back(raw.ranges[raw.range_count - 1]);
    });
  }
  std::string error_of(const std::string& path, const std::string& topic = "") {
    try {
      read(path, topic);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "no error";
  }
  std::string bytes() const {
    std::ifstream in(bag_, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }
  std::string write_bytes(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_.file(name), std::ios::binary) << bytes;
    return folder_.file(name);
  }

  test::TemporaryFolder folder_;
  std::string bag_ = folder_.file("test.bag");
  std::vector<double> stamps_;
  std::vector<float> last_ranges_;
};

TEST_F(ReadScans, TakesTheOnlyTopicOfScans) {
  write_bag({"scan"});
  EXPECT_EQ(read(bag_), "2 scans on /scan");
  EXPECT_EQ(stamps_, (std::vector<double>{1.0, 2.0}));
}

TEST_F(ReadScans, UnpacksABag) {
  write_bag({"scan"});
  for (const std::string name : {"packed.bag.gz", "packed.bag.bz2"}) {
    EXPECT_EQ(read(folder_.write(name, bytes())), "2 scans on /scan");
  }
}

TEST_F(ReadScans, NamesAPackedBagThatIsDamaged) {
  write_bag({"scan"});
  const std::string whole = folder_.write("whole.bag.gz", bytes());
  std::string packed = read_whole_file(whole);
  packed[packed.size() / 2] = static_cast<char>(~packed[packed.size() / 2]);
  for (const std::string& path :
       {write_bytes("damaged.bag.gz", packed), write_bytes("cut.bag.gz", packed.substr(0, 100)),
        write_bytes("none.bag.bz2", "no bag"), folder_.file("missing.bag.gz")}) {
    EXPECT_EQ(error_of(path).find(path + ": "), 0U) << error_of(path);
  }
  EXPECT_NE(error_of(folder_.write("other.bag.gz", "no bag")).find("other.bag.gz: "),
            std::string::npos);
}

TEST_F(ReadScans, TakesTheTopicAskedForWithOrWithoutItsSlash) {
  write_bag({"scan", "rear/scan"});
  for (const std::string topic : {"rear/scan", "/rear/scan"}) {
    last_ranges_.clear();
    EXPECT_EQ(read(bag_, topic), "2 scans on /rear/scan");
    EXPECT_EQ(last_ranges_, (std::vector<float>{9.0F, 9.0F}));
  }
}

TEST_F(ReadScans, AsksWhichOfSeveralTopics) {
  write_bag({"scan", "rear/scan"});
  EXPECT_EQ(error_of(bag_), bag_ +
                                ": which scans? LaserScan topics: /rear/scan, /scan; all topics: "
                                "/chatter, /rear/scan, /scan");
}

TEST_F(ReadScans, NamesTheTopicsWhereTheOneAskedForIsNotThere) {
  write_bag({"scan"});
  EXPECT_EQ(error_of(bag_, "front"), bag_ +
                                         ": no LaserScan on front. LaserScan topics: /scan; all "
                                         "topics: /chatter, /scan");
  EXPECT_NE(error_of(bag_, "chatter").find("no LaserScan on chatter"), std::string::npos);
}

TEST_F(ReadScans, SaysThatABagHasNoScans) {
  write_bag({});
  EXPECT_NE(error_of(bag_).find("LaserScan topics: none; all topics: /chatter"), std::string::npos);
}

TEST_F(ReadScans, NamesABagThatIsNone) {
  for (const std::string& path :
       {write_bytes("empty.bag", ""), write_bytes("garbage.bag", std::string(5000, '?')),
        write_bytes("version.bag", "#ROSBAG V2.0\n"), folder_.file("missing.bag")}) {
    EXPECT_EQ(error_of(path).find(path + ": "), 0U) << error_of(path);
  }
}

TEST_F(ReadScans, NamesABagThatIsCutShort) {
  write_bag({"scan"});
  const std::string whole = bytes();
  for (const std::size_t percent : {1U, 20U, 50U, 80U, 99U}) {
    const std::string path = write_bytes("cut.bag", whole.substr(0, whole.size() * percent / 100));
    EXPECT_EQ(error_of(path).find(path + ": "), 0U) << percent << " % " << error_of(path);
  }
}

TEST_F(ReadScans, NamesABagWithADamagedMessage) {
  write_bag({"scan"});
  std::string damaged = bytes();
  const std::string marker(reinterpret_cast<const char*>(&kMarker), sizeof kMarker);
  const std::size_t first_range = damaged.find(marker);
  ASSERT_NE(first_range, std::string::npos);
  damaged[first_range - 3] = 1;  // of the number of ranges: 256 more than there are
  const std::string path = write_bytes("damaged.bag", damaged);
  EXPECT_EQ(error_of(path).find(path + ": "), 0U) << error_of(path);
}

TEST_F(ReadScans, ReadsLogs) {
  const std::string log =
      test::flaser_line({1.0F, 2.0F}, {}, {}, 1.0) + test::flaser_line({1.0F, 3.0F}, {}, {}, 2.0);
  for (const char* name : {"test.log", "test.log.gz", "test.log.bz2", "no-ending"}) {
    stamps_.clear();
    EXPECT_NE(read(folder_.write(name, log)).find("2 scans"), std::string::npos) << name;
    EXPECT_EQ(stamps_, (std::vector<double>{1.0, 2.0})) << name;
  }
}

TEST_F(ReadScans, NamesALogWithoutScans) {
  const std::string path = folder_.write("odometry.log", test::odom_line({}, 1.0));
  EXPECT_EQ(error_of(path).find(path + ": no laser scan in 1 lines"), 0U) << error_of(path);
}

}  // namespace
}  // namespace falko_slam
