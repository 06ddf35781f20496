// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/keyframe_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include "falko_slam/common/bytes.hpp"
#include "falko_slam/sensor/scan_normalizer.hpp"
#include "support/numbers.hpp"
#include "support/seeds.hpp"
#include "support/synthetic_scans.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

using Records = std::vector<KeyframeRecord>;

// Two drives through a room, with a beam of every status.
Records some_records(std::size_t beams = 12) {
  auto random = test::seeded_random();
  Records records(3);
  for (std::size_t i = 0; i < records.size(); ++i) {
    const Pose2 pose(0.3 * static_cast<double>(i), -0.1, 2.0);
    KeyframeRecord& record = records[i];
    record.stamp = Time(Duration(1'000'000'000'123 + 7 * static_cast<std::int64_t>(i)));
    record.drive = i < 2 ? 0 : 1;
    record.odom_T_laser = pose;
    record.base_T_laser = {0.4, -0.01, -3.1};
    record.scan = test::closed_scan(test::room_with_pillar(), pose, beams, 0.01, random);
    record.scan.first_beam_time = record.stamp - Duration(5);
    record.scan.time_increment = Duration(-86'805);
    record.scan.reversed = i == 1;
    for (std::size_t status = 1; status < kBeamStatusCount; ++status) {
      record.scan.status[status] = static_cast<BeamStatus>(status);
      record.scan.ranges[status] = test::kNaN;
    }
  }
  return records;
}

void expect_equal(const LaserScan& a, const LaserScan& b) {
  EXPECT_EQ(a.first_beam_time, b.first_beam_time);
  EXPECT_EQ(a.time_increment, b.time_increment);
  EXPECT_EQ(a.angle_min, b.angle_min);
  EXPECT_EQ(a.angle_increment, b.angle_increment);
  EXPECT_EQ(a.range_max, b.range_max);
  EXPECT_EQ(a.closed, b.closed);
  EXPECT_EQ(a.reversed, b.reversed);
  ASSERT_EQ(a.status, b.status);
  ASSERT_EQ(a.ranges.size(), b.ranges.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_TRUE(a.valid(i) ? a.ranges[i] == b.ranges[i] : std::isnan(b.ranges[i])) << i;
  }
}

void expect_equal(const Records& a, const Records& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].stamp, b[i].stamp);
    EXPECT_EQ(a[i].drive, b[i].drive);
    EXPECT_EQ(a[i].odom_T_laser.translation(), b[i].odom_T_laser.translation());
    EXPECT_EQ(a[i].odom_T_laser.theta(), b[i].odom_T_laser.theta());
    EXPECT_EQ(a[i].base_T_laser.translation(), b[i].base_T_laser.translation());
    EXPECT_EQ(a[i].base_T_laser.theta(), b[i].base_T_laser.theta());
    expect_equal(a[i].scan, b[i].scan);
  }
}

std::string error_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

std::string error_in(const std::string& bytes) {
  return error_of([&] { keyframes_from(bytes); });
}

// With the checksum that fits.
std::string sealed(const std::string& bytes) {
  ByteWriter out;
  out.text(bytes);
  out.u32(checksum(bytes, bytes.size()));
  return out.bytes();
}

std::string error_after(const std::function<void(Records&)>& change) {
  Records records = some_records();
  change(records);
  return error_in(to_bytes(records));
}

TEST(KeyframeFile, ComesBackAsItWasWritten) {
  const test::TemporaryFolder folder;
  const Records records = some_records();
  write_keyframe_file(folder.file("a"), records);
  expect_equal(records, read_keyframe_file(folder.file("a")));
  EXPECT_EQ(folder.names(), std::set<std::string>{"a"});
}

TEST(KeyframeFile, HoldsScansWithoutBeams) {
  Records records = some_records();
  records[1].scan = LaserScan();
  expect_equal(records, keyframes_from(to_bytes(records)));
}

TEST(KeyframeFile, TellsOfEveryTruncation) {
  const std::string bytes = to_bytes(some_records(6));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const std::string error = error_in(bytes.substr(0, size));
    EXPECT_TRUE(error == "no file of keyframes" || error == "ends too early" ||
                error == "damaged or cut short: the checksum does not fit")
        << size << ": " << error;
  }
}

// As a program would leave it that counts wrongly: the checksum fits.
TEST(KeyframeFile, TellsOfEverySealedTruncation) {
  const std::string bytes = to_bytes(some_records(6));
  for (std::size_t size = 20; size + 4 < bytes.size(); ++size) {
    const std::string error = error_in(sealed(bytes.substr(0, size)));
    EXPECT_NE(error.find("ends too early"), std::string::npos) << size << ": " << error;
  }
}

TEST(KeyframeFile, TellsOfEveryChangedByte) {
  const std::string bytes = to_bytes(some_records(6));
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 0x10);
    EXPECT_NE(error_in(changed), "no error") << i;
  }
}

