// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "signature_tree.hpp"

namespace falko_slam {

// Layout, numbers little-endian: "FALKOSIG", u32 version, u32 rows, u32 columns, u64 count; for
// each signature u64 id and its cells; u32 CRC-32 of all before it.

void write_signature_file(const std::string& path, const SignatureBlock& block);

/// Throws std::runtime_error that names the file and what is wrong with it.
SignatureBlock read_signature_file(const std::string& path);

}  // namespace falko_slam
