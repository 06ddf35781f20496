// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "packed_bag.hpp"

#include <unistd.h>

#include <boost/iostreams/copy.hpp>
#include <boost/iostreams/device/file.hpp>
#include <boost/iostreams/device/file_descriptor.hpp>
#include <boost/iostreams/filter/bzip2.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace falko_slam {
namespace {

namespace io = boost::iostreams;

bool ends_with(const std::string& text, const std::string& ending) {
  return text.size() > ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

// A new file's name and descriptor.
std::pair<std::string, int> temporary_file() {
  std::string name = (std::filesystem::temp_directory_path() / "falko_slam_XXXXXX.bag").string();
  const int descriptor = ::mkstemps(name.data(), 4);
  if (descriptor < 0) throw std::runtime_error(name + ": " + std::strerror(errno));
  return {name, descriptor};
}

}  // namespace

bool is_packed_bag(const std::string& path) {
  return ends_with(path, ".bag.gz") || ends_with(path, ".bag.bz2");
}

UnpackedBag::UnpackedBag(const std::string& packed) {
  errno = 0;
  std::ifstream probe(packed, std::ios::binary);  // a folder opens, but gives no byte
  if (!probe || (probe.peek() == std::ifstream::traits_type::eof() && probe.bad())) {
    throw std::runtime_error(packed + ": cannot be read: " + std::strerror(errno));
  }
  const auto [name, descriptor] = temporary_file();
  path_ = name;
  try {
    io::filtering_istream in;
    if (ends_with(packed, ".gz")) {
      in.push(io::gzip_decompressor());
    } else {
      in.push(io::bzip2_decompressor());
    }
    in.push(io::file_source(packed, std::ios::binary));
    io::copy(in, io::file_descriptor_sink(descriptor, io::close_handle));
  } catch (const std::exception& error) {
    std::remove(path_.c_str());
    throw std::runtime_error(packed + ": cannot be unpacked: " + error.what());
  }
}

UnpackedBag::~UnpackedBag() { std::remove(path_.c_str()); }

}  // namespace falko_slam
