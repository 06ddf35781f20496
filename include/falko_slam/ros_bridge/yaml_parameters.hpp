// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <XmlRpcValue.h>

#include <string>

namespace falko_slam {

/// The parameters of a YAML file as `rosparam load` would put them on the parameter server, without
/// one: groups, booleans, integers, numbers, else texts. Throws std::runtime_error that names the
/// file and the line; also for what is greater or deeper than parameters ever are.
XmlRpc::XmlRpcValue read_parameter_file(const std::string& path);

}  // namespace falko_slam
