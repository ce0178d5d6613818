// SPDX-License-Identifier: Apache-2.0
#include "ddgi/surfel_cells.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>

namespace plumbline::ddgi {
namespace {

/// Of a normal's components from 0 to 1. Axes and diagonals are in the middle of theirs.
constexpr float normal_steps = 4.f;

constexpr std::uint32_t no_surfel = std::numeric_limits<std::uint32_t>::max();

/// A multiplicative hash of words, a step of it.
std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) {
    hash = (hash ^ word) * 0x9e3779b97f4a7c15u;
    return hash ^ hash >> 32;
}

}  // namespace

/// Places are kept as whole numbers in doubles: however small the cells, none overflows.
struct SurfelCells::Cell {
    glm::dvec3 place;
    glm::ivec3 facing;

    bool operator==(const Cell&) const = default;

    std::uint64_t hash() const {
        std::uint64_t hash = 0;
        for (int axis = 0; axis < 3; ++axis) {
            hash = mixed(hash, std::bit_cast<std::uint64_t>(place[axis]));
            hash = mixed(hash, static_cast<std::uint64_t>(facing[axis]));
        }
        return hash;
    }
};

SurfelCells::SurfelCells(double width, std::size_t surfels)
    : width_(width), members_(std::bit_ceil(surfels + surfels / 2)), nearest_(members_.size()) {}

SurfelCells::Cell SurfelCells::cell_of(const Surfels& surfels, std::size_t surfel) const {
    // Adding 0 turns -0, which is the same cell as 0, into it.
    return {glm::floor(glm::dvec3(surfels.place[surfel].position) / width_) + 0.,
            glm::ivec3(glm::round(normal_steps * surfels.place[surfel].n))};
}

/// The slot of the surfel's cell in the table; enters the cell if it is not there yet.
std::uint32_t SurfelCells::slot_of(const Surfels& surfels, std::uint32_t surfel) {
    const Cell cell = cell_of(surfels, surfel);
    const std::size_t mask = members_.size() - 1;
    for (std::size_t slot = cell.hash() & mask;; slot = (slot + 1) & mask) {
        std::atomic_ref<std::uint32_t> member(members_[slot]);
        std::uint32_t other = no_surfel;
        if (member.compare_exchange_strong(other, surfel) || cell_of(surfels, other) == cell)
            return static_cast<std::uint32_t>(slot);
    }
}

std::uint64_t SurfelCells::group(Surfels& surfels) {
    std::ranges::fill(members_, no_surfel);
    std::ranges::fill(nearest_, std::numeric_limits<std::uint64_t>::max());
    const tbb::blocked_range<std::size_t> all(0, surfels.size());
    tbb::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            if (!surfels.hit(i)) continue;
            const std::uint32_t slot = slot_of(surfels, static_cast<std::uint32_t>(i));
            const glm::dvec3 place = glm::dvec3(surfels.place[i].position) / width_;
            const glm::dvec3 off_middle = place - glm::floor(place) - .5;
            const auto distance2 = static_cast<float>(glm::dot(off_middle, off_middle));
            // Bits of floats that are not negative are ordered as they are.
            const std::uint64_t mine =
                std::uint64_t{std::bit_cast<std::uint32_t>(distance2)} << 32 | i;
            std::atomic_ref<std::uint64_t> nearest(nearest_[slot]);
            std::uint64_t other = nearest.load();
            while (mine < other && !nearest.compare_exchange_weak(other, mine)) {
            }
            surfels.source[i] = slot;
        }
    });
    return tbb::parallel_reduce(
        all, std::uint64_t{0},
        [&](const tbb::blocked_range<std::size_t>& range, std::uint64_t own) {
            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                if (!surfels.hit(i)) continue;
                surfels.source[i] = static_cast<std::uint32_t>(nearest_[surfels.source[i]]);
                own += surfels.source[i] == i ? 1 : 0;
            }
            return own;
        },
        std::plus<>());
}

}  // namespace plumbline::ddgi
