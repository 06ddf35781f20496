// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

namespace falko_slam {

/// Does work(i) once for each i below `count`, on so many threads, in no certain order; one thread
/// is the caller's. What work throws first is thrown again when all threads have ended; what was
/// not begun by then is left undone.
void do_in_parallel(std::size_t count, std::size_t threads,
                    const std::function<void(std::size_t)>& work);

}  // namespace falko_slam
