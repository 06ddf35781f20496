// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <optional>
#include <string>
#include <vector>

namespace falko_slam {

/// A nodelet that a manager is to hold.
struct ManagedNodelet {
  std::string name;  ///< resolved
  std::string type;  ///< falko_slam/PoseGraph
};

/// Loads nodelets into a manager by its services, with the topics remapped as they are for us. They
/// stay when we end: whoever watches them next finds them by `loaded()`.
///
/// To be called from a thread that the manager does not need for its services.
class ManagerClient {
 public:
  /// `topics`: names that the nodelets use and that may be remapped.
  ManagerClient(const ros::NodeHandle& node, const std::string& manager,
                const std::vector<std::string>& topics);

  const std::string& manager() const { return manager_; }
  /// Names of all that it holds; nothing if it does not answer.
  std::optional<std::vector<std::string>> loaded() const;
  /// Throw std::runtime_error with the reason.
  void load(const ManagedNodelet& nodelet) const;
  void unload(const std::string& name) const;

 private:
  template <class Service>
  bool call(const char* service, Service& message) const;

  std::string manager_;
  std::vector<std::string> from_, to_;
};

}  // namespace falko_slam
