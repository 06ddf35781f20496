// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/line_reader.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "falko_slam/common/whole_file.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

std::string reading_error(const std::string& path) {
  try {
    LineReader file(path);
    for (std::string line; file.next(line);) continue;
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

TEST(LineReader, ReadsPlainAndPackedFiles) {
  const test::TemporaryFolder folder;
  for (const char* name : {"a.txt", "a.gz", "a.bz2"}) {
    LineReader file(folder.write(name, "one\n\ntwo"));
    std::string line;
    std::string all;
    while (file.next(line)) all += line + "|";
    EXPECT_EQ(all, "one||two|");
    EXPECT_EQ(file.lines(), 3U);
  }
}

TEST(LineReader, FailureNamesFileAndLine) {
  const test::TemporaryFolder folder;
  LineReader file(folder.write("a.txt", "one\ntwo\n"));
  std::string line;
  file.next(line);
  file.next(line);
  try {
    file.fail("is wrong");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()), folder.file("a.txt") + ": line 2: is wrong");
  }
}

// A few kilobytes may unpack to more than there is memory.
TEST(LineReader, RefusesALineThatNeverEnds) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("a.gz", "short\n" + std::string(20000000, '7'));
  EXPECT_EQ(reading_error(path), path + ": line 2: is longer than 16777216 bytes");
}

TEST(LineReader, NamesFilesThatAreMissingOrDamaged) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(reading_error(folder.file("none")).find(folder.file("none") + ": cannot be read"), 0U);
  EXPECT_EQ(reading_error(folder.path()).find(folder.path() + ": cannot be read"), 0U);
  const std::string packed = read_whole_file(folder.write("a.gz", std::string(100000, 'x') + "\n"));
  write_whole_file(folder.file("b.gz"), packed.substr(0, packed.size() / 2));
  const std::string error = reading_error(folder.file("b.gz"));
  EXPECT_EQ(error.find(folder.file("b.gz") + ": damaged after line 0"), 0U) << error;
}

}  // namespace
}  // namespace falko_slam
