// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tbb/parallel_for.h>

#include <array>
#include <glm/gtc/constants.hpp>
#include <span>
#include <vector>

#include "ddgi/look_up.h"
#include "ddgi/patterns.h"
#include "ddgi/surfels.h"

// The probes of [Dellson 2023] as formulas in their constants. The renderer calls them with
// T = float; a fit calls the same code with dual numbers, and no ray is traced again.
//
//     C[p][d] = mean over the rays of (p, d) of
//                 a hit:  clamp(b a (E / pi + m Q(s, n_s)), 0, 1) cos(D_d, ray) / max(|s - p|^2, 1)
//                 a miss: C[q][d] falloffRegulator / (2 h^2),  q the neighbour along D_d
//     Q(x, n) = trilinear over the probes around x of sum_d C[p][d] max(0, n . D_d)

namespace plumbline::ddgi {

/// Those of the thesis's constants that act on probe light, under their published names.
template <typename T>
struct ThesisParameters {
    T falloffRegulator;      ///< length^2; scales what a missed ray takes from the neighbour
    T bounceAttenuation;     ///< b: scales every lit surfel
    T probeBrightness;       ///< a pixel adds this times Q
    T multiBounceIntensity;  ///< m: scales the feedback; 0: none
};

/// What the formulas read of a frame; the referred to must live on.
struct ThesisField {
    const ProbeGrid& grid;
    const RayPattern& pattern;
    const Surfels& surfels;
};

/// max(0, n . D_d), with D_d as published: not normalised.
inline std::array<float, octant_count> thesis_response(const glm::vec3& n) {
    std::array<float, octant_count> response;
    for (std::size_t d = 0; d < octant_count; ++d) {
        response[d] = glm::max(0.f, glm::dot(n, glm::vec3(principal_directions[d])));
    }
    return response;
}

/// Q(x, n), the light looked up at a point with unit normal n, from values of all probes.
template <typename T>
std::array<T, 3> thesis_look_up(const ProbeGrid& grid, std::span<const T> values,
                                const glm::vec3& x, const glm::vec3& n) {
    const std::array<float, octant_count> response = thesis_response(n);
    return look_up<T>(probe_neighbours(grid, x), response, values);
}

/// The part of a missed ray that the neighbour's value makes up.
template <typename T>
T thesis_propagation(const T& falloffRegulator, float spacing) {
    return falloffRegulator / Coefficient<T>(2.f * spacing * spacing);
}

/// The cell that the probe's missed rays start from: border probes step inward first, so that they
/// read themselves or a probe further in. Needs three probes along each axis.
inline glm::ivec3 thesis_inner_cell(const ProbeGrid& grid, std::uint32_t probe) {
    return glm::clamp(probe_cell(grid, probe), glm::ivec3(1), grid.counts - 2);
}

/// The probe that a missed ray of principal direction d reads.
inline std::uint32_t thesis_neighbour(const ProbeGrid& grid, std::uint32_t probe, std::size_t d) {
    return probe_index(grid, thesis_inner_cell(grid, probe) + principal_directions[d]);
}

/// Radiance of a lit surfel as the probes take it: attenuated, then clamped as published.
template <typename T>
T thesis_surfel(const T& radiance, const T& bounceAttenuation) {
    T lit = radiance * bounceAttenuation;
    if (lit < T(0)) return T(0);
    if (lit > T(1)) return T(1);
    return lit;
}

/// The share of missed rays per principal direction of `probe`.
std::array<float, octant_count> thesis_miss_shares(const ThesisField& field, std::size_t probe);
/// ... and of all probes, at probe * octant_count + d.
std::vector<float> thesis_miss_shares(const ThesisField& field);

/// The hits' part of an update of `probe`, into `lit` (probes * 3 * octant_count values, see
/// value_index). `previous`: the values that feed back; may be empty if multiBounceIntensity is 0.
/// Without feedback the result does not change from one update to the next.
template <typename T>
void thesis_lit(const ThesisField& field, const ThesisParameters<T>& parameters,
                std::span<const T> previous, std::size_t probe, std::span<T> lit) {
    const bool feedback = !previous.empty();
    const std::size_t per_octant = field.pattern.per_octant();
    const auto light_octant = [&](std::size_t d) {
        const glm::vec3 axis = glm::normalize(glm::vec3(principal_directions[d]));
        std::array<T, 3> sum{T(0), T(0), T(0)};
        for (std::size_t ray = d * per_octant; ray < (d + 1) * per_octant; ++ray) {
            const std::size_t surfel = probe * octant_count * per_octant + ray;
            if (!field.surfels.hit(surfel)) continue;
            const float distance = field.surfels.place[surfel].distance;
            const float cosine = glm::max(0.f, glm::dot(axis, field.pattern.directions[ray]));
            const Coefficient<T> share = cosine / glm::max(distance * distance, 1.f);
            std::array<T, 3> Q{T(0), T(0), T(0)};
            if (feedback) {
                const std::size_t source = field.surfels.source_of(surfel);
                Q = thesis_look_up<T>(field.grid, previous, field.surfels.place[source].position,
                                      field.surfels.place[source].n);
            }
            for (int c = 0; c < 3; ++c) {
                const Coefficient<T> albedo = field.surfels.light[surfel].albedo[c];
                const T incident =
                    parameters.multiBounceIntensity * Q[static_cast<std::size_t>(c)] +
                    Coefficient<T>(field.surfels.light[surfel].direct[c] / glm::pi<float>());
                sum[static_cast<std::size_t>(c)] +=
                    share * thesis_surfel<T>(albedo * incident, parameters.bounceAttenuation);
            }
        }
        for (std::size_t c = 0; c < 3; ++c) {
            lit[value_index(probe, c, d, octant_count)] = sum[c] / Coefficient<T>(per_octant);
        }
    };
    for (std::size_t d = 0; d < octant_count; ++d) light_octant(d);
}

/// ... and of all probes.
template <typename T>
void thesis_lit(const ThesisField& field, const ThesisParameters<T>& parameters,
                std::span<const T> previous, std::span<T> lit) {
    tbb::parallel_for(std::size_t{0}, std::size_t{probe_count(field.grid)}, [&](std::size_t probe) {
        thesis_lit<T>(field, parameters, previous, probe, lit);
    });
}

/// One update of all probes: next = lit + miss share * propagation * previous[neighbour].
template <typename T>
void thesis_propagate(const ProbeGrid& grid, std::span<const float> miss_shares,
                      const T& propagation, std::span<const T> lit, std::span<const T> previous,
                      std::span<T> next) {
    // A neighbour is as far along the probes' order wherever one stands.
    std::array<std::uint32_t, octant_count> further;
    const std::uint32_t one = probe_index(grid, glm::ivec3(1));
    for (std::size_t d = 0; d < octant_count; ++d)
        further[d] = probe_index(grid, 1 + principal_directions[d]) - one;
    tbb::parallel_for(std::uint32_t{0}, probe_count(grid), [&](std::uint32_t probe) {
        const std::uint32_t inner = probe_index(grid, thesis_inner_cell(grid, probe));
        for (std::size_t d = 0; d < octant_count; ++d) {
            const std::uint32_t neighbour = inner + further[d];
            const T passed = propagation * Coefficient<T>(miss_shares[probe * octant_count + d]);
            for (std::size_t c = 0; c < 3; ++c) {
                const std::size_t here = value_index(probe, c, d, octant_count);
                next[here] =
                    lit[here] + passed * previous[value_index(neighbour, c, d, octant_count)];
            }
        }
    });
}

}  // namespace plumbline::ddgi
