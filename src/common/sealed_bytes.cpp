// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/sealed_bytes.hpp"

#include <fstream>
#include <stdexcept>

#include "falko_slam/common/whole_file.hpp"

namespace falko_slam {
namespace {

constexpr std::size_t kTail = sizeof(std::uint32_t);

}  // namespace

void require_sound(bool condition, const std::string& wrong) {
  if (!condition) throw std::runtime_error(wrong);
}

ByteWriter begin_sealed(const FileKind& kind) {
  ByteWriter out;
  out.text(kind.letters);
  out.u32(kind.version);
  return out;
}

std::string seal(ByteWriter&& out) {
  out.u32(checksum(out.bytes(), out.bytes().size()));
  return std::move(out).bytes();
}

ByteReader open_sealed(const std::string& bytes, const FileKind& kind) {
  require_sound(bytes.compare(0, kind.letters.size(), kind.letters) == 0,
                "no file of " + kind.content);
  require_sound(bytes.size() >= kind.letters.size() + sizeof(std::uint32_t) + kTail,
                "ends too early");
  const std::size_t tail = bytes.size() - kTail;
  ByteReader in(bytes, kind.letters.size(), tail);
  const std::uint32_t version = in.u32();
  require_sound(version == kind.version, "version " + std::to_string(version) +
                                             " is not known, only " + std::to_string(kind.version));
  require_sound(ByteReader(bytes, tail, bytes.size()).u32() == checksum(bytes, tail),
                "damaged or cut short: the checksum does not fit");
  return in;
}

void require_end(const ByteReader& in) {
  require_sound(in.left() == 0, "has " + std::to_string(in.left()) + " bytes too many");
}

void write_sealed_file(const std::string& path, const std::string& bytes, const FileKind& kind) {
  std::ifstream file(path, std::ios::binary);
  if (file.is_open()) {
    std::string begin(kind.letters.size(), '\0');
    file.read(&begin[0], static_cast<std::streamsize>(begin.size()));
    if (begin != kind.letters) {
      throw std::runtime_error(path + ": is there and no file of " + kind.content +
                               ", not overwritten");
    }
  }
  write_whole_file(path, bytes);
}

}  // namespace falko_slam
