// SPDX-License-Identifier: Apache-2.0
#include "ddgi/moved_rays.h"

#include <catch2/catch.hpp>
#include <random>

#include "ddgi/direct_light.h"
#include "ddgi/seen_probes.h"
#include "ddgi/shaft.h"
#include "tests/ddgi/small_scenes.h"

using namespace plumbline;
using namespace plumbline::ddgi;

namespace {

constexpr std::size_t ray_count = 4096;

glm::vec3 random_point(std::mt19937& engine, float reach) {
    std::uniform_real_distribution<float> uniform(-reach, reach);
    const float x = uniform(engine);
    const float y = uniform(engine);
    return {x, y, uniform(engine)};
}

/// One probe's rays from `origin` to random ends.
ProbeRays random_rays(const glm::vec3& origin, std::vector<glm::vec3>& ends, std::mt19937& engine) {
    ProbeRays rays(1, ray_count);
    for (std::size_t i = 0; i < ray_count; ++i) {
        ends.push_back(random_point(engine, 2.f));
        const glm::vec3 way = ends.back() - origin;
        rays.set_direction(0, i, glm::normalize(way));
        rays.set_end(0, i, glm::length(way), &ends.back());
    }
    return rays;
}

/// The largest distance by which a point of the segment lies within the box, by many points of it;
/// negative: how far the nearest is outside.
double depth_in(const OrientedBox& box, const glm::vec3& a, const glm::vec3& b) {
    constexpr int points = 400;
    double deepest = -1e30;
    for (int i = 0; i <= points; ++i) {
        const glm::dvec3 p = glm::dmat3(glm::transpose(box.axes)) *
                             glm::mix(glm::dvec3(a), glm::dvec3(b), double(i) / points);
        const glm::dvec3 inside =
            glm::min(p - glm::dvec3(box.bounds.lower), glm::dvec3(box.bounds.upper) - p);
        deepest = std::max(deepest, std::min({inside.x, inside.y, inside.z}));
    }
    return deepest;
}

/// The room with a block, at two frames between which the block moved.
struct TwoFrames {
    Scene scene = room_with_moving_block();
    World before = world_at(scene, 3);
    World after = world_at(scene, 4);
    Motion motion = motion_between(before, after);
};

}  // namespace

TEST_CASE("of rays those that meet an oriented box are marked and no others", "[ddgi]") {
    std::mt19937 engine(3);
    const glm::vec3 axis = glm::normalize(glm::vec3(1.f, 2.f, -1.f));
    OrientedBox box;
    box.axes = glm::mat3(glm::mat3_cast(glm::angleAxis(.7f, axis)));
    box.bounds = {glm::vec3(-.3f, -.5f, .1f), glm::vec3(.6f, .2f, .7f)};
    for (const glm::vec3& origin :
         {glm::vec3(-1.f, .5f, 1.5f), box.axes * glm::vec3(.1f, 0.f, .3f)}) {
        std::vector<glm::vec3> ends;
        const ProbeRays rays = random_rays(origin, ends, engine);
        std::vector<std::uint8_t> marks(ray_count, 1);
        rays.mark_rays(0, origin, box, 4, marks);
        std::size_t met = 0;
        for (std::size_t i = 0; i < ray_count; ++i) {
            const double depth = depth_in(box, origin, ends[i]);
            if (depth > 0.) CHECK(marks[i] == 5);
            if (depth < -.02) CHECK(marks[i] == 1);  // the points of the segment are .01 apart
            if (depth > 0.) ++met;
        }
        CHECK(met > 100);
    }
}

TEST_CASE("light is asked for again wherever a moved block changed it and hardly elsewhere",
          "[ddgi]") {
    std::mt19937 engine(5);
    const TwoFrames frames;
    REQUIRE(frames.motion.solids.size() == 1);
    const RayTracer before(frames.before);
    const RayTracer after(frames.after);
    std::vector<glm::vec3> ends;
    const ProbeRays rays = random_rays(glm::vec3(0.f), ends, engine);
    const glm::vec3& lamp = frames.after.lights[0].position;
    const std::vector<LampWay> ways = lamp_ways(frames.after, frames.motion);
    REQUIRE(ways.size() == 1);
    std::vector<std::uint8_t> marks(ray_count, 0);
    rays.mark_shadows(0, ways[0], frames.motion.oriented_boxes, 2, marks);
    std::size_t changed = 0;
    std::size_t marked = 0;
    for (std::size_t i = 0; i < ray_count; ++i) {
        if (max_component(glm::abs(ends[i])) > .99f) continue;  // in a wall or beyond
        const bool was = before.occluded(ends[i], lamp);
        const bool is = after.occluded(ends[i], lamp);
        if (was != is) CHECK(marks[i] == 2);
        changed += was != is ? 1 : 0;
        marked += marks[i] == 2 ? 1 : 0;
    }
    CHECK(changed > 5);
    CHECK(marked < 4 * changed);  // by the boxes alone it would be most of what the block hides
}

