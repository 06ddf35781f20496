// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "manager_client.hpp"

#include <nodelet/NodeletList.h>
#include <nodelet/NodeletLoad.h>
#include <nodelet/NodeletUnload.h>
#include <ros/names.h>
#include <ros/service.h>

#include <stdexcept>

namespace falko_slam {

ManagerClient::ManagerClient(const ros::NodeHandle& node, const std::string& manager,
                             const std::vector<std::string>& topics)
    : manager_(node.resolveName(manager)) {
  for (const std::string& topic : topics) {
    const std::string plain = ros::names::resolve(node.getNamespace(), topic, false);
    const std::string remapped = node.resolveName(topic);
    if (plain == remapped) continue;
    from_.push_back(plain);
    to_.push_back(remapped);
  }
}

// Asked first whether it is there: a manager that was killed keeps its services with the master.
template <class Service>
bool ManagerClient::call(const char* service, Service& message) const {
  const std::string name = manager_ + "/" + service;
  return ros::service::exists(name, false) && ros::service::call(name, message);
}

std::optional<std::vector<std::string>> ManagerClient::loaded() const {
  nodelet::NodeletList list;
  if (!call("list", list)) return {};
  return list.response.nodelets;
}

void ManagerClient::load(const ManagedNodelet& nodelet) const {
  nodelet::NodeletLoad load;
  load.request.name = nodelet.name;
  load.request.type = nodelet.type;
  load.request.remap_source_args = from_;
  load.request.remap_target_args = to_;
  if (call("load_nodelet", load) && load.response.success) return;
  throw std::runtime_error(nodelet.name + " could not be loaded: see the log of " + manager_);
}

void ManagerClient::unload(const std::string& name) const {
  nodelet::NodeletUnload unload;
  unload.request.name = name;
  if (call("unload_nodelet", unload) && unload.response.success) return;
  throw std::runtime_error(name + " could not be unloaded: see the log of " + manager_);
}

}  // namespace falko_slam
