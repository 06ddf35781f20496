// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "signature_file.hpp"

#include <boost/crc.hpp>
#include <stdexcept>

#include "falko_slam/common/whole_file.hpp"

namespace falko_slam {
namespace {

const std::string kMagic = "FALKOSIG";
constexpr std::uint32_t kVersion = 1;

template <class Number>
void put(std::string& out, Number number) {
  for (std::size_t i = 0; i < sizeof number; ++i) {
    out.push_back(static_cast<char>((number >> (8 * i)) & 0xFF));
  }
}

template <class Number>
Number take(const std::string& in, std::size_t& at) {
  Number number = 0;
  for (std::size_t i = 0; i < sizeof number; ++i) {
    number |= static_cast<Number>(static_cast<unsigned char>(in[at + i])) << (8 * i);
  }
  at += sizeof number;
  return number;
}

std::uint32_t checksum(const std::string& text, std::size_t size) {
  boost::crc_32_type crc;
  crc.process_bytes(text.data(), size);
  return crc.checksum();
}

}  // namespace

void write_signature_file(const std::string& path, const SignatureBlock& block) {
  std::string out = kMagic;
  put(out, kVersion);
  put(out, static_cast<std::uint32_t>(block.rows));
  put(out, static_cast<std::uint32_t>(block.columns));
  put(out, static_cast<std::uint64_t>(block.size()));
  for (std::size_t i = 0; i < block.size(); ++i) {
    put(out, block.ids[i].value);
    out.append(block.cells_of(i), block.cells_of(i) + block.cell_count());
  }
  put(out, checksum(out, out.size()));
  write_whole_file(path, out);
}

SignatureBlock read_signature_file(const std::string& path) {
  const std::string in = read_whole_file(path);
  const auto require = [&](bool condition, const std::string& wrong) {
    if (!condition) throw std::runtime_error(path + ": " + wrong);
  };
  std::size_t at = kMagic.size();
  require(in.compare(0, at, kMagic) == 0, "no file of signatures");
  constexpr std::size_t kHead = 3 * sizeof(std::uint32_t) + sizeof(std::uint64_t);
  constexpr std::size_t kTail = sizeof(std::uint32_t);
  require(in.size() >= at + kHead + kTail, "ends too early");
  std::size_t tail = in.size() - kTail;
  const auto version = take<std::uint32_t>(in, at);
  require(version == kVersion,
          "version " + std::to_string(version) + " is not known, only " + std::to_string(kVersion));
  const std::uint32_t sum = checksum(in, tail);
  require(sum == take<std::uint32_t>(in, tail), "damaged: the checksum does not fit");

  SignatureBlock block;
  Signature signature;
  signature.rows = block.rows = static_cast<int>(take<std::uint32_t>(in, at));
  signature.columns = block.columns = static_cast<int>(take<std::uint32_t>(in, at));
  const auto count = take<std::uint64_t>(in, at);
  constexpr int kMost = 100000;
  require(block.rows > 0 && block.rows <= 64 && block.columns > 0 && block.columns <= kMost &&
              count <= in.size(),
          "no signatures of such a shape");
  const std::size_t size = block.cell_count();
  require(in.size() - at - kTail == count * (sizeof(std::uint64_t) + size), "ends too early");
  for (std::uint64_t i = 0; i < count; ++i) {
    const KeyframeId id{take<std::uint64_t>(in, at)};
    signature.cells.assign(in.begin() + static_cast<std::ptrdiff_t>(at),
                           in.begin() + static_cast<std::ptrdiff_t>(at + size));
    at += size;
    block.add(id, signature);
  }
  return block;
}

}  // namespace falko_slam
