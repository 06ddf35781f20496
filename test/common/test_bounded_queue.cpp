// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/bounded_queue.hpp"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace falko_slam {
namespace {

TEST(BoundedQueue, KeepsTheOrder) {
  BoundedQueue<int> queue(3);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(queue.push(i));
  for (int i = 0; i < 3; ++i) EXPECT_EQ(queue.pop(), i);
  EXPECT_EQ(queue.size(), 0U);
}

TEST(BoundedQueue, LetsTheOldestGoAndSaysSo) {
  BoundedQueue<int> queue(2);
  queue.push(1);
  queue.push(2);
  EXPECT_FALSE(queue.push(3));
  EXPECT_EQ(queue.pop(), 2);
  EXPECT_EQ(queue.pop(), 3);
}

TEST(BoundedQueue, CanBeCleared) {
  BoundedQueue<int> queue(2);
  queue.push(1);
  queue.clear();
  queue.push(2);
  EXPECT_EQ(queue.pop(), 2);
}

TEST(BoundedQueue, WakesWhoWaitsWithAnItemAndWithItsEnd) {
  BoundedQueue<int> queue(100);
  std::vector<int> taken;
  std::thread taker([&] {
    while (const auto item = queue.pop()) taken.push_back(*item);
  });
  for (int i = 0; i < 50; ++i) queue.push(i);
  while (queue.size() > 0) std::this_thread::yield();
  queue.close();
  taker.join();
  EXPECT_EQ(taken.size(), 50U);
  EXPECT_FALSE(queue.pop());
}

}  // namespace
}  // namespace falko_slam
