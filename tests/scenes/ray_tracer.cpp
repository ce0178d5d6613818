// SPDX-License-Identifier: Apache-2.0
#include "scenes/ray_tracer.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

namespace plumbline {
namespace {

World world_of(const Object& object, const Material& material) {
    Scene scene;
    scene.name = "test";
    scene.materials = {material};
    scene.objects = {object};
    return world_at(scene, 0);
}

Object object_of(const std::variant<std::monostate, Box, Quad, Sphere, MeshInstance>& shape,
                 const Transform& rest = {}) {
    Object object;
    object.name = "object";
    object.rest = rest;
    object.shape = shape;
    return object;
}

const Quad unit_floor{{-1.f, 0.f, -1.f}, {0.f, 0.f, 2.f}, {2.f, 0.f, 0.f}, 0};

glm::vec3 unit_direction(std::mt19937& random) {
    std::normal_distribution<float> normal;
    return glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
}

}  // namespace

TEST_CASE("a ray meets the front of a quad where it should", "[scenes][rays]") {
    const World world = world_of(object_of(unit_floor), {});
    const RayTracer tracer(world);
    const auto hit = tracer.intersect({{0.25f, 3.f, 0.5f}, {0.f, -1.f, 0.f}}, BackFaces::Hit);
    REQUIRE(hit);
    CHECK(hit->t == Approx(3.f));
    CHECK(hit->position.x == Approx(0.25f));
    CHECK(hit->position.z == Approx(0.5f));
    CHECK(hit->ng.y == Approx(1.f));
    CHECK_FALSE(hit->back);
    CHECK(hit->n().y == Approx(1.f));
}

TEST_CASE("a ray that starts exactly on a surface does not meet it", "[scenes][rays]") {
    // As do the rays of probes in a grid layer that is level with a block's top.
    const World world = world_of(object_of(Box{{-1, 0, -1}, {1, 1, 1}, {}}), {});
    const RayTracer tracer(world);
    const glm::vec3 on_top(0.25f, 1.f, 0.5f);
    const glm::vec3 down = glm::normalize(glm::vec3(0.3f, -0.8f, 0.1f));
    CHECK_FALSE(tracer.intersect({on_top, down}, BackFaces::Cull));
    CHECK_FALSE(tracer.intersect({on_top, -down}, BackFaces::Cull));
    const auto inside = tracer.intersect({on_top, down}, BackFaces::Hit);
    REQUIRE(inside);
    CHECK(inside->back);
    CHECK(inside->t == Approx(1.f / -down.y));
    CHECK_FALSE(tracer.occluded(on_top, {0.25f, 3.f, 0.5f}));
}

TEST_CASE("the back of a surface is culled only if it is one-sided and culling is asked for",
          "[scenes][rays]") {
    const bool two_sided = GENERATE(false, true);
    Material material;
    material.two_sided = two_sided;
    const World world = world_of(object_of(unit_floor), material);
    const RayTracer tracer(world);
    const Ray up{{0.1f, -2.f, 0.2f}, {0.f, 1.f, 0.f}};
    CHECK(tracer.intersect(up, BackFaces::Cull).has_value() == two_sided);
    const auto hit = tracer.intersect(up, BackFaces::Hit);
    REQUIRE(hit);
    CHECK(hit->back);
    CHECK(hit->n().y == Approx(-1.f));
    CHECK(tracer.occluded({0.1f, -2.f, 0.2f}, {0.1f, 2.f, 0.2f}));
}

TEST_CASE("of a mesh of several materials each triangle is culled by its own", "[scenes][rays]") {
    Scene scene;
    scene.name = "test";
    scene.materials.resize(2);
    scene.materials[1].two_sided = true;
    Mesh mesh;
    mesh.positions = {{0.f, 0.f, 0.f}, {0.f, 0.f, 1.f}, {1.f, 0.f, 0.f}, {1.f, 0.f, 1.f}};
    mesh.triangles = {{0, 1, 2}, {2, 1, 3}};  // fronts up
    mesh.triangle_materials = {0, 1};
    scene.meshes = {mesh};
    scene.objects = {object_of(MeshInstance{0})};
    const World world = world_at(scene, 0);
    const RayTracer tracer(world);
    const glm::vec3 up(0.f, 1.f, 0.f);
    CHECK_FALSE(tracer.intersect({{.2f, -1.f, .2f}, up}, BackFaces::Cull));
    CHECK(tracer.intersect({{.8f, -1.f, .8f}, up}, BackFaces::Cull));
    CHECK(tracer.intersect({{.2f, 1.f, .2f}, -up}, BackFaces::Cull));
    CHECK(tracer.intersect({{.8f, 1.f, .8f}, -up}, BackFaces::Cull));
}

TEST_CASE("an inward sphere shows its front inside and its back outside", "[scenes][rays]") {
    const World world = world_of(object_of(Sphere{{1.f, 2.f, 3.f}, 2.f, true, 0}), {});
    const RayTracer tracer(world);
    const auto inside = tracer.intersect({{1.f, 2.f, 3.f}, {0.f, 0.f, 1.f}}, BackFaces::Cull);
    REQUIRE(inside);
    CHECK(inside->position.z == Approx(5.f));
    CHECK(inside->ng.z == Approx(-1.f));
    const auto through = tracer.intersect({{1.f, 2.f, -9.f}, {0.f, 0.f, 1.f}}, BackFaces::Cull);
    REQUIRE(through);  // past the near back to the far front
    CHECK(through->position.z == Approx(5.f));
    CHECK_FALSE(through->back);
}

TEST_CASE("a sphere that is scaled unevenly makes no world", "[scenes][rays]") {
    const Sphere ball{{0.f, 0.f, 0.f}, 1.f, false, 0};
    Transform scaled;
    scaled.scale = glm::vec3(2.f);
    CHECK(world_of(object_of(ball, scaled), {}).spheres.front().radius == 2.f);
    scaled.scale.y = 2.01f;
    CHECK_THROWS_WITH(world_of(object_of(ball, scaled), {}),
                      Catch::Contains("a sphere is scaled unevenly (2, 2.01, 2)"));
}

TEST_CASE("a mirrored box still faces outward", "[scenes][rays]") {
    Transform mirrored;
    mirrored.scale = {-1.f, 2.f, 0.5f};
    const Box box{{-1.f, -1.f, -1.f}, {1.f, 1.f, 1.f}, {0, 0, 0, 0, 0, 0}};
    const World world = world_of(object_of(box, mirrored), {});
    const RayTracer tracer(world);
    std::mt19937 random(1);
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 direction = unit_direction(random);
        const auto hit = tracer.intersect({-5.f * direction, direction}, BackFaces::Hit);
        REQUIRE(hit);
        CHECK_FALSE(hit->back);
    }
}

