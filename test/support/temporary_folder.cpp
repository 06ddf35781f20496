// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/temporary_folder.hpp"

#include <stdlib.h>

#include <boost/iostreams/device/file.hpp>
#include <boost/iostreams/filter/bzip2.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <filesystem>
#include <stdexcept>

namespace falko_slam {
namespace test {

TemporaryFolder::TemporaryFolder(const std::string& parent)
    : path_(parent + "/falko_slam_test_XXXXXX") {
  if (mkdtemp(path_.data()) == nullptr) throw std::runtime_error("no temporary folder");
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code error;
  std::filesystem::remove_all(path_, error);
}

std::set<std::string> TemporaryFolder::names() const {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path_)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

std::string TemporaryFolder::write(const std::string& name, const std::string& text) const {
  namespace io = boost::iostreams;
  const std::string extension = std::filesystem::path(name).extension().string();
  io::filtering_ostream out;
  if (extension == ".gz") out.push(io::gzip_compressor());
  if (extension == ".bz2") out.push(io::bzip2_compressor());
  out.push(io::file_sink(file(name), std::ios::binary));
  out << text;
  return file(name);
}

}  // namespace test
}  // namespace falko_slam
