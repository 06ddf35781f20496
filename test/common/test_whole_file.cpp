// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/whole_file.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <set>
#include <stdexcept>

#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

TEST(WholeFile, ComesBackAsItWasWritten) {
  const test::TemporaryFolder folder;
  std::string content;
  for (int i = 0; i < 100000; ++i) content.push_back(static_cast<char>(i * i));
  for (const std::string& text : {content, std::string(), std::string("a\0b", 3)}) {
    write_whole_file(folder.file("file"), text);
    EXPECT_EQ(read_whole_file(folder.file("file")), text);
  }
  EXPECT_EQ(folder.names(), std::set<std::string>{"file"});
}

TEST(WholeFile, ErrorsNameTheFileAndTheReason) {
  const test::TemporaryFolder folder;
  const auto error_of = [](const auto& work) {
    try {
      work();
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_EQ(error_of([&] { read_whole_file(folder.file("none")); }),
            folder.file("none") + ": cannot be read: No such file or directory");
  EXPECT_EQ(error_of([&] { read_whole_file(folder.path()); }),
            folder.path() + ": cannot be read: Is a directory");
  EXPECT_EQ(error_of([&] { write_whole_file(folder.file("no/file"), ""); }),
            folder.file("no/file") + ": cannot be written: No such file or directory");
}

TEST(WholeFile, AFailureLeavesWhatWasThereAndNothingElse) {
  const test::TemporaryFolder folder;
  ASSERT_EQ(std::system(("mkdir " + folder.file("taken")).c_str()), 0);
  EXPECT_THROW(write_whole_file(folder.file("taken"), "new"), std::runtime_error);
  EXPECT_EQ(folder.names(), std::set<std::string>{"taken"});
}

TEST(WholeFile, RemovesWhatDeadProcessesHaveLeft) {
  const pid_t dead = ::fork();
  if (dead == 0) ::_exit(0);
  ASSERT_EQ(::waitpid(dead, nullptr, 0), dead);
  const test::TemporaryFolder folder;
  const std::string part_of_the_dead = "." + std::to_string(dead) + ".part";
  const std::string part_of_the_living = "." + std::to_string(::getppid()) + ".part";
  const std::set<std::string> others = {
      "file" + part_of_the_living, "other" + part_of_the_dead,        "file.12x.part", "file..part",
      "file.99999999999.part",     "file" + part_of_the_dead + ".bak"};
  for (const std::string& name : others) folder.write(name, "not mine");
  folder.write("file" + part_of_the_dead, "half");
  write_whole_file(folder.file("file"), "whole");
  std::set<std::string> left = others;
  left.insert("file");
  EXPECT_EQ(folder.names(), left);
  EXPECT_EQ(read_whole_file(folder.file("file")), "whole");
}

}  // namespace
}  // namespace falko_slam
