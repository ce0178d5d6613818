// SPDX-License-Identifier: Apache-2.0
#include "scenes/ray_tracer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "scenes/embree_scene.h"
#include "scenes/ray_packets.h"
#include "scenes/wide.h"

namespace plumbline {
namespace {

constexpr std::size_t most_in_packet = 16;

RTCIntersectContext embree_context(Coherence coherence) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    if (coherence == Coherence::Coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    return context;
}

/// What each ray of a packet met nearest so far.
struct NearestContext {
    RTCIntersectContext embree;  // first: Embree hands this pointer to the filter
    const EmbreeScene* scene;
    std::array<float, most_in_packet> t;
    std::array<unsigned, most_in_packet> geometry, primitive;

    /// To be called before each packet of `rays`.
    void begin(std::size_t rays) { std::fill_n(t.begin(), rays, -1.f); }
    bool is_later(std::size_t i, const EmbreeScene::Found& found) const {
        return found.t == t[i] &&
               std::tie(found.geometry, found.primitive) > std::tie(geometry[i], primitive[i]);
    }
    void set(std::size_t i, const EmbreeScene::Found& found) {
        t[i] = found.t;
        geometry[i] = found.geometry;
        primitive[i] = found.primitive;
    }
};

/// Rejects hits on backs of one-sided materials; and of surfaces that lie at the very same distance
/// a ray meets the first in order: else the rest of the scene would say which, by the shape of the
/// BVH.
void cull_backs_and_ties(const RTCFilterFunctionNArguments* args) {
    auto* nearest = reinterpret_cast<NearestContext*>(args->context);
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
        if (nearest->scene->is_culled(direction, found) || nearest->is_later(i, found)) {
            args->valid[i] = 0;
        } else {
            nearest->set(i, found);
        }
    }
}

NearestContext nearest_context(const EmbreeScene& scene, BackFaces back_faces,
                               Coherence coherence) {
    NearestContext context;
    context.embree = embree_context(coherence);
    context.scene = &scene;
    if (back_faces == BackFaces::Cull) context.embree.filter = cull_backs_and_ties;
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

PLUMBLINE_WIDE void ways_along(const SegmentLanes& segments, RayLanes& ways) {
    ways.count = segments.count;
#pragma GCC ivdep
    for (std::size_t i = 0; i < segments.count; ++i) ways.set(i, way_along(segments[i]));
}

}  // namespace

RayTracer::RayTracer(const World& world)
    : world_(world),
      embree_(std::make_unique<EmbreeScene>(world)),
      packet_width_(widest_native(embree_->device())) {}

RayTracer::RayTracer(const World& world, int packet_width)
    : world_(world), embree_(std::make_unique<EmbreeScene>(world)), packet_width_(packet_width) {}

RayTracer::~RayTracer() = default;

void RayTracer::intersect(const RayLanes& rays, BackFaces back_faces, Coherence coherence,
                          HitLanes& hits) const {
    NearestContext context = nearest_context(*embree_, back_faces, coherence);
    EmbreeScene::FoundLanes found;
    // Where rays part, Embree follows those of a packet one by one, but asks the filter about the
    // whole packet each time.
    const bool one_by_one = back_faces == BackFaces::Cull && coherence == Coherence::Incoherent;
    with_width(one_by_one ? 1 : packet_width_, [&]<typename P>() {
        P packet;
        for (std::size_t first = 0; first < rays.count; first += P::width) {
            packet.load(rays, first);
            context.begin(P::width);
            packet.intersect(embree_->scene(), context.embree);
            packet.store(found, first);
        }
    });
    embree_->hits(rays, found, hits);
}

void RayTracer::occluded(const SegmentLanes& segments, Lanes<std::int32_t>& hidden) const {
    RTCIntersectContext context = embree_context(Coherence::Incoherent);
    RayLanes ways;
    ways_along(segments, ways);
    with_width(packet_width_, [&]<typename P>() {
        P packet;
        for (std::size_t first = 0; first < ways.count; first += P::width) {
            packet.load(ways, first);
            packet.occluded(embree_->scene(), context);
            for (std::size_t i = 0; i < P::width; ++i) hidden[first + i] = packet.hidden(i);
        }
    });
}

std::optional<Hit> RayTracer::intersect(const Ray& ray, BackFaces back_faces) const {
    NearestContext context = nearest_context(*embree_, back_faces, Coherence::Incoherent);
    context.begin(1);
    Packet<1> packet;
    packet.load(ray);
    packet.intersect(embree_->scene(), context.embree);
    if (!packet.found(0)) return std::nullopt;
    return embree_->hit(ray, packet.hit(0));
}

bool RayTracer::occluded(const glm::vec3& a, const glm::vec3& b) const {
    RTCIntersectContext context = embree_context(Coherence::Incoherent);
    Packet<1> packet;
    packet.load(way_along({a, b}));
    packet.occluded(embree_->scene(), context);
    return packet.hidden(0);
}

}  // namespace plumbline
