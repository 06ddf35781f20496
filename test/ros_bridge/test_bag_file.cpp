// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/bag_file.hpp"

#include <gtest/gtest.h>
#include <std_msgs/String.h>
#include <sys/resource.h>

#include <csignal>

#include "support/bag_contents.hpp"
#include "support/temporary_folder.hpp"
#include "support/times.hpp"

namespace falko_slam {
namespace {

std_msgs::String text(const std::string& data) {
  std_msgs::String message;
  message.data = data;
  return message;
}

// No file grows beyond `bytes` as long as it lives: a disk that is full.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

class BagFileTest : public ::testing::Test {
 protected:
  void write(const std::string& data, bool replace = true) const {
    BagFile file(path_, replace);
    file.write("topic", test::at_seconds(1), text(data));
    file.finish();
  }
  std::string content() const {
    const auto messages = test::bag_messages_on<std_msgs::String>(path_, "/topic");
    return messages.size() == 1 ? messages[0].data : "not one message";
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("file.bag");
};

TEST_F(BagFileTest, WritesMessagesUnderTheirWholeNames) {
  write("first");
  EXPECT_EQ(content(), "first");
  EXPECT_EQ(folder_.names(), (std::set<std::string>{"file.bag"}));
}

TEST_F(BagFileTest, RefusesAFileThatExists) {
  write("first");
  try {
    write("second", false);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), path_ + ": exists already");
  }
  EXPECT_EQ(content(), "first");
  EXPECT_EQ(folder_.names(), (std::set<std::string>{"file.bag"}));
}

TEST_F(BagFileTest, TheOldFileStaysUntilTheNewOneIsFinished) {
  write("first");
  BagFile file(path_, true);
  file.write("topic", test::at_seconds(1), text("second"));
  EXPECT_EQ(content(), "first");
  file.finish();
  EXPECT_EQ(content(), "second");
}

TEST_F(BagFileTest, RemovesWhatWasNotFinished) {
  write("first");
  {
    BagFile file(path_, true);
    file.write("topic", test::at_seconds(1), text("second"));
    EXPECT_EQ(folder_.names().size(), 2U);
  }
  EXPECT_EQ(content(), "first");
  EXPECT_EQ(folder_.names(), (std::set<std::string>{"file.bag"}));
}

TEST_F(BagFileTest, TimesNeverRunBackward) {
  BagFile file(path_, false);
  for (const int second : {5, 3, 4, 5, 6}) {
    file.write("topic", test::at_seconds(second), text(std::to_string(second)));
  }
  file.finish();
  EXPECT_EQ(file.moved_times(), 2U);
  std::vector<std::uint64_t> times;
  for (const auto& message : test::bag_messages(path_)) times.push_back(message.time.toNSec());
  EXPECT_EQ(times, (std::vector<std::uint64_t>{5'000'000'000, 5'000'000'001, 5'000'000'002,
                                               5'000'000'003, 6'000'000'000}));
}

TEST_F(BagFileTest, MessagesOfOneTimePlayInTheOrderOfWriting) {
  const std::vector<std::string> topics = {"d", "b", "c", "a", "e", "b", "a"};
  BagFile file(path_, false);
  for (const std::string& topic : topics) file.write(topic, test::at_seconds(1), text(topic));
  file.finish();
  EXPECT_EQ(file.moved_times(), 0U);
  EXPECT_EQ(test::topics_in_order(test::bag_messages(path_)),
            (std::vector<std::string>{"/d", "/b", "/c", "/a", "/e", "/b", "/a"}));
}

TEST_F(BagFileTest, TimesThatRosCannotHoldStayAtItsEnd) {
  BagFile file(path_, false);
  for (int i = 0; i < 3; ++i) file.write("topic", Time::max(), text("late"));
  file.finish();
  EXPECT_EQ(test::bag_messages(path_).back().time, ros::TIME_MAX);
}

TEST_F(BagFileTest, MovesATimeOfZeroToTheFirstOneThatABagMayHold) {
  BagFile file(path_, false);
  file.write("topic", Time(), text("zero"));
  file.finish();
  EXPECT_EQ(file.moved_times(), 1U);
  EXPECT_EQ(test::bag_messages(path_).at(0).time, ros::TIME_MIN);
}

TEST_F(BagFileTest, LatchedMessagesSayThatTheyAreAndCanBeRead) {
  BagFile file(path_, false);
  file.write_latched("topic", test::at_seconds(1), text("latched"));
  file.finish();
  EXPECT_EQ(content(), "latched");
  rosbag::Bag bag(path_);
  rosbag::View view(bag);
  ASSERT_EQ(view.getConnections().size(), 1U);
  EXPECT_EQ((*view.getConnections()[0]->header)["latching"], "1");
  EXPECT_EQ(view.getConnections()[0]->datatype, "std_msgs/String");
}

TEST_F(BagFileTest, NamesAFileThatCannotBeWritten) {
  const std::string path = folder_.file("missing/file.bag");
  try {
    BagFile file(path, false);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()).find(path + ": cannot be written"), 0U) << error.what();
  }
}

TEST_F(BagFileTest, AFullDiskIsToldAndLeavesNothingBehind) {
  write("first");
  const std::string large(1000000, 'x');  // more than rosbag keeps in memory
  for (const std::string& data : {std::string("small"), large}) {
    const FullDisk disk(4200);  // less than the first page of a bag and a message
    try {
      write(data);
      FAIL() << data.size();
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string(error.what()).find(path_ + ": cannot be written"), 0U) << error.what();
    }
  }
  EXPECT_EQ(content(), "first");
  EXPECT_EQ(folder_.names(), (std::set<std::string>{"file.bag"}));
}

}  // namespace
}  // namespace falko_slam
