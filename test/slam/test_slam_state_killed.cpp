// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A process that is killed while it saves: the old state or the new one is there, whole.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <set>

#include "falko_slam/common/whole_file.hpp"
#include "falko_slam/slam/slam_state_file.hpp"
#include "support/slam_states.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

// Saves one state after the other until it is killed. It has begun when this returns.
pid_t start_saving(const std::string& path, const SlamState& a, const SlamState& b) {
  int ends[2];
  if (::pipe(ends) != 0) return -1;
  const pid_t child = ::fork();
  if (child != 0) {
    char byte = 0;
    const bool begun = ::close(ends[1]) == 0 && ::read(ends[0], &byte, 1) == 1;
    ::close(ends[0]);
    return begun ? child : -1;
  }
  try {
    if (::write(ends[1], "x", 1) != 1) ::_exit(1);
    for (;;) {
      save_slam_state(path, a);
      save_slam_state(path, b);
    }
  } catch (...) {
    ::_exit(1);
  }
}

TEST(SlamStateFileOfAKilledProcess, IsTheOldOneOrTheNewOne) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("state.map");
  const SlamState a = test::office_state(3.0, 1, 720);
  const SlamState b = test::office_state(4.0, 2, 720);
  const std::set<std::string> whole = {to_bytes(a), to_bytes(b)};
  ASSERT_EQ(whole.size(), 2U);
  const auto begin = std::chrono::steady_clock::now();
  for (const SlamState* state : {&b, &a}) save_slam_state(path, *state);
  const std::chrono::duration<double, std::micro> period = std::chrono::steady_clock::now() - begin;
  auto random = test::seeded_random();
  std::size_t with_litter = 0;
  for (int run = 0; run < 200; ++run) {
    const pid_t child = start_saving(path, a, b);
    ASSERT_GT(child, 0);
    ::usleep(static_cast<useconds_t>(test::uniform(random, 0.0, 2.0 * period.count())));
    ASSERT_EQ(::kill(child, SIGKILL), 0);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) << "saving failed";
    ASSERT_EQ(whole.count(read_whole_file(path)), 1U) << run;
    ASSERT_NO_THROW(load_slam_state(path)) << run;
    with_litter += folder.names().size() > 1 ? 1U : 0U;
  }
  EXPECT_GT(with_litter, 10U);  // so many were killed in the middle
  save_slam_state(path, a);
  EXPECT_EQ(folder.names(), std::set<std::string>{"state.map"});
}

}  // namespace
}  // namespace falko_slam
