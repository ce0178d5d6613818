// SPDX-License-Identifier: Apache-2.0
#include "scenes/ray_tracer.h"

#include <cassert>
#include <cmath>
#include <limits>

#include "scenes/embree_scene.h"
#include "scenes/ray_packets.h"

namespace plumbline {
namespace {

struct CullingContext {
    RTCIntersectContext embree;  // first: Embree hands this pointer to the filter
    const EmbreeScene* scene;
};

/// Rejects hits on backs of one-sided materials.
void cull_backs(const RTCFilterFunctionNArguments* args) {
    const auto* context = reinterpret_cast<const CullingContext*>(args->context);
    const unsigned n = args->N;
    for (unsigned i = 0; i < n; ++i) {
        if (args->valid[i] == 0) continue;
        const glm::vec3 direction(RTCRayN_dir_x(args->ray, n, i), RTCRayN_dir_y(args->ray, n, i),
                                  RTCRayN_dir_z(args->ray, n, i));
        const EmbreeScene::Found found{
            .geometry = RTCHitN_geomID(args->hit, n, i),
            .primitive = RTCHitN_primID(args->hit, n, i),
            .t = RTCRayN_tfar(args->ray, n, i),
            .u = RTCHitN_u(args->hit, n, i),
            .v = RTCHitN_v(args->hit, n, i),
            .ng = {RTCHitN_Ng_x(args->hit, n, i), RTCHitN_Ng_y(args->hit, n, i),
                   RTCHitN_Ng_z(args->hit, n, i)}};
        if (context->scene->is_culled(direction, found)) args->valid[i] = 0;
    }
}

CullingContext context_for(const EmbreeScene& scene, BackFaces back_faces, Coherence coherence) {
    CullingContext context;
    rtcInitIntersectContext(&context.embree);
    context.scene = &scene;
    if (back_faces == BackFaces::Cull) context.embree.filter = cull_backs;
    if (coherence == Coherence::Coherent) {
        context.embree.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    }
    return context;
}

int widest_native(RTCDevice device) {
    if (rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED) != 0) return 16;
    if (rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED) != 0) return 8;
    return 4;
}

/// Calls `f` with packets of the width that is nearest to `width`, f.template operator()<Packet>().
template <typename Function>
void with_width(int width, const Function& f) {
    switch (width) {
        case 16:
            return f.template operator()<Packet<16>>();
        case 8:
            return f.template operator()<Packet<8>>();
        case 4:
            return f.template operator()<Packet<4>>();
        default:
            return f.template operator()<Packet<1>>();
    }
}

}  // namespace

glm::vec3 offset_origin(const Hit& hit, const glm::vec3& n) {
    // The error box seen along n: beyond it the point is on the side of n for sure.
    const glm::vec3 size = glm::abs(n);
    return hit.position + n * (hit.position_error * (size.x + size.y + size.z));
}

RayTracer::RayTracer(const World& world)
    : world_(world),
      embree_(std::make_unique<EmbreeScene>(world)),
      packet_width_(widest_native(embree_->device())) {}

RayTracer::RayTracer(const World& world, int packet_width)
    : world_(world), embree_(std::make_unique<EmbreeScene>(world)), packet_width_(packet_width) {}

RayTracer::~RayTracer() = default;

void RayTracer::intersect(std::span<const Ray> rays, BackFaces back_faces, Coherence coherence,
                          std::span<std::optional<Hit>> hits) const {
    assert(rays.size() == hits.size());
    CullingContext context = context_for(*embree_, back_faces, coherence);
    with_width(packet_width_, [&]<typename P>() {
        P packet;
        for (std::size_t first = 0; first < rays.size(); first += P::width) {
            const auto part = rays.subspan(first, std::min(P::width, rays.size() - first));
            packet.load(part);
            packet.intersect(embree_->scene(), context.embree);
            for (std::size_t i = 0; i < part.size(); ++i) {
                if (packet.found(i)) {
                    hits[first + i] = embree_->hit(part[i], packet.hit(i));
                } else {
                    hits[first + i].reset();
                }
            }
        }
    });
}

void RayTracer::occluded(std::span<const Segment> segments, std::span<bool> hidden) const {
    assert(segments.size() == hidden.size());
    CullingContext context = context_for(*embree_, BackFaces::Hit, Coherence::Incoherent);
    with_width(packet_width_, [&]<typename P>() {
        P packet;
        for (std::size_t first = 0; first < segments.size(); first += P::width) {
            const std::size_t count = std::min(P::width, segments.size() - first);
            packet.load(segments.subspan(first, count));
            packet.occluded(embree_->scene(), context.embree);
            for (std::size_t i = 0; i < count; ++i) hidden[first + i] = packet.hidden(i);
        }
    });
}

std::optional<Hit> RayTracer::intersect(const Ray& ray, BackFaces back_faces) const {
    CullingContext context = context_for(*embree_, back_faces, Coherence::Incoherent);
    Packet<1> packet;
    packet.load({&ray, 1});
    packet.intersect(embree_->scene(), context.embree);
    if (!packet.found(0)) return std::nullopt;
    return embree_->hit(ray, packet.hit(0));
}

bool RayTracer::occluded(const glm::vec3& a, const glm::vec3& b) const {
    CullingContext context = context_for(*embree_, BackFaces::Hit, Coherence::Incoherent);
    const Segment segment{a, b};
    Packet<1> packet;
    packet.load({&segment, 1});
    packet.occluded(embree_->scene(), context.embree);
    return packet.hidden(0);
}

}  // namespace plumbline
