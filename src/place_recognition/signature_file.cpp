// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "signature_file.hpp"

#include <stdexcept>

#include "falko_slam/common/bytes.hpp"
#include "falko_slam/common/whole_file.hpp"

namespace falko_slam {
namespace {

const std::string kMagic = "FALKOSIG";
constexpr std::uint32_t kVersion = 1;

}  // namespace

void write_signature_file(const std::string& path, const SignatureBlock& block) {
  ByteWriter out;
  out.text(kMagic);
  out.u32(kVersion);
  out.u32(static_cast<std::uint32_t>(block.rows));
  out.u32(static_cast<std::uint32_t>(block.columns));
  out.u64(block.size());
  for (std::size_t i = 0; i < block.size(); ++i) {
    out.u64(block.ids[i].value);
    out.text(std::string(block.cells_of(i), block.cells_of(i) + block.cell_count()));
  }
  out.u32(checksum(out.bytes(), out.bytes().size()));
  write_whole_file(path, out.bytes());
}

SignatureBlock read_signature_file(const std::string& path) {
  const std::string bytes = read_whole_file(path);
  const auto require = [&](bool condition, const std::string& wrong) {
    if (!condition) throw std::runtime_error(path + ": " + wrong);
  };
  require(bytes.compare(0, kMagic.size(), kMagic) == 0, "no file of signatures");
  constexpr std::size_t kHead = 3 * sizeof(std::uint32_t) + sizeof(std::uint64_t);
  constexpr std::size_t kTail = sizeof(std::uint32_t);
  require(bytes.size() >= kMagic.size() + kHead + kTail, "ends too early");
  const std::size_t tail = bytes.size() - kTail;
  ByteReader in(bytes, kMagic.size(), tail);
  const std::uint32_t version = in.u32();
  require(version == kVersion,
          "version " + std::to_string(version) + " is not known, only " + std::to_string(kVersion));
  require(ByteReader(bytes, tail, bytes.size()).u32() == checksum(bytes, tail),
          "damaged: the checksum does not fit");

  SignatureBlock block;
  Signature signature;
  signature.rows = block.rows = static_cast<int>(in.u32());
  signature.columns = block.columns = static_cast<int>(in.u32());
  const std::uint64_t count = in.u64();
  constexpr int kMost = 100000;
  require(block.rows > 0 && block.rows <= 64 && block.columns > 0 && block.columns <= kMost &&
              count <= bytes.size(),
          "no signatures of such a shape");
  const std::size_t size = block.cell_count();
  require(in.left() == count * (sizeof(std::uint64_t) + size), "ends too early");
  for (std::uint64_t i = 0; i < count; ++i) {
    const KeyframeId id{in.u64()};
    const std::string cells = in.text(size);
    signature.cells.assign(cells.begin(), cells.end());
    block.add(id, signature);
  }
  return block;
}

}  // namespace falko_slam
