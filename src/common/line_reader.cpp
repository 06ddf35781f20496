// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/line_reader.hpp"

#include <boost/iostreams/device/file.hpp>
#include <boost/iostreams/filter/bzip2.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace falko_slam {
namespace {

bool ends_with(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

std::unique_ptr<std::istream> open_compressed(const std::string& path) {
  namespace io = boost::iostreams;
  // A folder opens like a file and fails at the first byte only.
  std::ifstream probe(path, std::ios::binary);
  if (!probe || (probe.peek() == std::ifstream::traits_type::eof() && probe.bad())) {
    throw std::runtime_error(path + ": cannot be read: " + std::strerror(errno));
  }
  auto in = std::make_unique<io::filtering_istream>();
  if (ends_with(path, ".gz")) in->push(io::gzip_decompressor());
  if (ends_with(path, ".bz2")) in->push(io::bzip2_decompressor());
  in->push(io::file_source(path, std::ios::binary));
  in->exceptions(std::ios::badbit);
  return in;
}

}  // namespace

LineReader::LineReader(const std::string& path) : path_(path), in_(open_compressed(path)) {}

bool LineReader::next(std::string& line) {
  try {
    if (!std::getline(*in_, line)) return false;
  } catch (const std::exception& error) {
    throw std::runtime_error(path_ + ": damaged after line " + std::to_string(lines_) + ": " +
                             error.what());
  }
  ++lines_;
  return true;
}

void LineReader::fail(const std::string& what) const {
  throw std::runtime_error(path_ + ": line " + std::to_string(lines_) + ": " + what);
}

}  // namespace falko_slam
