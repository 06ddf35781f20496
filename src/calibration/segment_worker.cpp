// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment_worker.hpp"

#include <iterator>
#include <utility>

namespace falko_slam {
namespace {

void append(std::vector<RecordedSegment> from, std::vector<RecordedSegment>& to) {
  std::move(from.begin(), from.end(), std::back_inserter(to));
}

}  // namespace

SegmentWorker::SegmentWorker(const SegmentRecorderParams& params)
    : recorder_(params), thread_([this] { work(); }) {}

SegmentWorker::~SegmentWorker() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void SegmentWorker::put(Input input) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    inputs_.push_back(std::move(input));
  }
  changed_.notify_all();
}

void SegmentWorker::work() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return stop_ || !inputs_.empty(); });
    if (stop_) return;
    const Input input = std::move(inputs_.front());
    inputs_.pop_front();
    busy_ = true;
    lock.unlock();
    std::visit([this](const auto& value) { recorder_.add(value); }, input);
    lock.lock();
    append(recorder_.take(), done_);
    busy_ = false;
    changed_.notify_all();
  }
}

void SegmentWorker::catch_up() {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [this] { return inputs_.empty() && !busy_; });
}

void SegmentWorker::finish() {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [this] { return inputs_.empty() && !busy_; });
  recorder_.finish();
  append(recorder_.take(), done_);
}

std::vector<RecordedSegment> SegmentWorker::take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(done_, {});
}

}  // namespace falko_slam
