// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/bytes.hpp"

#include <boost/crc.hpp>
#include <cstring>

namespace falko_slam {
namespace {

template <class To, class From>
To same_bits(From from) {
  static_assert(sizeof(To) == sizeof(From));
  To to;
  std::memcpy(&to, &from, sizeof to);
  return to;
}

}  // namespace

void ByteWriter::f32(float value) { put(same_bits<std::uint32_t>(value)); }
void ByteWriter::f64(double value) { put(same_bits<std::uint64_t>(value)); }

float ByteReader::f32() { return same_bits<float>(take<std::uint32_t>()); }
std::string ByteReader::text(std::size_t count) {
  if (left() < count) throw std::runtime_error("ends too early");
  at_ += count;
  return bytes_.substr(at_ - count, count);
}

double ByteReader::f64() { return same_bits<double>(take<std::uint64_t>()); }

std::uint32_t checksum(const std::string& bytes, std::size_t size) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), size);
  return crc.checksum();
}

}  // namespace falko_slam
