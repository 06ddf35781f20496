// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdlib.h>

#include <boost/iostreams/device/file.hpp>
#include <boost/iostreams/filter/bzip2.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <fstream>
#include <stdexcept>
#include <string>

namespace falko_slam {
namespace test {

/// A folder of its own for one test, gone afterwards.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    char name[] = "/tmp/falko_slam_test_XXXXXX";
    if (mkdtemp(name) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~TemporaryFolder() { std::system(("rm -rf " + path_).c_str()); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string file(const std::string& name) const { return path_ + "/" + name; }

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
