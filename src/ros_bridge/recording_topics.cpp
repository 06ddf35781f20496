// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "recording_topics.hpp"

#include <rosbag/view.h>

#include <set>
#include <stdexcept>
#include <vector>

namespace falko_slam {
namespace {

std::string joined(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

}  // namespace

bool is_bag(const std::string& path) {
  const std::string ending = ".bag";
  return path.size() > ending.size() &&
         path.compare(path.size() - ending.size(), ending.size(), ending) == 0;
}

std::string scan_topic(const rosbag::Bag& bag, const std::string& path, const std::string& wanted) {
  std::set<std::string> scans;
  std::set<std::string> all;
  for (const auto& [topic, type] : topic_types(bag)) {
    all.insert(topic);
    if (type == kScanType) scans.insert(topic);
  }
  if (wanted.empty() && scans.size() == 1) return *scans.begin();
  for (const std::string& name : {wanted, "/" + wanted}) {
    if (scans.count(name) > 0) return name;
  }
  throw std::runtime_error(path + ": " +
                           (wanted.empty() ? "which scans? " : "no LaserScan on " + wanted + ". ") +
                           "LaserScan topics: " + joined(scans) + "; all topics: " + joined(all));
}

std::map<std::string, std::string> topic_types(const rosbag::Bag& bag) {
  std::map<std::string, std::string> types;
  rosbag::View view(bag);
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
    types[connection->topic] = connection->datatype;
  }
  return types;
}

std::string describe(const std::map<std::string, std::string>& types) {
  std::string text;
  for (const auto& [topic, type] : types) {
    text.append(text.empty() ? "" : ", ").append(topic).append(" (").append(type).append(")");
  }
  return text.empty() ? "no topics" : text;
}

bool is_wanted(const std::string& topic, const std::string& wanted) {
  return wanted.empty() || topic == wanted || topic == "/" + wanted;
}

std::string topic_of_type(const rosbag::Bag& bag, const std::string& path, const std::string& type,
                          const std::string& wanted) {
  const auto types = topic_types(bag);
  std::vector<std::string> found;
  for (const auto& [topic, its_type] : types) {
    if (its_type == type && is_wanted(topic, wanted)) found.push_back(topic);
  }
  if (found.size() == 1) return found.front();
  throw std::runtime_error(path + ": " + (found.empty() ? "no " : "which ") + type +
                           (wanted.empty() ? "" : " on " + wanted) + ": the bag has " +
                           describe(types));
}

}  // namespace falko_slam
