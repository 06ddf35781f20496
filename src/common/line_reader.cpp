// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/line_reader.hpp"

#include <boost/iostreams/device/file.hpp>
#include <boost/iostreams/filter/bzip2.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <streambuf>

namespace falko_slam {
namespace {

// A kilobyte can unpack to a line that fills the memory. The scans of no scanner come near this.
constexpr std::size_t kLongest = std::size_t{1} << 24U;

// Up to the end of the line, or one byte more than the longest; false at the end of the file.
bool read_line(std::streambuf& in, std::string& line) {
  constexpr auto kEnd = std::streambuf::traits_type::eof();
  line.clear();
  for (auto letter = in.sbumpc(); letter != kEnd; letter = in.sbumpc()) {
    if (letter == '\n') return true;
    line.push_back(static_cast<char>(letter));
    if (line.size() > kLongest) return true;
  }
  return false;
}

std::unique_ptr<std::istream> open_compressed(const std::string& path) {
  namespace io = boost::iostreams;
  // A folder opens like a file and fails at the first byte only.
  std::ifstream probe(path, std::ios::binary);
  if (!probe || (probe.peek() == std::ifstream::traits_type::eof() && probe.bad())) {
    throw std::runtime_error(path + ": cannot be read: " + std::strerror(errno));
  }
  const std::string ending = std::filesystem::path(path).extension().string();
  auto in = std::make_unique<io::filtering_istream>();
  if (ending == ".gz") in->push(io::gzip_decompressor());
  if (ending == ".bz2") in->push(io::bzip2_decompressor());
  in->push(io::file_source(path, std::ios::binary));
  in->exceptions(std::ios::badbit);
  return in;
}

}  // namespace

LineReader::LineReader(const std::string& path) : path_(path), in_(open_compressed(path)) {}

bool LineReader::next(std::string& line) {
  bool whole = false;
  try {
    whole = read_line(*in_->rdbuf(), line);
  } catch (const std::exception& error) {
    throw std::runtime_error(path_ + ": damaged after line " + std::to_string(lines_) + ": " +
                             error.what());
  }
  if (!whole && line.empty()) return false;
  ++lines_;
  if (line.size() > kLongest) fail("is longer than " + std::to_string(kLongest) + " bytes");
  return true;
}

void LineReader::fail(const std::string& what) const {
  throw std::runtime_error(path_ + ": line " + std::to_string(lines_) + ": " + what);
}

}  // namespace falko_slam