TEST(KeyframeFile, TellsOfOtherFilesAndNewerVersions) {
  EXPECT_EQ(error_in("Region: hall 3, and some more text"), "no file of keyframes");
  std::string newer = to_bytes(some_records());
  newer[8] = 2;
  EXPECT_EQ(error_in(newer), "version 2 is not known, only 1");
  std::string longer = to_bytes(some_records());
  longer = sealed(longer.substr(0, longer.size() - 4) + "ab");
  EXPECT_EQ(error_in(longer), "has 2 bytes too many");
}

TEST(KeyframeFile, TellsOfACountBeyondAllMemory) {
  std::string bytes = to_bytes(some_records());
  bytes = bytes.substr(0, bytes.size() - 4);
  for (std::size_t i = 12; i < 20; ++i) bytes[i] = '\x7F';
  EXPECT_EQ(error_in(sealed(bytes)), "ends too early");
}

TEST(KeyframeFile, TellsOfNumbersWithoutSense) {
  EXPECT_EQ(error_after([](Records& r) {
              r[1].odom_T_laser = {test::kNaN, 0.0, 0.0};
            }),
            "keyframe 1: a pose of nan, 0.000000, 0.000000 makes no sense");
  EXPECT_EQ(error_after([](Records& r) { r[0].scan.ranges[7] = -1.0; }),
            "keyframe 0: beam 7 has range -1.000000, which makes no sense");
  EXPECT_EQ(error_after([](Records& r) { r[2].scan.ranges[7] = test::kNaN; }),
            "keyframe 2: beam 7 has range nan, which makes no sense");
  EXPECT_EQ(error_after([](Records& r) { r[2].scan.status[8] = static_cast<BeamStatus>(17); }),
            "keyframe 2: beam 8 has status 17, which is not known");
  EXPECT_EQ(error_after([](Records& r) { r[0].scan.angle_increment = 0.0; }),
            "keyframe 0: angle_increment 0.000000 makes no sense");
  EXPECT_EQ(error_after([](Records& r) { r[0].scan.angle_increment = 1.0; }),
            "keyframe 0: its beams are more than a full turn");
  EXPECT_EQ(error_after([](Records& r) { r[2].drive = 2; }),
            "keyframe 2: drive 2 does not follow drive 0");
  EXPECT_EQ(error_after([](Records& r) { r[1].drive = 1, r[2].drive = 0; }),
            "keyframe 2: drive 0 does not follow drive 1");
  EXPECT_EQ(error_after([](Records& r) { r[0].drive = 1; }),
            "keyframe 0: drive 1 is not the first one");
}

TEST(KeyframeFile, ErrorsNameTheFile) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("a", "something else");
  EXPECT_EQ(error_of([&] { read_keyframe_file(path); }), path + ": no file of keyframes");
  EXPECT_EQ(error_of([&] { read_keyframe_file(folder.file("none")); }),
            folder.file("none") + ": cannot be read: No such file or directory");
}

TEST(KeyframeFile, OverwritesOnlyKeyframesAndOnlyByKeyframes) {
  const test::TemporaryFolder folder;
  const std::string other = folder.write("map.yaml", "image: map.pgm");
  EXPECT_EQ(error_of([&] { write_keyframe_file(other, some_records()); }),
            other + ": is there and no file of keyframes, not overwritten");
  EXPECT_EQ(read_keyframe_file(folder.write("old", to_bytes(some_records()))).size(), 3U);
  EXPECT_EQ(error_of([&] { write_keyframe_file(folder.file("old"), {}); }),
            folder.file("old") + ": there is no keyframe to save");
  EXPECT_EQ(read_keyframe_file(folder.file("old")).size(), 3U);
  write_keyframe_file(folder.file("old"), Records(1, some_records().front()));
  EXPECT_EQ(read_keyframe_file(folder.file("old")).size(), 1U);
}

TEST(KeyframeFile, IsNotWrittenIfItCouldNotBeReadAgain) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("a");
  write_keyframe_file(path, some_records());
  Records records = some_records();
  records.pop_back();
  records[1].odom_T_laser = {1e12, 0.0, 0.0};
  EXPECT_EQ(
      error_of([&] { write_keyframe_file(path, records); }),
      path +
          ": could not be read again, not written: keyframe 1: a pose of 1000000000000.000000, " +
          "0.000000, 0.000000 makes no sense");
  EXPECT_EQ(read_keyframe_file(path).size(), 3U);
}

// Nobody builds them, but one such scan must not make the others unreadable.
TEST(KeyframeFile, HoldsWhateverScanPassesTheNormaliser) {
  const float range = 2.0F;
  RawScan raw;
  raw.angle_min = raw.angle_max = -99.0;
  raw.angle_increment = -99.0;
  raw.ranges = &range;
  raw.range_count = 1;
  Records records = some_records();
  ASSERT_TRUE(normalize(raw, {}, records[1].scan).usable());
  expect_equal(records, keyframes_from(to_bytes(records)));
}

}  // namespace
}  // namespace falko_slam
