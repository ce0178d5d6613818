// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <limits>

#include "scenes/embree_scene.h"

namespace plumbline {

/// Up to `N` rays that Embree traces together: N = 1, 4, 8 or 16. A ray's answer depends on the
/// others only where two surfaces lie at the same distance to rounding: which of them it meets.
/// Hence callers make packets from the same rays at any thread count and in any shard.
template <std::size_t N>
class Packet {
 public:
    static constexpr std::size_t width = N;

    Packet() {
        for (std::size_t i = 0; i < N; ++i) {
            // Embree counts a surface at tnear as met; a point on a surface is not in front of it.
            rays_.ray.tnear[i] = std::numeric_limits<float>::min();
            rays_.ray.time[i] = 0.f;
            rays_.ray.mask[i] = ~0u;
            rays_.ray.id[i] = 0;
            rays_.ray.flags[i] = 0;
            valid_[i] = 0;
            // Of a ray that meets nothing these stay, and are computed with beside those of others.
            rays_.hit.u[i] = rays_.hit.v[i] = 0.f;
            rays_.hit.Ng_x[i] = rays_.hit.Ng_y[i] = rays_.hit.Ng_z[i] = 0.f;
        }
    }

    /// Takes `ray` alone.
    void load(const Ray& ray) {
        set(0, ray);
        valid_[0] = ray.t_max > 0.f ? -1 : 0;
    }

    /// Takes the rays from `first` on, but not those that end before they start.
    void load(const RayLanes& rays, std::size_t first) {
        if constexpr (N == 1) return load(rays[first]);
        auto& ray = rays_.ray;
        copy(rays.origin.x, first, ray.org_x);
        copy(rays.origin.y, first, ray.org_y);
        copy(rays.origin.z, first, ray.org_z);
        copy(rays.direction.x, first, ray.dir_x);
        copy(rays.direction.y, first, ray.dir_y);
        copy(rays.direction.z, first, ray.dir_z);
        copy(rays.t_max, first, ray.tfar);
        int all = -1;
        for (std::size_t i = 0; i < N; ++i) {
            valid_[i] = (first + i < rays.count ? -1 : 0) & (ray.tfar[i] > 0.f ? -1 : 0);
            all &= valid_[i];
        }
        if (all != 0) return;
        for (std::size_t i = 0; i < N; ++i) {
            // Embree looks at all lanes of some packets, and stops the program at a NaN.
            if (valid_[i] == 0) set(i, {glm::vec3(0.f), {0.f, 0.f, 1.f}, 0.f});
        }
    }

    void intersect(RTCScene scene, RTCIntersectContext& context) {
        for (std::size_t i = 0; i < N; ++i) rays_.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        if constexpr (N == 1) {
            if (valid_[0] == 0) return;
            rtcIntersect1(scene, &context, reinterpret_cast<RTCRayHit*>(&rays_));
        } else if constexpr (N == 4) {
            rtcIntersect4(valid_.data(), scene, &context, reinterpret_cast<RTCRayHit4*>(&rays_));
        } else if constexpr (N == 8) {
            rtcIntersect8(valid_.data(), scene, &context, reinterpret_cast<RTCRayHit8*>(&rays_));
        } else {
            rtcIntersect16(valid_.data(), scene, &context, reinterpret_cast<RTCRayHit16*>(&rays_));
        }
    }

    void occluded(RTCScene scene, RTCIntersectContext& context) {
        if constexpr (N == 1) {
            if (valid_[0] == 0) return;
            rtcOccluded1(scene, &context, reinterpret_cast<RTCRay*>(&rays_.ray));
        } else if constexpr (N == 4) {
            rtcOccluded4(valid_.data(), scene, &context, reinterpret_cast<RTCRay4*>(&rays_.ray));
        } else if constexpr (N == 8) {
            rtcOccluded8(valid_.data(), scene, &context, reinterpret_cast<RTCRay8*>(&rays_.ray));
        } else {
            rtcOccluded16(valid_.data(), scene, &context, reinterpret_cast<RTCRay16*>(&rays_.ray));
        }
    }

    bool found(std::size_t i) const { return rays_.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID; }

    EmbreeScene::Found hit(std::size_t i) const {
        const auto& hit = rays_.hit;
        return {.geometry = hit.geomID[i],
                .primitive = hit.primID[i],
                .t = rays_.ray.tfar[i],
                .u = hit.u[i],
                .v = hit.v[i],
                .ng = {hit.Ng_x[i], hit.Ng_y[i], hit.Ng_z[i]}};
    }

    bool hidden(std::size_t i) const { return valid_[i] != 0 && rays_.ray.tfar[i] < 0.f; }

    /// Puts what was found into the lanes from `first` on.
    void store(EmbreeScene::FoundLanes& found, std::size_t first) const {
        const auto& hit = rays_.hit;
        copy(hit.geomID, found.geometry, first);
        copy(hit.primID, found.primitive, first);
        copy(rays_.ray.tfar, found.t, first);
        copy(hit.u, found.u, first);
        copy(hit.v, found.v, first);
        copy(hit.Ng_x, found.ng.x, first);
        copy(hit.Ng_y, found.ng.y, first);
        copy(hit.Ng_z, found.ng.z, first);
    }

 private:
    void set(std::size_t i, const Ray& ray) {
        rays_.ray.org_x[i] = ray.origin.x;
        rays_.ray.org_y[i] = ray.origin.y;
        rays_.ray.org_z[i] = ray.origin.z;
        rays_.ray.dir_x[i] = ray.direction.x;
        rays_.ray.dir_y[i] = ray.direction.y;
        rays_.ray.dir_z[i] = ray.direction.z;
        rays_.ray.tfar[i] = ray.t_max;
    }

    static void copy(const Lanes<float>& from, std::size_t first, float* to) {
        std::copy_n(from.data() + first, N, to);
    }
    template <typename T>
    static void copy(const T* from, Lanes<T>& to, std::size_t first) {
        std::copy_n(from, N, to.data() + first);
    }

    // Of Embree's types this has the layout of those for one ray and for packets of 4, 8 and 16.
    alignas(64) RTCRayHitNt<N> rays_;
    alignas(64) std::array<int, N> valid_;
};

}  // namespace plumbline
