// SPDX-License-Identifier: Apache-2.0
#include "ddgi/thesis_model.h"

#include <fmt/core.h>

#include <algorithm>

#include "scenes/errors.h"

namespace plumbline::ddgi {

std::array<float, octant_count> thesis_miss_shares(const ThesisField& field, std::size_t probe) {
    const std::size_t per_octant = field.pattern.per_octant();
    std::array<float, octant_count> shares;
    for (std::size_t d = 0; d < octant_count; ++d) {
        const std::size_t first = (probe * octant_count + d) * per_octant;
        int misses = 0;
        for (std::size_t i = first; i < first + per_octant; ++i) {
            if (!field.surfels.hit(i)) ++misses;
        }
        shares[d] = static_cast<float>(misses) / static_cast<float>(per_octant);
    }
    return shares;
}

std::vector<float> thesis_miss_shares(const ThesisField& field) {
    std::vector<float> shares;
    for (std::size_t probe = 0; probe < probe_count(field.grid); ++probe) {
        std::ranges::copy(thesis_miss_shares(field, probe), std::back_inserter(shares));
    }
    return shares;
}

std::optional<std::string> thesis_obstacle(const ProbeGrid& grid) {
    if (glm::all(glm::greaterThanEqual(grid.counts, glm::ivec3(3)))) return std::nullopt;
    return fmt::format("a grid of {} x {} x {} probes has no neighbours to read", grid.counts.x,
                       grid.counts.y, grid.counts.z);
}

ThesisModel::ThesisModel(const ThesisConstants& constants, const ProbeGrid& grid)
    : constants_(constants),
      parameters_{constants.falloffRegulator, constants.bounceAttenuation,
                  constants.probeBrightness, constants.multiBounceIntensity},
      grid_(grid) {
    if (const auto obstacle = thesis_obstacle(grid)) {
        throw UsageError("--model thesis", *obstacle,
                         "give the scene's grid three probes or more along each axis, or ddgi a "
                         "smaller --spacing");
    }
}

void ThesisModel::take_surfels(const SurfelCache& cache) {
    const bool afresh = cache_ != &cache;
    cache_ = &cache;
    lit_.resize(std::size_t{probe_count(grid_)} * 3 * octant_count);
    miss_shares_.resize(std::size_t{probe_count(grid_)} * octant_count);
    tbb::parallel_for(std::size_t{0}, std::size_t{probe_count(grid_)}, [&](std::size_t probe) {
        if (!afresh && !cache.probe_changed(probe)) return;
        std::ranges::copy(thesis_miss_shares(field(), probe), &miss_shares_[probe * octant_count]);
        if (!feedback()) thesis_lit<float>(field(), parameters_, {}, probe, lit_);
    });
}

void ThesisModel::update(std::span<const float> previous, std::span<float> next) const {
    const float propagation = thesis_propagation(parameters_.falloffRegulator, grid_.spacing);
    if (!feedback()) {
        thesis_propagate<float>(grid_, miss_shares_, propagation, lit_, previous, next);
        return;
    }
    std::vector<float> lit(lit_.size());
    thesis_lit<float>(field(), parameters_, previous, lit);
    thesis_propagate<float>(grid_, miss_shares_, propagation, lit, previous, next);
}

Spectrum ThesisModel::probe_light(std::span<const float> values, const ReceiverPoint& point) const {
    const auto [r, g, b] = thesis_look_up<float>(grid_, values, point.position, point.n);
    return parameters_.probeBrightness * Spectrum(r, g, b);
}

std::map<std::string, double> ThesisModel::constants() const {
    return {{"falloffRegulator", constants_.falloffRegulator},
            {"bounceAttenuation", constants_.bounceAttenuation},
            {"probeBrightness", constants_.probeBrightness},
            {"multiBounceIntensity", constants_.multiBounceIntensity},
            {"ambient", constants_.ambient},
            {"imageBrightness", constants_.imageBrightness}};
}

}  // namespace plumbline::ddgi
