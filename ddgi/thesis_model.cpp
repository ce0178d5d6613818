// SPDX-License-Identifier: Apache-2.0
#include "ddgi/thesis_model.h"

#include <fmt/core.h>

#include "scenes/errors.h"

namespace plumbline::ddgi {

std::vector<float> thesis_miss_shares(const ThesisField& field) {
    const std::size_t per_octant = field.pattern.per_octant();
    std::vector<float> shares(field.surfels.size() / per_octant);
    for (std::size_t i = 0; i < shares.size(); ++i) {
        int misses = 0;
        for (std::size_t ray = 0; ray < per_octant; ++ray) {
            if (!field.surfels.hit(i * per_octant + ray)) ++misses;
        }
        shares[i] = static_cast<float>(misses) / static_cast<float>(per_octant);
    }
    return shares;
}

ThesisModel::ThesisModel(const ThesisConstants& constants, const ProbeGrid& grid)
    : constants_(constants),
      parameters_{constants.falloffRegulator, constants.bounceAttenuation,
                  constants.probeBrightness, constants.multiBounceIntensity},
      grid_(grid) {
    if (glm::any(glm::lessThan(grid.counts, glm::ivec3(3)))) {
        throw UsageError("--model thesis",
                         fmt::format("a grid of {} x {} x {} probes has no neighbours to read",
                                     grid.counts.x, grid.counts.y, grid.counts.z),
                         "give a smaller --spacing: three probes or more along each axis");
    }
}

void ThesisModel::take_surfels(const SurfelCache& cache) {
    cache_ = &cache;
    miss_shares_ = thesis_miss_shares(field());
    lit_.resize(probe_count(grid_) * 3 * octant_count);
    if (!feedback()) thesis_lit<float>(field(), parameters_, {}, lit_);
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
