// SPDX-License-Identifier: Apache-2.0
#include "ddgi/feedback_maps.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <bit>
#include <glm/gtc/constants.hpp>

#include "ddgi/float8.h"

namespace plumbline::ddgi {
namespace {

static_assert(map_nodes <= 64, "a word has a bit for each node");

/// Of the four nodes around a normal, from the first on.
constexpr std::array<std::size_t, 4> node_offsets = {0, 1, map_side, map_side + 1};
constexpr unsigned bits_a_corner = 3;
constexpr unsigned bits_of_count = 4;
constexpr std::uint32_t corner_mask = (1u << bits_a_corner) - 1u;
constexpr std::uint32_t count_mask = (1u << bits_of_count) - 1u;

std::uint64_t bit_of(std::uint8_t node) { return std::uint64_t{1} << node; }

}  // namespace

FeedbackMaps::FeedbackMaps(const ProbeGrid& grid)
    : asked_(probe_count(grid)), nodes_(new glm::vec4[asked_.size() * map_nodes]) {
    // The lowest cell's; a cell is never cut off at the border, only where the grid is one probe
    // thick.
    const ProbeNeighbours around = probe_neighbours(grid, grid.origin);
    for (std::size_t k = 0; k < around.probe.size(); ++k) {
        corner_offsets_[k] = around.probe[k] - around.probe[0];
    }
}

MapGather FeedbackMaps::gather(const ProbeNeighbours& around, const glm::vec3& n) {
    const MapPoint point = map_point(n);
    MapGather gather{.first = index(point.node[0], around.probe[0]), .at = point.weight};
    std::uint64_t nodes = 0;
    for (const std::uint8_t node : point.node) nodes |= bit_of(node);
    for (std::size_t i = 0; i < point.node.size(); ++i) {
        if (point.weight[i] != 1.f) continue;
        gather.first = index(point.node[i], around.probe[0]);
        gather.at = {1.f, 0.f, 0.f, 0.f};
        nodes = bit_of(point.node[i]);
    }
    std::uint32_t count = 0;
    for (unsigned k = 0; k < around.probe.size(); ++k) {
        if (around.weight[k] == 0.f) continue;
        gather.weight[count] = around.weight[k];
        gather.probes |= k << (bits_of_count + bits_a_corner * count++);
        std::atomic_ref<std::uint64_t> asked(asked_[around.probe[k]]);
        // Most have been asked for before, and reading leaves the word in all caches.
        if ((nodes & ~asked.load(std::memory_order_relaxed)) != 0) {
            asked.fetch_or(nodes, std::memory_order_relaxed);
        }
    }
    gather.probes |= count;
    return gather;
}

void FeedbackMaps::make(const RayEnds& ends, std::span<const float> values,
                        std::size_t rays) const {
    tbb::parallel_for(std::size_t{0}, asked_.size(), [&](std::size_t probe) {
        for (std::uint64_t left = asked_[probe]; left != 0; left &= left - 1) {
            const auto node = static_cast<std::size_t>(std::countr_zero(left));
            const RaySums sums =
                ends.along_rays(probe, map_directions()[node], &values[probe * 3 * rays]);
            nodes_[index(node, probe)] = glm::vec4(irradiance(sums), 0.f);
        }
    });
}

void FeedbackMaps::gather(std::span<const MapGather> gathers, std::span<Spectrum> E) const {
    for (std::size_t i = 0; i < gathers.size(); ++i) {
        const MapGather& gather = gathers[i];
        const bool one_node = gather.at[0] == 1.f;
        std::uint32_t corners = gather.probes >> bits_of_count;
        Float4 sum{};
        for (std::uint32_t j = 0; j < (gather.probes & count_mask);
             ++j, corners >>= bits_a_corner) {
            const glm::vec4* map = &nodes_[gather.first + corner_offsets_[corners & corner_mask]];
            if (one_node) {
                sum += gather.weight[j] * load_float4(map[0]);
            } else {
                for (std::size_t k = 0; k < node_offsets.size(); ++k) {
                    sum += gather.weight[j] * gather.at[k] *
                           load_float4(map[node_offsets[k] * asked_.size()]);
                }
            }
        }
        E[i] = {sum[0], sum[1], sum[2]};
    }
}

Spectrum irradiance(const RaySums& sums) {
    if (sums.weight == 0.f) return Spectrum(0.f);
    return sums.radiance * (glm::pi<float>() / sums.weight);
}

}  // namespace plumbline::ddgi
