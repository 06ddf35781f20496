// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/bytes.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace falko_slam {
namespace {

TEST(Bytes, ComeBackAsTheyWereWritten) {
  ByteWriter out;
  out.text("head");
  out.u8(200);
  out.u32(4000000000U);
  out.u64(std::numeric_limits<std::uint64_t>::max() - 1);
  out.i64(-5);
  out.f32(-1.5e-30F);
  out.f64(-std::numeric_limits<double>::infinity());

  ByteReader in(out.bytes(), 4, out.bytes().size());
  EXPECT_EQ(in.u8(), 200);
  EXPECT_EQ(in.u32(), 4000000000U);
  EXPECT_EQ(in.u64(), std::numeric_limits<std::uint64_t>::max() - 1);
  EXPECT_EQ(in.i64(), -5);
  EXPECT_EQ(in.f32(), -1.5e-30F);
  EXPECT_EQ(in.f64(), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(in.left(), 0U);
}

TEST(Bytes, AreLittleEndian) {
  ByteWriter out;
  out.u32(0x01020304U);
  EXPECT_EQ(out.bytes(), std::string("\x04\x03\x02\x01"));
}

TEST(ByteReader, ReadsNothingBeyondItsEnd) {
  const std::string bytes(9, '\0');
  ByteReader in(bytes, 0, 8);
  EXPECT_EQ(in.u32(), 0U);
  EXPECT_THROW(in.u64(), std::runtime_error);
  EXPECT_EQ(in.u32(), 0U);
  EXPECT_THROW(in.u8(), std::runtime_error);
  EXPECT_THROW(ByteReader(bytes, 2, 8).text(7), std::runtime_error);
  EXPECT_EQ(ByteReader("abcd", 1, 4).text(2), "bc");
}

TEST(Checksum, IsCrc32) {
  EXPECT_EQ(checksum("123456789", 9), 0xCBF43926U);
  EXPECT_EQ(checksum("123456789", 0), 0U);
}

}  // namespace
}  // namespace falko_slam