TEST_CASE("a block that holds the light or lacks a face is no solid one", "[ddgi]") {
    TwoFrames frames;
    frames.after.lights[0].position =
        glm::vec3(frames.after.objects.back().to_world * glm::vec4(.2f, 0.f, 0.f, 1.f));
    CHECK(lamp_ways(frames.after, frames.motion)[0].solids.empty());
    for (World* world : {&frames.before, &frames.after}) {
        auto& triangles = world->meshes.back().triangles;
        triangles.back() = triangles[triangles.size() - 2];
    }
    CHECK(motion_between(frames.before, frames.after).solids.empty());
}

TEST_CASE("a shaft tells of many ways to a light together what each meets", "[ddgi]") {
    std::mt19937 engine(11);
    const OrientedBox block = TwoFrames().motion.now.at(0).box;
    int all = 0;
    int none = 0;
    for (int round = 0; round < 800; ++round) {
        const bool sun = round % 2 != 0;
        const glm::vec3 aim = random_point(engine, 1.5f);
        const LampWay light =
            sun ? LampWay{.direction = aim, .length = 10.f} : LampWay{.position = aim};
        const glm::vec3 middle = random_point(engine, 1.5f);
        const float reach = .04f;
        const Shaft shaft(light, block, middle, reach);
        for (int i = 0; i < 50; ++i) {
            const glm::vec3 from = middle + random_point(engine, reach);
            const double depth = depth_in(block, from, sun ? from + light.length * aim : aim);
            if (depth > 0.) CHECK(shaft.may_meet(block.bounds));
            // Points of the way are looked at, so that its deepest may be missed.
            if (depth < -.01) CHECK(!shaft.all_meet(block.bounds));
        }
        all += shaft.all_meet(block.bounds) ? 1 : 0;
        none += shaft.may_meet(block.bounds) ? 0 : 1;
    }
    CHECK(all > 5);
    CHECK(none > 50);
}

TEST_CASE("rays from inside a block pass it only if it shows its one side outward", "[ddgi]") {
    TwoFrames frames;
    REQUIRE(frames.motion.now.size() == 1);
    CHECK(!frames.motion.now[0].inside.bounds.empty());
    WorldMesh& block = frames.after.meshes.back();
    const auto inside = [&] {
        return motion_between(frames.before, frames.after).now.at(0).inside;
    };
    for (glm::uvec3& triangle : block.triangles) std::swap(triangle.y, triangle.z);
    CHECK(inside().bounds.empty());
    for (glm::uvec3& triangle : block.triangles) std::swap(triangle.y, triangle.z);
    CHECK(!inside().bounds.empty());
    frames.after.materials[std::size_t(block.triangle_materials[0])].two_sided = true;
    CHECK(inside().bounds.empty());
}

TEST_CASE("points asked together get the light and see the probes that they do alone", "[ddgi]") {
    std::mt19937 engine(9);
    Scene scene = room_with_moving_block();
    PointLight lamp = scene.lights[0];
    lamp.position = {-.5f, .3f, .6f};
    lamp.radius = .1f;
    scene.lights.push_back(lamp);
    lamp.radius = 0.f;
    lamp.cone = SpotCone{{1.f, -1.f, 0.f}, .3f, .9f};
    scene.lights.push_back(lamp);
    scene.directional_lights = {{"sun", {1.f, -2.f, .3f}, Spectrum(2.f)}};
    const World world = world_at(scene, 3);
    const RayTracer tracer(world);
    std::vector<glm::vec3> x, n;
    for (int i = 0; i < 500; ++i) {
        x.push_back(random_point(engine, .99f));
        n.push_back(glm::normalize(random_point(engine, 1.f)));
    }
    std::vector<DirectLight> light(x.size());
    direct_light(tracer, x, n, light);
    std::vector<std::uint8_t> seen(x.size());
    CellPlanes planes(*scene.probes);
    planes.take(world);
    seen_probes(tracer, *scene.probes, planes, x, n, seen);
    std::size_t lit = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const DirectLight alone = direct_light(tracer, x[i], n[i]);
        CHECK(light[i].irradiance == alone.irradiance);
        CHECK(light[i].shadow_rays == alone.shadow_rays);
        CHECK(seen[i] == seen_probes(tracer, *scene.probes, x[i], n[i]));
        if (alone.irradiance != Spectrum(0.f)) ++lit;
    }
    CHECK(lit > 100);
}
