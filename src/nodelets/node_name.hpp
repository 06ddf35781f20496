// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace falko_slam {

/// Of the program: the node's name, unless it is given another, and the nodelet that it runs.
extern const char* const kNodeName;
extern const char* const kNodeletType;

}  // namespace falko_slam