TEST_CASE("a point on a surface is not hidden by that surface at any scale", "[scenes][rays]") {
    // From a random point on a box's inside every point inside is visible: a box is convex.
    const float scale = GENERATE(1e-4f, 1.f, 1e4f);
    const float shift = GENERATE(0.f, 10.f, 1000.f);
    Transform placed;
    placed.scale = glm::vec3(-scale);  // turned inside out below by two-sidedness
    placed.rotation = glm::angleAxis(0.7f, glm::normalize(glm::vec3(1.f, 2.f, 3.f)));
    placed.translation = glm::vec3(shift * scale);
    Material material;
    material.two_sided = true;
    const Box box{{-1.f, -1.f, -1.f}, {1.f, 1.f, 1.f}, {0, 0, 0, 0, 0, 0}};
    const World world = world_of(object_of(box, placed), material);
    const RayTracer tracer(world);
    std::mt19937 random(Catch::rngSeed() + 7);
    // A start within the error of an edge may lie beyond the neighbouring face: 16 roundings of
    // coordinates of this size.
    const float error = 16.f * 0x1p-24f * (shift + 2.f);
    const auto near_edge = [&](const glm::vec3& position) {
        const glm::vec3 local =
            glm::abs(glm::inverse(placed.rotation) * (position - placed.translation) / scale);
        const int close =
            int(local.x > 1.f - error) + int(local.y > 1.f - error) + int(local.z > 1.f - error);
        return close > 1;
    };
    std::size_t blocked = 0;
    std::size_t escaped = 0;
    std::size_t tried = 0;
    for (int i = 0; i < 20000; ++i) {
        const Ray ray{placed.translation, unit_direction(random)};
        const auto hit = tracer.intersect(ray, BackFaces::Hit);
        REQUIRE(hit);
        if (near_edge(hit->position)) continue;
        ++tried;
        const glm::vec3 start = offset_origin(*hit, hit->n());
        blocked += tracer.occluded(start, placed.translation) ? 1u : 0u;
        glm::vec3 onward = unit_direction(random);
        if (glm::dot(onward, hit->n()) < 0.f) onward = -onward;
        const auto next = tracer.intersect({start, onward}, BackFaces::Hit);
        escaped += next.has_value() && next->n() != hit->n() ? 0u : 1u;
    }
    CHECK(tried > 19000);
    CHECK(blocked == 0);
    CHECK(escaped == 0);
}

TEST_CASE("a light that lies on a surface is not hidden by it", "[scenes][rays]") {
    const World world = world_of(object_of(unit_floor), {});
    const RayTracer tracer(world);
    CHECK_FALSE(tracer.occluded({0.3f, 2.f, 0.1f}, {0.f, 0.f, 0.f}));
}

}  // namespace plumbline
