// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/whole_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace falko_slam {
namespace {

[[noreturn]] void fail(const std::string& path, const char* what) {
  throw std::runtime_error(path + ": " + what + ": " + std::strerror(errno));
}

bool write_all(int file, const std::string& content) {
  std::size_t written = 0;
  while (written < content.size()) {
    const ssize_t count = ::write(file, content.data() + written, content.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    written += static_cast<std::size_t>(count);
  }
  return ::fsync(file) == 0;
}

}  // namespace

void write_whole_file(const std::string& path, const std::string& content) {
  const std::string part = path + "." + std::to_string(::getpid()) + ".part";
  const int file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) fail(path, "cannot be written");
  const bool written = write_all(file, content);
  const int reason = errno;
  const bool closed = ::close(file) == 0;
  if (written && closed && std::rename(part.c_str(), path.c_str()) == 0) return;
  if (!written) errno = reason;
  const int last = errno;
  std::remove(part.c_str());
  errno = last;
  fail(path, "cannot be written");
}

std::string read_whole_file(const std::string& path) {
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  in.peek();
  if (!in.is_open() || in.bad()) fail(path, "cannot be read");
  if (in.eof()) return "";
  std::ostringstream content;
  if (!(content << in.rdbuf())) fail(path, "cannot be read");
  return content.str();
}

}  // namespace falko_slam
