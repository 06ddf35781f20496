// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdlib.h>

#include <boost/iostreams/device/file.hpp>
#include <boost/iostreams/filter/bzip2.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string>

namespace falko_slam {
namespace test {

/// A folder of its own for one test, gone afterwards.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(const std::string& parent = "/tmp")
      : path_(parent + "/falko_slam_test_XXXXXX") {
    if (mkdtemp(path_.data()) == nullptr) throw std::runtime_error("no temporary folder");
  }
  ~TemporaryFolder() { std::system(("rm -rf " + path_).c_str()); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::string& path() const { return path_; }
  std::string file(const std::string& name) const { return path_ + "/" + name; }

  /// The names of all that is in it.
  std::set<std::string> names() const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) {
      names.insert(entry.path().filename().string());
    }
    return names;
  }

  /// Writes the text, packed if the name ends in .gz or .bz2, and returns the file's path.
  std::string write(const std::string& name, const std::string& text) const {
    namespace io = boost::iostreams;
    io::filtering_ostream out;
    if (name.size() > 3 && name.substr(name.size() - 3) == ".gz") out.push(io::gzip_compressor());
    if (name.size() > 4 && name.substr(name.size() - 4) == ".bz2") out.push(io::bzip2_compressor());
    out.push(io::file_sink(file(name), std::ios::binary));
    out << text;
    return file(name);
  }

 private:
  std::string path_;
};

}  // namespace test
}  // namespace falko_slam
