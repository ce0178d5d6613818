// SPDX-License-Identifier: Apache-2.0
#include "ddgi/angular_storage.h"

#include <cassert>

#include "ddgi/angular_bins.h"
#include "ddgi/harmonics.h"

namespace plumbline::ddgi {
namespace {

constexpr int map_side = 8;  // as published maps of irradiance have [Majercik et al. 2019]

/// Irradiances on the directions of an octahedral map, between which a look-up interpolates.
class OctahedralStorage final : public AngularStorage {
 public:
    std::size_t bins() const override { return texels_.size(); }
    void store(std::span<const RayLight> rays, std::span<float> values) const override {
        texels_.irradiance(rays, values);
    }
    Spectrum irradiance(const ProbeNeighbours& around, std::span<const float> values,
                        const glm::vec3& n) const override {
        const TexelBlend blend = texels_.at(n);
        Spectrum E(0.f);
        for (std::size_t k = 0; k < around.probe.size(); ++k) {
            if (around.weight[k] == 0.f) continue;
            for (std::size_t c = 0; c < 3; ++c) {
                const float* map = &values[value_index(around.probe[k], c, 0, bins())];
                float sum = 0.f;
                for (std::size_t t = 0; t < blend.texel.size(); ++t)
                    sum += blend.weight[t] * map[blend.texel[t]];
                E[static_cast<int>(c)] += around.weight[k] * sum;
            }
        }
        return E;
    }

 private:
    OctahedralTexels texels_{map_side};
};

}  // namespace

std::unique_ptr<AngularStorage> make_storage(Storage storage, const ProbeGrid& grid) {
    switch (storage) {
        case Storage::Octants:
            return std::make_unique<OctantStorage>();
        case Storage::Equal32:
            return std::make_unique<EqualStorage>(4, 8);
        case Storage::Equal128:
            return std::make_unique<EqualStorage>(8, 16);
        case Storage::Sh2:
            return std::make_unique<HarmonicStorage>(grid, 2);
        case Storage::Sh3:
            return std::make_unique<HarmonicStorage>(grid, 3);
        case Storage::Octahedral:
            return std::make_unique<OctahedralStorage>();
        case Storage::Rays:
            break;
    }
    assert(false && "all rays are no bins");
    return nullptr;
}

}  // namespace plumbline::ddgi
