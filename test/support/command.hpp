// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace test {

struct CommandResult {
  int exit_code = 0;  ///< 128 and the signal's number if one ended it, as shells have it
  std::string output;
  std::string errors;

  bool says(const std::string& text) const { return output.find(text) != std::string::npos; }
  bool complains(const std::string& text) const { return errors.find(text) != std::string::npos; }
  auto error_lines() const { return std::count(errors.begin(), errors.end(), '\n'); }
};

inline std::string whole_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Runs a program, without a shell, until it ends.
inline CommandResult run(std::vector<std::string> words) {
  const TemporaryFolder folder;
  const std::string output = folder.file("output");
  const std::string errors = folder.file("errors");
  constexpr int kCreate = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output.c_str(), kCreate, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, errors.c_str(), kCreate, 0600);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int failed =
      posix_spawn(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) throw std::runtime_error(words[0] + " cannot be started");
  int status = 0;
  if (waitpid(child, &status, 0) != child) throw std::runtime_error(words[0] + " got lost");
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), whole_file(output),
          whole_file(errors)};
}

/// Runs our command line with these words.
inline CommandResult falko(std::vector<std::string> words) {
  words.insert(words.begin(), FALKO_SLAM_COMMAND);
  return run(std::move(words));
}

}  // namespace test
}  // namespace falko_slam
