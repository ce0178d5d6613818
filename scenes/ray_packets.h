// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <embree3/rtcore.h>

#include <array>
#include <limits>
#include <span>

#include "scenes/embree_scene.h"

namespace plumbline {

/// Up to `N` rays that Embree traces together: N = 1, 4, 8 or 16. A ray's answer depends on the
/// others only where two surfaces lie at the same distance to rounding: which of them it meets.
/// Hence callers make packets from the same rays at any thread count and in any shard.
template <std::size_t N>
class Packet {
 public:
    static constexpr std::size_t width = N;

    void load(std::span<const Ray> rays) {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            set(i, rays[i].origin, rays[i].direction, rays[i].t_max);
        }
        for (std::size_t i = rays.size(); i < N; ++i) valid_[i] = 0;
    }

    void load(std::span<const Segment> segments) {
        for (std::size_t i = 0; i < segments.size(); ++i) {
            const auto& [a, b] = segments[i];
            // A surface that `b` lies on is not between: its distance is known to within this much.
            const glm::vec3 way = b - a;
            const float error =
                position_error(glm::max(largest_coordinate(a), largest_coordinate(b)));
            const float t_max = 1.f - 2.f * error / glm::length(way);
            set(i, a, way, t_max);
            // Points nearer than floats can tell apart, or the same, have nothing between them.
            if (!(t_max > 0.f)) valid_[i] = 0;
        }
        for (std::size_t i = segments.size(); i < N; ++i) valid_[i] = 0;
    }

    void intersect(RTCScene scene, RTCIntersectContext& context) {
        for (std::size_t i = 0; i < N; ++i) rays_.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        if constexpr (N == 1) {
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

 private:
    void set(std::size_t i, const glm::vec3& origin, const glm::vec3& direction, float t_max) {
        auto& ray = rays_.ray;
        ray.org_x[i] = origin.x;
        ray.org_y[i] = origin.y;
        ray.org_z[i] = origin.z;
        ray.dir_x[i] = direction.x;
        ray.dir_y[i] = direction.y;
        ray.dir_z[i] = direction.z;
        // Embree counts a surface at tnear as met; a point on a surface is not in front of it.
        ray.tnear[i] = std::numeric_limits<float>::min();
        ray.tfar[i] = t_max;
        ray.time[i] = 0.f;
        ray.mask[i] = ~0u;
        ray.id[i] = 0;
        ray.flags[i] = 0;
        valid_[i] = -1;
    }

    // Of Embree's types this has the layout of those for one ray and for packets of 4, 8 and 16.
    alignas(64) RTCRayHitNt<N> rays_;
    alignas(64) std::array<int, N> valid_;
};

}  // namespace plumbline
