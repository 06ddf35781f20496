// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_filter.hpp"
#include "node_constants.hpp"
#include "steady_now.hpp"

#include <boost/make_shared.hpp>
#include <utility>

namespace falko_slam {
namespace {

constexpr double kAftermath = 10.0;  // of a jump of time [s]

class QueuedAction : public ros::CallbackInterface {
 public:
  explicit QueuedAction(std::function<void()> action) : action_(std::move(action)) {}
  CallResult call() override {
    action_();
    return Success;
  }

 private:
  std::function<void()> action_;
};

}  // namespace

ScanFilter::ScanFilter(const ros::NodeHandle& node, const std::string& odom_frame,
                       const std::string& base_frame, std::uint32_t waiting, Listener listener)
    : listener_(std::move(listener)), poses_(buffer_, odom_frame, base_frame) {
  ros::NodeHandle of_transforms(node);
  of_transforms.setCallbackQueue(&queue_);
  transforms_ = std::make_unique<tf2_ros::TransformListener>(buffer_, of_transforms, false);
  filter_ = std::make_unique<Filter>(buffer_, "", waiting, node);
  filter_->setTargetFrames(poses_.frames());
  filter_->registerCallback(boost::function<void(const Message&)>(
      [this](const Message& message) { listener_.placed(message); }));
  filter_->registerFailureCallback(
      [this](const Message& message, auto /*reason*/) { on_dropped(message); });
  thread_.start();
}

ScanFilter::~ScanFilter() {
  // Nothing may come in while members go.
  thread_.stop();
  transforms_.reset();
  filter_.reset();
}

void ScanFilter::in_transform_thread(std::function<void()> action) {
  queue_.addCallback(boost::make_shared<QueuedAction>(std::move(action)));
}

void ScanFilter::add(const Message& message) {
  last_frame_ = message->header.frame_id;
  in_transform_thread([this, message] { filter_->add(message); });
}

double ScanFilter::watch_time() {
  const ros::Time now = ros::Time::now();
  const double back = last_time_.toSec() - now.toSec();
  last_time_ = now;
  const bool jumped = back > to_seconds(kClockTolerance);
  if (jumped) {
    jumped_ = steady_now();
    in_transform_thread([this] { filter_->clear(); });
  }
  forget_the_future();
  return jumped ? back : 0.0;
}

void ScanFilter::forget_the_future() {
  if (steady_now() - jumped_ > kAftermath) return;
  const auto newest = poses_.newest(last_frame_);
  if (newest && *newest > ros::Time::now() + ros::Duration(to_seconds(kClockTolerance)))
    buffer_.clear();
}

void ScanFilter::on_dropped(const Message& message) {
  const std::string laser = tf_frame(message->header.frame_id);
  std::string missing = laser.empty() ? "it names no frame" : "";
  for (const std::string& frame : poses_.frames()) {
    std::string reason;
    if (!missing.empty() || buffer_.canTransform(frame, laser, message->header.stamp, &reason)) {
      continue;
    }
    missing.append("no transform from ").append(laser).append(" to ").append(frame);
    missing.append(" at its stamp: ").append(reason);
  }
  forget_the_future();
  listener_.dropped(message, missing.empty() ? "the transform came too late" : missing);
}

}  // namespace falko_slam
