// SPDX-License-Identifier: Apache-2.0
#include "ddgi/steps_model.h"

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <tbb/parallel_for.h>

#include <glm/gtc/constants.hpp>

#include "scenes/errors.h"
#include "scenes/nearest_name.h"

namespace plumbline::ddgi {
namespace {

struct NamedStep {
    const char* name;
    bool Steps::*member;
};

constexpr std::array<NamedStep, 8> named_steps = {{{"receiverAlbedo", &Steps::receiverAlbedo},
                                                   {"solidAngle", &Steps::solidAngle},
                                                   {"octantLookUp", &Steps::octantLookUp},
                                                   {"evenRays", &Steps::evenRays},
                                                   {"firstSurface", &Steps::firstSurface},
                                                   {"multiBounce", &Steps::multiBounce},
                                                   {"diagonalNeighbour", &Steps::diagonalNeighbour},
                                                   {"gridAtEnd", &Steps::gridAtEnd}}};

void take_step(Steps& steps, const std::string& name, double value) {
    std::vector<std::string> names;
    for (const NamedStep& known : named_steps) {
        names.emplace_back(known.name);
        if (name != known.name) continue;
        if (value != 0. && value != 1.)
            throw UsageError("--set " + name, fmt::format("{} is no choice", value), "give 0 or 1");
        steps.*known.member = value == 1.;
        return;
    }
    throw UsageError("--set " + name, fmt::format("the model steps has {}", fmt::join(names, ", ")),
                     did_you_mean(name, names));
}

/// Whether a place in cells lies in the grid; a ray that ends on its border may be off by rounding.
bool within(const ProbeGrid& grid, const glm::vec3& place) {
    constexpr float rounding = 1e-4f;
    return glm::all(glm::greaterThanEqual(place, glm::vec3(-rounding))) &&
           glm::all(glm::lessThanEqual(place, glm::vec3(grid.counts - 1) + rounding));
}

/// Of its octant, what each ray stands for. Rings even in polar angle stand for solid angles that
/// go with its sine; even rays stand for equal ones.
std::vector<float> shares_of(const RayPattern& pattern, bool even) {
    std::vector<float> shares;
    const std::size_t per_octant = pattern.per_octant();
    for (std::size_t d = 0; d < octant_count; ++d) {
        float sum = 0.f;
        for (std::size_t ray = d * per_octant; ray < (d + 1) * per_octant; ++ray) {
            const float y = pattern.directions[ray].y;
            shares.push_back(even ? 1.f : std::sqrt(1.f - y * y));
            sum += shares.back();
        }
        for (std::size_t ray = d * per_octant; ray < (d + 1) * per_octant; ++ray)
            shares[ray] /= sum;
    }
    return shares;
}

}  // namespace

StepsModel::StepsModel(const Steps& steps, const ThesisConstants& constants, const ProbeGrid& grid)
    : steps_(steps), constants_(constants), grid_(grid) {
    // The thesis's rule for neighbours holds for its grids alone.
    if (!steps.firstSurface) ThesisModel(constants, grid);
}

RayPattern StepsModel::pattern(int surfels) const {
    return steps_.evenRays ? even_pattern(surfels) : thesis_pattern(surfels);
}

Reach StepsModel::reach() const {
    return steps_.firstSurface ? Reach::FirstSurface : Reach::OneCell;
}

void StepsModel::take_surfels(const SurfelCache& cache) {
    cache_ = &cache;
    ray_shares_ = shares_of(cache.pattern(), steps_.evenRays);
}

Spectrum StepsModel::look_up_at(std::span<const float> values, const glm::vec3& x,
                                const glm::vec3& n) const {
    const ProbeNeighbours around = probe_neighbours(grid_, x);
    const auto [r, g, b] = steps_.octantLookUp ? look_up<float>(around, octant_cosines(n), values)
                                               : look_up<float>(around, thesis_response(n), values);
    return {r, g, b};
}

Spectrum StepsModel::surfel_radiance(std::span<const float> previous, std::size_t surfel) const {
    const Surfels& surfels = cache_->surfels();
    Spectrum incident = surfels.light[surfel].direct / glm::pi<float>();
    if (steps_.multiBounce) {
        const std::size_t source = surfels.source_of(surfel);
        const Spectrum Q =
            look_up_at(previous, surfels.place[source].position, surfels.place[source].n);
        incident +=
            steps_.octantLookUp ? Q / glm::pi<float>() : constants_.multiBounceIntensity * Q;
    }
    const Spectrum radiance = surfels.light[surfel].albedo * incident;
    if (steps_.octantLookUp) return radiance;
    Spectrum attenuated;
    for (int c = 0; c < 3; ++c)
        attenuated[c] = thesis_surfel<float>(radiance[c], constants_.bounceAttenuation);
    return attenuated;
}

float StepsModel::ray_weight(std::size_t surfel) const {
    const RayPattern& pattern = cache_->pattern();
    const std::size_t ray = surfel % pattern.directions.size();
    if (steps_.solidAngle) return ray_shares_[ray];
    const std::size_t d = ray / pattern.per_octant();
    const glm::vec3 axis = glm::normalize(glm::vec3(principal_directions[d]));
    const float distance = cache_->surfels().place[surfel].distance;
    const float cosine = glm::max(0.f, glm::dot(axis, pattern.directions[ray]));
    return cosine / glm::max(distance * distance, 1.f) / static_cast<float>(pattern.per_octant());
}

Spectrum StepsModel::missed_radiance(std::span<const float> previous, std::uint32_t probe,
                                     std::size_t d, const glm::vec3& direction) const {
    const auto held = [&](std::uint32_t by) {
        const auto channel = [&](std::size_t c) {
            return previous[value_index(by, c, d, octant_count)];
        };
        return Spectrum(channel(0), channel(1), channel(2));
    };
    if (steps_.firstSurface) return Spectrum(0.f);
    const glm::ivec3 cell = probe_cell(grid_, probe);
    if (steps_.gridAtEnd) {
        const glm::vec3 end = glm::vec3(cell) + direction / max_component(glm::abs(direction));
        if (!within(grid_, end)) return Spectrum(0.f);
        const ProbeNeighbours around = probe_neighbours(grid_, grid_.origin + grid_.spacing * end);
        Spectrum sum(0.f);
        for (std::size_t k = 0; k < around.probe.size(); ++k)
            sum += around.weight[k] * held(around.probe[k]);
        return sum;
    }
    if (steps_.diagonalNeighbour) {
        const glm::ivec3 neighbour = cell + principal_directions[d];
        return within(grid_, glm::vec3(neighbour)) ? held(probe_index(grid_, neighbour))
                                                   : Spectrum(0.f);
    }
    return thesis_propagation(constants_.falloffRegulator, grid_.spacing) *
           held(thesis_neighbour(grid_, probe, d));
}

void StepsModel::update(std::span<const float> previous, std::span<float> next) const {
    const RayPattern& pattern = cache_->pattern();
    const std::size_t per_octant = pattern.per_octant();
    const auto update_octant = [&](std::uint32_t probe, std::size_t d) {
        Spectrum sum(0.f);
        for (std::size_t ray = d * per_octant; ray < (d + 1) * per_octant; ++ray) {
            const std::size_t surfel = probe * octant_count * per_octant + ray;
            if (cache_->surfels().hit(surfel)) {
                sum += ray_weight(surfel) * surfel_radiance(previous, surfel);
                continue;
            }
            const float share =
                steps_.solidAngle ? ray_shares_[ray] : 1.f / static_cast<float>(per_octant);
            sum += share * missed_radiance(previous, probe, d, pattern.directions[ray]);
        }
        for (std::size_t c = 0; c < 3; ++c)
            next[value_index(probe, c, d, octant_count)] = sum[static_cast<int>(c)];
    };
    tbb::parallel_for(std::uint32_t{0}, probe_count(grid_), [&](std::uint32_t probe) {
        for (std::size_t d = 0; d < octant_count; ++d) update_octant(probe, d);
    });
}

Spectrum StepsModel::probe_light(std::span<const float> values, const ReceiverPoint& point) const {
    const Spectrum Q = look_up_at(values, point.position, point.n);
    const float gain = steps_.octantLookUp ? 1.f / glm::pi<float>() : constants_.probeBrightness;
    return gain * Q * (steps_.receiverAlbedo ? point.albedo : Spectrum(1.f));
}

std::map<std::string, double> StepsModel::constants() const {
    std::map<std::string, double> taken;
    for (const NamedStep& step : named_steps) taken[step.name] = steps_.*step.member ? 1. : 0.;
    return taken;
}

ModelSetup make_steps(const Scene& scene, const ProbeGrid& grid,
                      const std::map<std::string, double>& set) {
    Steps steps;
    for (const auto& [name, value] : set) take_step(steps, name, value);
    ModelSetup setup;
    ThesisConstants constants = thesis_constants(scene, grid, {}, setup.notes);
    if (scene.thesis) constants.multiBounceIntensity = scene.thesis->multiBounceIntensity;
    setup.model = std::make_unique<StepsModel>(steps, constants, grid);
    return setup;
}

}  // namespace plumbline::ddgi
