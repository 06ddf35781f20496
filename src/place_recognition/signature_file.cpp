// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "signature_file.hpp"

#include <stdexcept>
#include <utility>

#include "falko_slam/common/sealed_bytes.hpp"
#include "falko_slam/common/whole_file.hpp"

namespace falko_slam {
namespace {

const FileKind kSignatures{"FALKOSIG", 1, "signatures"};

SignatureBlock block_from(const std::string& bytes) {
  const auto require = [](bool condition, const char* wrong) {
    if (!condition) throw std::runtime_error(wrong);
  };
  ByteReader in = open_sealed(bytes, kSignatures);
  require(in.left() >= 2 * sizeof(std::uint32_t) + sizeof(std::uint64_t), "ends too early");
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

}  // namespace

void write_signature_file(const std::string& path, const SignatureBlock& block) {
  ByteWriter out = begin_sealed(kSignatures);
  out.u32(static_cast<std::uint32_t>(block.rows));
  out.u32(static_cast<std::uint32_t>(block.columns));
  out.u64(block.size());
  for (std::size_t i = 0; i < block.size(); ++i) {
    out.u64(block.ids[i].value);
    out.text(std::string(block.cells_of(i), block.cells_of(i) + block.cell_count()));
  }
  write_sealed_file(path, seal(std::move(out)), kSignatures);
}

SignatureBlock read_signature_file(const std::string& path) {
  try {
    return block_from(read_whole_file(path));
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace falko_slam
