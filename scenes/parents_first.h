// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "scenes/scene.h"

namespace plumbline {

/// How put_parents_first went.
struct ParentsFirst {
    std::vector<std::size_t> from;        ///< for each place, where its object stood before
    std::optional<std::size_t> in_cycle;  ///< an object that is its own ancestor; nothing was moved
};

/// Moves every object that stands before its parent behind it, and keeps all others in order.
/// Linear in the number of objects. Parents must be valid indices or -1.
ParentsFirst put_parents_first(std::vector<Object>& objects);

}  // namespace plumbline
