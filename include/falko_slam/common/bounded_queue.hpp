// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

namespace falko_slam {

/// Between a thread that must not wait and one that works: when it is full, the oldest goes.
template <class Item>
class BoundedQueue {
 public:
  explicit BoundedQueue(std::size_t capacity) : capacity_(capacity) {}

  /// False if an older one had to go for it.
  bool push(Item item) {
    bool room = true;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      items_.push_back(std::move(item));
      if (items_.size() > capacity_) {
        items_.pop_front();
        room = false;
      }
    }
    filled_.notify_one();
    return room;
  }

  /// Waits for one. Empty after close().
  std::optional<Item> pop() {
    std::unique_lock<std::mutex> lock(mutex_);
    filled_.wait(lock, [this] { return closed_ || !items_.empty(); });
    if (closed_) return std::nullopt;
    std::optional<Item> item(std::move(items_.front()));
    items_.pop_front();
    return item;
  }

  void clear() {
    const std::lock_guard<std::mutex> lock(mutex_);
    items_.clear();
  }
  void close() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      closed_ = true;
    }
    filled_.notify_all();
  }
  std::size_t size() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return items_.size();
  }

 private:
  const std::size_t capacity_;
  mutable std::mutex mutex_;
  std::condition_variable filled_;
  std::deque<Item> items_;
  bool closed_ = false;
};

}  // namespace falko_slam
