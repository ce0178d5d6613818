// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "pathtracer/lane_steps.h"
#include "pathtracer/path.h"
#include "scenes/effects.h"

namespace plumbline::pathtracer {

/// Follows many paths side by side, scattering by scattering, so that rays are traced in packets,
/// shading runs in vector instructions, and one step's code and tables stay in the cache
/// [Laine et al. 2013].
///
/// Unbiased for the radiance that is scattered at most `options.max_scatterings` times. Lights are
/// sampled at every surface, or one of them with Effect::LightChoice, emitters with
/// Effect::EmitterSampling, and the environment with Effect::EnvironmentImage; emission and
/// environment count where a path meets them. What a path finds depends on its ray and its sampler
/// alone, not on the others in the wave. Code for an effect outside F is compiled out; F must cover
/// effects_of() the scene. `Tracer` is a RayTracer, or answers like one. Memory is kept from wave
/// to wave.
template <Effects F, typename Tracer>
class Wave {
 public:
    /// `tracer` must outlive it.
    Wave(const Tracer& tracer, const PathOptions& options)
        : tracer_(tracer), world_(tracer.world()), options_(options) {}

    /// Adds a path from the camera ray `ray` to the next wave.
    void start(const Ray& ray, const Sampler& sampler) {
        WalkLanes& walks = block_of(walking_);
        const std::size_t i = walking_ % lane_count;
        walks.rays.set(i, ray);
        walks.beta.set(i, Spectrum(1.f));
        walks.sampler.set(i, sampler);
        walks.path[i] = static_cast<std::uint32_t>(walking_);
        ++walking_;
    }

    /// Follows all paths to their ends; the answer, in the order of the starts, holds until the
    /// next call.
    std::span<const Path> follow() {
        paths_.assign(walking_, Path{});
        rays_ = 0;
        for (int scatterings = 0; walking_ > 0; ++scatterings) step(scatterings);
        return paths_;
    }

    /// Camera, bounce and shadow rays of the last wave.
    std::uint64_t rays() const { return rays_; }

 private:
    static constexpr bool remembers = has_any(F, aimed_at);

    WalkLanes& block_of(std::size_t walk) {
        const std::size_t block = walk / lane_count;
        if (block == blocks_.size()) blocks_.emplace_back();
        return blocks_[block];
    }

    /// Follows every path to its next surface. Those that live on close the gaps of those that end.
    void step(int scatterings) {
        const std::size_t before = walking_;
        walking_ = 0;
        for (std::size_t first = 0; first < before; first += lane_count) {
            WalkLanes& walks = blocks_[first / lane_count];
            walks.rays.count = std::min(lane_count, before - first);
            intersect(scatterings, walks);
            meet(scatterings, walks);
            if (scatterings < options_.max_scatterings) leave(scatterings, walks);
        }
        add_light(scatterings + 1);
    }

    void intersect(int scatterings, const WalkLanes& walks) {
        const bool from_camera = scatterings == 0;
        tracer_.intersect(walks.rays, from_camera ? BackFaces::Cull : BackFaces::Hit,
                          from_camera ? Coherence::Coherent : Coherence::Incoherent, hits_);
        rays_ += walks.rays.count;
        if (!from_camera) return;
        for (std::size_t i = 0; i < hits_.count; ++i) {
            paths_[walks.path[hits_.ray[i]]].surface = hits_[i];
        }
    }

    /// Adds what shines where the rays of `walks` end, and moves the paths that hit a surface to
    /// the lanes of their hits.
    void meet(int scatterings, WalkLanes& walks) {
        if constexpr (has(F, Effect::Environment)) add_environment(scatterings, walks);
        if (hits_.count < walks.rays.count) {
            std::fill_n(flags_.data(), walks.rays.count, 0);
            for (std::size_t i = 0; i < hits_.count; ++i) flags_[hits_.ray[i]] = 1;
            close_up_carried(KeptLanes(walks.rays.count, flags_), walks);
        }
        for (std::size_t i = 0; i < hits_.count; ++i) {
            const Material& material = world_.materials[std::size_t(hits_.material[i])];
            if (hits_.back[i] != 0 && !material.two_sided) {
                hits_.albedo.set(i, Spectrum(0.f));  // the back is black
            } else if constexpr (has(F, Effect::Emission)) {
                if (material.emission == Spectrum(0.f)) continue;
                const Spectrum Le = met_emission<F>(material.emission, options_, scatterings,
                                                    walks.last[i], hits_[i]);
                paths_[walks.path[i]].add(scatterings, walks.beta[i] * Le);
            }
        }
    }

    void add_environment(int scatterings, const WalkLanes& walks) {
        std::size_t next_hit = 0;
        for (std::size_t i = 0; i < walks.rays.count; ++i) {
            if (next_hit < hits_.count && hits_.ray[next_hit] == i) {
                ++next_hit;
                continue;
            }
            const Spectrum L = met_environment<F>(world_, options_, scatterings, walks.last[i],
                                                  walks.rays.direction[i]);
            paths_[walks.path[i]].add(scatterings, walks.beta[i] * L);
        }
    }

