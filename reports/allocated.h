// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace plumbline::reports {

/// Bytes that this process holds from malloc and new at this moment, over all threads, as
/// mallinfo2 of glibc tells. What a library maps by itself is not in it.
std::size_t allocated_bytes();

}  // namespace plumbline::reports
