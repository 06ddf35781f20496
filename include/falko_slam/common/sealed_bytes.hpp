// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "falko_slam/common/bytes.hpp"

namespace falko_slam {

/// A kind of binary file: 8 letters, u32 version, content, u32 CRC-32 of all before it; numbers
/// little-endian.
struct FileKind {
  std::string letters;    ///< 8 of them
  std::uint32_t version;  ///< the only one that is read
  std::string content;    ///< for messages, such as "keyframes"
};

/// Write the content to it, then seal it.
ByteWriter begin_sealed(const FileKind& kind);
std::string seal(ByteWriter&& out);

/// The content of sealed bytes, which are borrowed. Throws std::runtime_error with what is wrong:
/// letters, length, version or checksum.
ByteReader open_sealed(const std::string& bytes, const FileKind& kind);
/// Throws std::runtime_error with what is wrong unless the condition holds.
void require_sound(bool condition, const std::string& wrong);
/// Throws std::runtime_error if not all of the content was read.
void require_end(const ByteReader& in);

/// Writes whole or not at all. Throws std::runtime_error that names the file, also if it is there
/// and not of this kind.
void write_sealed_file(const std::string& path, const std::string& bytes, const FileKind& kind);

}  // namespace falko_slam