    /// Samples lights from the surfaces hit, and sends the paths on from there.
    void leave(int scatterings, WalkLanes& walks) {
        start_rays(hits_, walks.rays.origin);
        if constexpr (has_any(F, sampled)) sample_light(scatterings + 1, walks);
        // Without these, nothing that the next ray could meet would count.
        constexpr bool surfaces_or_sky_shine =
            has(F, Effect::Emission) || has(F, Effect::Environment);
        if (!surfaces_or_sky_shine && scatterings + 1 == options_.max_scatterings) return;

        scatter(hits_, walks);
        if constexpr (remembers) remember(walks);
        find_alive(hits_.count, walks, flags_);
        if (options_.roulette && scatterings + 1 >= options_.roulette_start) {
            play_roulette(options_, hits_.count, walks, flags_);
        }
        keep_alive(walks);
    }

    /// Samples light that would be scattered `scatterings` times.
    void sample_light(int scatterings, WalkLanes& walks) {
        if constexpr (!has_any(F, drawn_singly)) {
            for (const PointLight& light : world_.lights) {
                shine(EvenLight(light), hits_, walks.beta, light_);
                add_samples(scatterings, light.position, walks);
            }
        } else {
            for (std::size_t i = 0; i < hits_.count; ++i) {
                const Spectrum f_beta =
                    walks.beta[i] * hits_.albedo[i] * std::numbers::inv_pi_v<float>;
                const glm::vec3 origin = walks.rays.origin[i];
                Sampler sampler = walks.sampler[i];
                sample_direct_light<F>(
                    world_, options_, hits_.position[i], hits_.n[i], origin, sampler,
                    [&](const SampledLight& light) {
                        const Spectrum L = f_beta * light.E;
                        if (L == Spectrum(0.f)) return;
                        add_sample(scatterings, {origin, light.target}, L, walks.path[i]);
                    });
                walks.sampler.set(i, sampler);
            }
        }
    }

    /// Adds light_ from a light at `position`, where there is any.
    void add_samples(int scatterings, const glm::vec3& position, const WalkLanes& walks) {
        find_lit(hits_.count, light_, flags_);
        const KeptLanes lit(hits_.count, flags_);
        lit.close_up(light_);
        lit.close_up(walks.rays.origin, lit_from_);
        lit.close_up(walks.path, lit_path_);
        for (std::size_t i = 0; i < lit.count();) {
            const std::size_t added = std::min(lit.count() - i, light_samples_.room());
            light_samples_.push(lit_from_, position, light_, lit_path_, i, added);
            if (light_samples_.full()) add_light(scatterings);
            i += added;
        }
    }

    void add_sample(int scatterings, const Segment& segment, const Spectrum& L,
                    std::uint32_t path) {
        light_samples_.push(segment, L, path);
        if (light_samples_.full()) add_light(scatterings);
    }

    /// Adds to the paths the light samples that nothing hides.
    void add_light(int scatterings) {
        SegmentLanes& segments = light_samples_.segments;
        if (segments.count == 0) return;
        tracer_.occluded(segments, hidden_);
        rays_ += segments.count;
        find_seen(segments.count, hidden_, flags_);
        const KeptLanes seen(segments.count, flags_);
        seen.close_up(light_samples_.L);
        seen.close_up(light_samples_.path);
        for (std::size_t i = 0; i < seen.count(); ++i) {
            paths_[light_samples_.path[i]].add(scatterings, light_samples_.L[i]);
        }
        segments.count = 0;
    }

    void remember(WalkLanes& walks) {
        for (std::size_t i = 0; i < hits_.count; ++i) {
            const glm::vec3 n = hits_.n[i];
            const float cosine = glm::dot(n, walks.rays.direction[i]);
            walks.last[i] = {hits_.position[i], n, pdf_cosine_hemisphere(cosine)};
        }
    }

    /// Adds the paths that are alive to those of the next step.
    void keep_alive(WalkLanes& walks) {
        const KeptLanes alive(hits_.count, flags_);
        for_each_of_ray([&](auto& lanes) { alive.close_up(lanes); }, walks);
        close_up_carried(alive, walks);
        for (std::size_t i = 0; i < alive.count();) {
            WalkLanes& kept = blocks_[walking_ / lane_count];
            const std::size_t to = walking_ % lane_count;
            const std::size_t added = std::min(alive.count() - i, lane_count - to);
            if (&kept != &walks || to != i) append(walks, i, added, kept, to);
            walking_ += added;
            i += added;
        }
    }

    /// Moves together what the kept paths carry.
    void close_up_carried(const KeptLanes& kept, WalkLanes& walks) const {
        for_each_carried([&](auto& lanes) { kept.close_up(lanes); }, walks);
        if constexpr (remembers) {
            std::size_t next = 0;
            for (std::size_t i = 0; next < kept.count(); ++i) {
                if (flags_[i] != 0) walks.last[next++] = walks.last[i];
            }
        }
    }

    static void append(const WalkLanes& from, std::size_t first, std::size_t count, WalkLanes& kept,
                       std::size_t to) {
        const auto copy = [&](const auto& lanes, auto& copies) {
            std::copy_n(lanes.data() + first, count, copies.data() + to);
        };
        for_each_of_ray(copy, from, kept);
        for_each_carried(copy, from, kept);
        if constexpr (remembers) copy(from.last, kept.last);
    }

    const Tracer& tracer_;
    const World& world_;
    PathOptions options_;
    std::size_t walking_ = 0;
    std::vector<WalkLanes> blocks_;  // the first walking_ lanes of all
    std::vector<Path> paths_;
    std::uint64_t rays_ = 0;
    HitLanes hits_;
    Lanes3 light_;
    Lanes<std::int32_t> flags_, hidden_;
    Lanes3 lit_from_;
    Lanes<std::uint32_t> lit_path_;
    LightSampleLanes light_samples_;
};

}  // namespace plumbline::pathtracer
