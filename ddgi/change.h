// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

namespace plumbline::ddgi {

/// How much an update changed the probes.
struct Change {
    /// Largest over probes of max |next - previous| / max |next|, both over the probe's values.
    /// Infinite if a value is not finite.
    double relative = 0;
    bool none = true;  ///< no value changed
};

/// Compares two states of all probes, `per_probe` values each.
///
/// A probe darker than 1e-6 of the brightest is measured against that: light that left goes on
/// fading by the same ratio, and nobody would see it.
Change change_between(std::span<const float> previous, std::span<const float> next,
                      std::size_t per_probe);

}  // namespace plumbline::ddgi
