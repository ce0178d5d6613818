// SPDX-License-Identifier: Apache-2.0
#include "ddgi/conserving_model.h"

#include <tbb/parallel_for.h>

#include <glm/gtc/constants.hpp>

#include "ddgi/look_up.h"
#include "ddgi/octants.h"

namespace plumbline::ddgi {
namespace {

/// octant_cosines() of one normal after another; neighbours often share theirs.
class OctantCosines {
   public:
    std::span<const float> at(const glm::vec3& n) {
        if (n != n_) {
            n_ = n;
            cosines_ = octant_cosines(n);
        }
        return cosines_;
    }

   private:
    glm::vec3 n_{0.f};  // no unit normal, so the first call computes
    std::array<float, principal_direction_count> cosines_{};
};

/// E(x, n) from the probes, W m^-2.
Spectrum irradiance(const ProbeGrid& grid, std::span<const float> values, const glm::vec3& x,
                    std::span<const float> cosines) {
    const auto [r, g, b] = look_up<float>(probe_neighbours(grid, x), cosines, values);
    return {r, g, b};
}

}  // namespace

void ConservingModel::take_surfels(const SurfelCache& cache, const Spectrum& environment) {
    cache_ = &cache;
    const Surfels& surfels = cache.surfels();
    unfed_.resize(surfels.size());
    tbb::parallel_for(std::size_t{0}, surfels.size(), [&](std::size_t i) {
        unfed_[i] = surfels.hit(i) ? surfels.albedo[i] / glm::pi<float>() * surfels.direct[i] +
                                         surfels.emission[i]
                                   : environment;
    });
}

void ConservingModel::update(std::span<const float> previous, std::span<float> next) const {
    const Surfels& surfels = cache_->surfels();
    const auto per_octant = static_cast<std::size_t>(cache_->pattern().per_octant());
    const auto update_probe = [&](std::size_t probe, OctantCosines& cosines) {
        for (std::size_t d = 0; d < bins(); ++d) {
            Spectrum sum(0.f);
            const std::size_t first = (probe * bins() + d) * per_octant;
            for (std::size_t i = first; i < first + per_octant; ++i) {
                sum += unfed_[i];
                if (!surfels.hit(i) || surfels.albedo[i] == Spectrum(0.f)) continue;
                const Spectrum E = irradiance(grid_, previous, surfels.position[i],
                                              cosines.at(surfels.n[i]));
                sum += surfels.albedo[i] / glm::pi<float>() * E;
            }
            const Spectrum mean = sum / static_cast<float>(per_octant);
            for (std::size_t c = 0; c < 3; ++c) {
                next[value_index(probe, c, d, bins())] = mean[static_cast<int>(c)];
            }
        }
    };
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, probe_count(grid_)),
                      [&](const tbb::blocked_range<std::size_t>& probes) {
                          OctantCosines cosines;
                          for (std::size_t p = probes.begin(); p < probes.end(); ++p) {
                              update_probe(p, cosines);
                          }
                      });
}

Spectrum ConservingModel::probe_light(std::span<const float> values,
                                      const ReceiverPoint& point) const {
    const Spectrum E =
        irradiance(grid_, values, point.position, octant_cosines(point.n));
    return point.albedo / glm::pi<float>() * E;
}

}  // namespace plumbline::ddgi
