// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <embree3/rtcore.h>

#include <algorithm>
#include <span>

#include "scenes/world.h"

namespace plumbline::bench {

/// The triangles of a world in Embree, with nothing else around them: no filter, no hit made of an
/// answer. As robust as the renderer's.
class BareEmbree {
 public:
    explicit BareEmbree(const World& world) {
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        for (const WorldMesh& mesh : world.meshes) add(mesh);
        rtcCommitScene(scene_);
    }
    ~BareEmbree() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    BareEmbree(const BareEmbree&) = delete;
    BareEmbree& operator=(const BareEmbree&) = delete;

    /// Traces `rays` N at a time; a value that depends on the answers.
    template <int N>
    float trace(std::span<const Ray> rays, bool any_hit, bool coherent) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        if (coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        alignas(64) RTCRayHitNt<N> packet;
        alignas(64) int valid[N];
        float sum = 0.f;
        for (std::size_t first = 0; first < rays.size(); first += N) {
            for (int i = 0; i < N; ++i) {
                const std::size_t ray = first + std::size_t(i);
                valid[i] = ray < rays.size() ? -1 : 0;
                if (valid[i] != 0) set(packet, i, rays[ray]);
            }
            trace(packet, valid, any_hit, context);
            sum += packet.ray.tfar[0];
        }
        return sum;
    }

 private:
    template <int N>
    static void set(RTCRayHitNt<N>& packet, int i, const Ray& ray) {
        packet.ray.org_x[i] = ray.origin.x;
        packet.ray.org_y[i] = ray.origin.y;
        packet.ray.org_z[i] = ray.origin.z;
        packet.ray.tnear[i] = 0.f;
        packet.ray.dir_x[i] = ray.direction.x;
        packet.ray.dir_y[i] = ray.direction.y;
        packet.ray.dir_z[i] = ray.direction.z;
        packet.ray.time[i] = 0.f;
        packet.ray.tfar[i] = ray.t_max;
        packet.ray.mask[i] = ~0u;
        packet.ray.id[i] = 0u;
        packet.ray.flags[i] = 0u;
        packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    }

    template <int N>
    void trace(RTCRayHitNt<N>& packet, const int* valid, bool any_hit,
               RTCIntersectContext& context) const {
        void* const rays = &packet;
        if constexpr (N == 1) {
            any_hit ? rtcOccluded1(scene_, &context, static_cast<RTCRay*>(rays))
                    : rtcIntersect1(scene_, &context, static_cast<RTCRayHit*>(rays));
        } else if constexpr (N == 4) {
            any_hit ? rtcOccluded4(valid, scene_, &context, static_cast<RTCRay4*>(rays))
                    : rtcIntersect4(valid, scene_, &context, static_cast<RTCRayHit4*>(rays));
        } else if constexpr (N == 8) {
            any_hit ? rtcOccluded8(valid, scene_, &context, static_cast<RTCRay8*>(rays))
                    : rtcIntersect8(valid, scene_, &context, static_cast<RTCRayHit8*>(rays));
        } else {
            any_hit ? rtcOccluded16(valid, scene_, &context, static_cast<RTCRay16*>(rays))
                    : rtcIntersect16(valid, scene_, &context, static_cast<RTCRayHit16*>(rays));
        }
    }

    void add(const WorldMesh& mesh) {
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        void* positions =
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                    sizeof(glm::vec3), mesh.positions.size());
        void* triangles =
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    sizeof(glm::uvec3), mesh.triangles.size());
        std::copy(mesh.positions.begin(), mesh.positions.end(), static_cast<glm::vec3*>(positions));
        std::copy(mesh.triangles.begin(), mesh.triangles.end(),
                  static_cast<glm::uvec3*>(triangles));
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
    }

    RTCDevice device_ = rtcNewDevice(nullptr);
    RTCScene scene_ = rtcNewScene(device_);
};

}  // namespace plumbline::bench
