// SPDX-License-Identifier: Apache-2.0
// What a ray meets depends neither on how many rays are traced together nor on which, but where two
// surfaces lie at the same distance to rounding: on edges, and where faces lie in one plane.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "scenes/camera_rays.h"
#include "scenes/ray_tracer.h"
#include "scenes/scene_files.h"

namespace plumbline {
namespace {

bool same_bits(const glm::vec3& a, const glm::vec3& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

bool same(const std::optional<Hit>& a, const std::optional<Hit>& b) {
    if (a.has_value() != b.has_value()) return false;
    return !a || (a->t == b->t && same_bits(a->position, b->position) &&
                  a->position_error == b->position_error && same_bits(a->ng, b->ng) &&
                  a->back == b->back && a->object == b->object && a->material == b->material &&
                  same_bits(a->albedo, b->albedo));
}

/// Two surfaces at one distance: either may be met.
bool at_one_distance(const std::optional<Hit>& a, const std::optional<Hit>& b) {
    return a && b && std::abs(a->t - b->t) <= 4.f * (a->position_error + b->position_error);
}

/// Rays through pixels in order, then from what they meet into random directions, and from there.
std::vector<Ray> rays_in(const RayTracer& tracer) {
    std::mt19937 random(5);
    std::normal_distribution<float> normal;
    const Camera& camera = tracer.world().camera;
    const CameraRays camera_rays(camera);
    std::vector<Ray> rays;
    for (int y = 0; y < camera.height; ++y) {
        for (int x = 0; x < camera.width; ++x) {
            rays.push_back(camera_rays.through(static_cast<float>(x), static_cast<float>(y)));
        }
    }
    const std::size_t most = 3 * rays.size();
    for (std::size_t i = 0; i < rays.size() && rays.size() < most; ++i) {
        const auto hit = tracer.intersect(rays[i], BackFaces::Cull);
        if (!hit) continue;
        const glm::vec3 direction(normal(random), normal(random), normal(random));
        rays.push_back({offset_origin(*hit, hit->n()), glm::normalize(direction)});
    }
    return rays;
}

/// Calls f(first, size) for rays, lane_count at a time.
template <typename Function>
void for_each_lanes(std::size_t rays, const Function& f) {
    for (std::size_t first = 0; first < rays; first += lane_count) {
        f(first, std::min(lane_count, rays - first));
    }
}

/// What the tracer answers for `rays` in lanes.
std::vector<std::optional<Hit>> hits_of(const RayTracer& tracer, const std::vector<Ray>& rays,
                                        BackFaces back_faces, Coherence coherence) {
    std::vector<std::optional<Hit>> hits(rays.size());
    for_each_lanes(rays.size(), [&](std::size_t first, std::size_t size) {
        RayLanes lanes;
        for (std::size_t i = 0; i < size; ++i) lanes.push(rays[first + i]);
        HitLanes found;
        tracer.intersect(lanes, back_faces, coherence, found);
        for (std::size_t i = 0; i < found.count; ++i) hits[first + found.ray[i]] = found[i];
    });
    return hits;
}

Scene small(Scene scene) {
    scene.camera.width = 160;
    scene.camera.height = 90;
    return scene;
}

}  // namespace

TEST_CASE("packets of any width answer as single rays do but for ties", "[scenes][rays]") {
    const std::string name = GENERATE("cornell-box", "room-with-door", "furnace");
    const int width = GENERATE(1, 4, 8, 16);
    const World world = world_at(small(load_scene(name)), 0);
    const RayTracer tracer(world, width);
    const std::vector<Ray> rays = rays_in(tracer);
    const auto back_faces = GENERATE(BackFaces::Cull, BackFaces::Hit);
    const auto coherence = GENERATE(Coherence::Coherent, Coherence::Incoherent);
    const auto hits = hits_of(tracer, rays, back_faces, coherence);
    std::size_t different = 0, ties = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const auto single = tracer.intersect(rays[i], back_faces);
        if (same(hits[i], single)) continue;
        ++(at_one_distance(hits[i], single) ? ties : different);
    }
    CHECK(different == 0);
    // A row of pixels' corners runs along edges of these symmetric scenes: 77 of 43,200.
    CHECK(ties < rays.size() / 200);
}

TEST_CASE("packets of any width see the same shadows as single rays", "[scenes][rays]") {
    const std::string name = GENERATE("cornell-box", "room-with-door", "furnace");
    const int width = GENERATE(1, 4, 8, 16);
    const World world = world_at(small(load_scene(name)), 0);
    const RayTracer tracer(world, width);
    const std::vector<Ray> rays = rays_in(tracer);
    // Between the starts of rays, and from one to itself, where nothing can lie between.
    std::vector<Segment> segments;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        segments.push_back({rays[i].origin, rays[i * 7 % rays.size()].origin});
    }
    std::vector<bool> hidden;
    for_each_lanes(segments.size(), [&](std::size_t first, std::size_t size) {
        SegmentLanes lanes;
        for (std::size_t i = 0; i < size; ++i) lanes.push(segments[first + i]);
        Lanes<std::int32_t> answers;
        tracer.occluded(lanes, answers);
        hidden.insert(hidden.end(), answers.begin(), answers.begin() + std::ptrdiff_t(size));
    });
    std::size_t different = 0, behind = 0;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        different += hidden[i] == tracer.occluded(segments[i].a, segments[i].b) ? 0u : 1u;
        behind += hidden[i] ? 1u : 0u;
    }
    CHECK(different == 0);
    CHECK(behind > 0);
    CHECK(behind < segments.size());
}

TEST_CASE("a ray in a packet does not meet the surface that it starts on", "[scenes][rays]") {
    Scene scene;
    scene.name = "floor";
    scene.materials = {{}};
    Object object;
    object.name = "floor";
    object.shape = Quad{{-1.f, 0.f, -1.f}, {0.f, 0.f, 2.f}, {2.f, 0.f, 0.f}, 0};
    scene.objects = {object};
    const World world = world_at(scene, 0);
    const RayTracer tracer(world, GENERATE(1, 4, 8, 16));
    const glm::vec3 down = glm::normalize(glm::vec3(.3f, -.8f, .1f));
    const std::vector<Ray> rays(21, {{.25f, 0.f, .5f}, down});
    for (const auto& hit : hits_of(tracer, rays, BackFaces::Hit, Coherence::Incoherent)) {
        CHECK_FALSE(hit);
    }
}

}  // namespace plumbline
