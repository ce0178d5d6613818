// SPDX-License-Identifier: Apache-2.0
#include "ddgi/surfel_marks.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace plumbline::ddgi {

void SurfelMarks::join(std::size_t probe) {
    const std::span<const std::uint8_t> rays = rays_of(probe);
    probe_marks_[probe] =
        std::reduce(rays.begin(), rays.end(), std::uint8_t{0}, std::bit_or<std::uint8_t>());
}

void SurfelMarks::join() {
    for_probes(probes(), [&](std::size_t probe) {
        if (probe_marks_[probe] != 0) join(probe);
    });
}

void SurfelMarks::set_all() {
    std::ranges::fill(marks_, all_marks);
    std::ranges::fill(probe_marks_, all_marks);
}

void SurfelMarks::clear() {
    for_probes(probes(), [&](std::size_t probe) {
        if (probe_marks_[probe] == 0) return;
        std::ranges::fill(rays_of(probe), std::uint8_t{0});
        probe_marks_[probe] = 0;
    });
}

}  // namespace plumbline::ddgi
