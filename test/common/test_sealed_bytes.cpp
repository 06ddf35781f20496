// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/sealed_bytes.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "falko_slam/common/whole_file.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

const FileKind kKind{"FALKOTST", 3, "tests"};

std::string sealed(const FileKind& kind = kKind) {
  ByteWriter out = begin_sealed(kind);
  out.u64(42);
  out.f64(-0.5);
  return seal(std::move(out));
}

std::string error_of(const std::string& bytes) {
  try {
    open_sealed(bytes, kKind);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

TEST(SealedBytes, GiveTheirContentBack) {
  const std::string bytes = sealed();
  EXPECT_EQ(bytes.size(), 8U + 4U + 16U + 4U);
  ByteReader in = open_sealed(bytes, kKind);
  EXPECT_EQ(in.u64(), 42U);
  EXPECT_THROW(require_end(in), std::runtime_error);
  EXPECT_EQ(in.f64(), -0.5);
  EXPECT_NO_THROW(require_end(in));
  EXPECT_THROW(in.u8(), std::runtime_error);
}

TEST(SealedBytes, SayWhatIsWrongWithThem) {
  EXPECT_EQ(error_of(""), "no file of tests");
  EXPECT_EQ(error_of("FALKOTS"), "no file of tests");
  EXPECT_EQ(error_of("FALKOTST"), "ends too early");
  EXPECT_EQ(error_of(sealed({"FALKOOTH", 3, "others"})), "no file of tests");
  EXPECT_EQ(error_of(sealed({"FALKOTST", 4, "tests"})), "version 4 is not known, only 3");
}

TEST(SealedBytes, NoticeEveryTruncationAndEveryFlippedBit) {
  const std::string bytes = sealed();
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_NE(error_of(bytes.substr(0, size)), "no error") << size;
  }
  EXPECT_NE(error_of(bytes + "x"), "no error");
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    std::string damaged = bytes;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
    EXPECT_NE(error_of(damaged), "no error") << bit;
  }
}

TEST(SealedBytes, AreWrittenOverTheirOwnKindOnly) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("file");
  write_sealed_file(path, sealed(), kKind);
  write_sealed_file(path, sealed(), kKind);
  EXPECT_EQ(read_whole_file(path), sealed());
  for (const char* content : {"", "short", "a letter to somebody"}) {
    const std::string other = folder.write("other", content);
    try {
      write_sealed_file(other, sealed(), kKind);
      FAIL() << "no error";
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(error.what(), other + ": is there and no file of tests, not overwritten");
    }
    EXPECT_EQ(read_whole_file(other), content);
  }
}

}  // namespace
}  // namespace falko_slam
