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

void SurfelMarks::find(std::size_t first, std::size_t last, Mark::Bit mark,
                       std::vector<std::size_t>& surfels) const {
    surfels.clear();
    for (std::size_t probe = first; probe < last; ++probe) {
        for_rays(probe, mark, [&](std::size_t surfel) { surfels.push_back(surfel); });
    }
}

std::size_t SurfelMarks::count(std::size_t probe) const {
    const auto first = marks_.begin() + static_cast<std::ptrdiff_t>(probe * per_probe_);
    return per_probe_ - static_cast<std::size_t>(
                            std::count(first, first + static_cast<std::ptrdiff_t>(per_probe_), 0));
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
