// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/file_below.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

namespace fs = std::filesystem;

std::string refusal_of(const std::string& folder, const std::string& name) {
  try {
    file_below(folder, name);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(FileBelow, IsThePathInTheFolderWhetherItExistsOrNot) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(file_below(folder.path(), "a.keyframes"), folder.file("a.keyframes"));
  EXPECT_EQ(file_below(folder.path() + "/", "hall/a b..c"), folder.file("hall/a b..c"));
  EXPECT_EQ(file_below(folder.file("none"), "a"), folder.file("none/a"));
  folder.write("there", "");
  EXPECT_EQ(file_below(folder.path(), "there"), folder.file("there"));
}

TEST(FileBelow, RefusesWhatLeadsOut) {
  const test::TemporaryFolder folder;
  for (const char* name : {"../a", "a/../../b", "..", "a/.."}) {
    EXPECT_EQ(refusal_of(folder.path(), name),
              "file name '" + std::string(name) + "': must not hold '..'");
  }
  EXPECT_EQ(refusal_of(folder.path(), "/etc/passwd"),
            "file name '/etc/passwd': must be relative to " + folder.path());
}

TEST(FileBelow, RefusesLinksThatLeadOut) {
  const test::TemporaryFolder folder;
  fs::create_directory(folder.file("inner"));
  folder.write("outside", "");
  fs::create_symlink(folder.file("outside"), folder.file("inner/link"));
  fs::create_directory_symlink(folder.path(), folder.file("inner/up"));
  const std::string refusal = "leads out of " + folder.file("inner");
  EXPECT_EQ(refusal_of(folder.file("inner"), "link"), "file name 'link': " + refusal);
  EXPECT_EQ(refusal_of(folder.file("inner"), "up/new"), "file name 'up/new': " + refusal);
}

TEST(FileBelow, AcceptsAFolderThatIsALink) {
  const test::TemporaryFolder folder;
  fs::create_directory(folder.file("real"));
  fs::create_directory_symlink(folder.file("real"), folder.file("link"));
  EXPECT_EQ(file_below(folder.file("link"), "a"), folder.file("real/a"));
}

TEST(FileBelow, RefusesWhatNamesNoFile) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(refusal_of(folder.path(), ""), "file name '': is empty");
  EXPECT_EQ(refusal_of(folder.path(), "a/"), "file name 'a/': names no file");
  EXPECT_EQ(refusal_of(folder.path(), "."), "file name '.': names no file");
  EXPECT_NE(refusal_of(folder.path(), std::string("a\0b", 3)), "accepted");
  EXPECT_EQ(refusal_of("", "a"), "file name 'a': no folder for files is configured");
}

}  // namespace
}  // namespace falko_slam
