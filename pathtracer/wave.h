// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "pathtracer/vertex.h"

namespace plumbline::pathtracer {

/// Follows many paths side by side, scattering by scattering, so that rays are traced in packets
/// and one step's code and tables stay in the cache [Laine et al. 2013].
///
/// What a path finds depends on its ray and its sampler alone, not on the others in the wave. F
/// must cover effects_of() the scene; `Tracer` is a RayTracer, or answers like one. Memory is kept
/// from wave to wave.
template <Effects F, typename Tracer>
class Wave {
 public:
    /// `tracer` must outlive it.
    Wave(const Tracer& tracer, const PathOptions& options) : tracer_(tracer), options_(options) {}

    /// Adds a path from the camera ray `ray` to the next wave.
    void start(const Ray& ray, const Sampler& sampler) {
        walks_.push_back({Spectrum(1.f), sampler, static_cast<std::uint32_t>(rays_.size()), {}});
        rays_.push_back(ray);
    }

    /// Follows all paths to their ends; the answer, in the order of the starts, holds until the
    /// next call.
    std::span<const Path> follow() {
        paths_.assign(walks_.size(), Path{});
        for (int scatterings = 0; !walks_.empty(); ++scatterings) step(scatterings);
        return paths_;
    }

 private:
    /// Rays handled together: so few that they stay in the first-level cache from step to step.
    static constexpr std::size_t chunk_size = 128;

    /// Follows every path to its next surface. Those that live on close the gaps of those that end.
    void step(int scatterings) {
        std::size_t kept = 0;
        for (std::size_t first = 0; first < walks_.size(); first += chunk_size) {
            const std::size_t count = std::min(chunk_size, walks_.size() - first);
            intersect(scatterings, std::span(rays_).subspan(first, count));
            kept = shade(scatterings, first, count, kept);
            add_light(scatterings + 1);
        }
        walks_.erase(walks_.begin() + std::ptrdiff_t(kept), walks_.end());
        rays_.resize(kept);
    }

    void intersect(int scatterings, std::span<const Ray> rays) {
        const std::span hits = std::span(hits_).first(rays.size());
        if (scatterings == 0) {
            tracer_.intersect(rays, BackFaces::Cull, Coherence::Coherent, hits);
        } else {
            tracer_.intersect(rays, BackFaces::Hit, Coherence::Incoherent, hits);
        }
    }

    /// Shades what the rays [first, first + count) hit; moves the paths that live on to `kept` and
    /// on, and returns the end of these.
    std::size_t shade(int scatterings, std::size_t first, std::size_t count, std::size_t kept) {
        for (std::size_t i = 0; i < count; ++i) {
            const std::optional<Hit>& hit = hits_[i];
            Ray ray = rays_[first + i];
            Walk walk = walks_[first + i];
            Path& path = paths_[walk.path];
            ++path.rays;
            if (scatterings == 0) path.surface = hit;
            if (!shade_vertex<F>(tracer_.world(), options_, scatterings, hit, ray, walk, path,
                                 light_samples_)) {
                continue;
            }
            rays_[kept] = ray;
            walks_[kept] = walk;
            ++kept;
        }
        return kept;
    }

    /// Adds to the paths the light samples that nothing hides.
    void add_light(int scatterings) {
        const std::span<const Segment> segments(light_samples_.segments);
        for (std::size_t first = 0; first < segments.size(); first += chunk_size) {
            const auto part =
                segments.subspan(first, std::min(chunk_size, segments.size() - first));
            tracer_.occluded(part, std::span(hidden_).first(part.size()));
            for (std::size_t i = 0; i < part.size(); ++i) {
                const LightSample& sample = light_samples_.samples[first + i];
                Path& path = paths_[sample.path];
                ++path.rays;
                if (!hidden_[i]) path.add(scatterings, sample.L);
            }
        }
        light_samples_.clear();
    }

    const Tracer& tracer_;
    PathOptions options_;
    std::vector<Ray> rays_;    // of the paths still followed
    std::vector<Walk> walks_;  // of the same
    std::vector<Path> paths_;  // of all
    std::array<std::optional<Hit>, chunk_size> hits_;
    LightSamples light_samples_;
    std::array<bool, chunk_size> hidden_;
};

}  // namespace plumbline::pathtracer
