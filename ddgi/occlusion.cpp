// SPDX-License-Identifier: Apache-2.0
#include "ddgi/occlusion.h"

#include <algorithm>

namespace plumbline::ddgi {

std::vector<std::uint8_t> occluded(const RayTracer& tracer, const std::vector<Segment>& ways) {
    SegmentLanes segments;
    Lanes<std::int32_t> hidden;
    std::vector<std::uint8_t> result(ways.size());
    for (std::size_t first = 0; first < ways.size(); first += plumbline::lane_count) {
        const std::size_t count = std::min(plumbline::lane_count, ways.size() - first);
        segments.count = 0;
        for (std::size_t i = 0; i < count; ++i)
            segments.push(ways[first + i]);
        tracer.occluded(segments, hidden);
        for (std::size_t i = 0; i < count; ++i) result[first + i] = hidden[i] != 0 ? 1 : 0;
    }
    return result;
}

}  // namespace plumbline::ddgi
