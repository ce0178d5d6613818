// SPDX-License-Identifier: Apache-2.0
// Scenes proven closed, and scenes that are not.
#include "scenes/enclosure.h"

#include <catch2/catch.hpp>
#include <glm/gtc/constants.hpp>
#include <random>

#include "pathtracer/simple_scenes.h"
#include "scenes/ray_tracer.h"
#include "scenes/scene_files.h"
#include "scenes/world.h"

namespace plumbline {
namespace {

Scene room() {
    Scene scene = pathtracer::mixed_room(8, 6);
    scene.environment = {1.f, 2.f, 3.f};
    return scene;
}

/// A ball of 20 triangles whose fronts face its middle.
Scene inward_icosahedron() {
    const float g = (1.f + std::sqrt(5.f)) / 2.f;
    Scene scene;
    scene.materials.emplace_back();
    Mesh mesh;
    mesh.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                      {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
    mesh.triangle_materials.assign(mesh.triangles.size(), 0);
    scene.meshes = {mesh};
    pathtracer::add_object(scene, MeshInstance{0});
    scene.objects[0].rest.rotation = glm::angleAxis(.7f, glm::normalize(glm::vec3(1, 2, 3)));
    scene.camera.eye = {.3f, -.2f, .1f};
    return scene;
}

}  // namespace

TEST_CASE("rooms without a gap that face the camera are proven closed", "[scenes]") {
    CHECK(enclosure(room()).proven);
    CHECK(enclosure(inward_icosahedron()).proven);
    Scene in_block = room();  // through whose backs the camera looks out into the room
    in_block.camera.eye = {-.2f, -.6f, -.3f};
    CHECK(enclosure(in_block).proven);
    Scene ball;
    ball.materials.emplace_back();
    pathtracer::add_object(ball, Sphere{{1.f, 2.f, 3.f}, 2.f, true, 0});
    ball.camera.eye = {1.f, 3.5f, 3.f};
    CHECK(enclosure(ball).proven);
    CHECK(enclosure(load_scene("furnace")).proven);
    CHECK(enclosure(load_scene("integrating-sphere")).proven);
}

TEST_CASE("what has a gap or does not face the camera or may move is not proven closed",
          "[scenes]") {
    SECTION("the camera is outside") {
        Scene scene = room();
        scene.camera.eye = {0.f, 0.f, 1.5f};
        CHECK_FALSE(enclosure(scene).proven);
    }
    SECTION("the camera is in a wall") {
        Scene scene = room();
        scene.camera.eye = {.2f, .1f, 1.f};
        CHECK_FALSE(enclosure(scene).proven);
    }
    SECTION("a wall is missing") {
        Scene scene = room();
        scene.objects.erase(scene.objects.begin() + 2);
        CHECK_FALSE(enclosure(scene).proven);
    }
    SECTION("a wall ends one rounding before the next") {
        Scene scene = room();
        Quad& wall = std::get<Quad>(scene.objects[0].shape);
        wall.corner.x = std::nextafter(wall.corner.x, 2.f);
        CHECK_FALSE(enclosure(scene).proven);
    }
    SECTION("a wall faces away") {
        Scene scene = room();
        Quad& wall = std::get<Quad>(scene.objects[1].shape);
        std::swap(wall.edge_u, wall.edge_v);
        CHECK_FALSE(enclosure(scene).proven);
    }
    SECTION("a wall moves") {
        Scene scene = room();
        scene.frames = 2;
        scene.objects[3].animation.translation = {
            Interpolation::Linear, {0.f, 1.f}, {{0.f, 0.f, 0.f}, {0.f, 3.f, 0.f}}};
        CHECK_FALSE(enclosure(scene).proven);
    }
    SECTION("the room is turned inside out: camera rays see through its backs") {
        Scene scene = room();
        for (std::size_t i = 0; i < 6; ++i) {
            Quad& wall = std::get<Quad>(scene.objects[i].shape);
            std::swap(wall.edge_u, wall.edge_v);
        }
        CHECK_FALSE(enclosure(scene).proven);
    }
    SECTION("open scenes of the library") {
        CHECK_FALSE(enclosure(load_scene("courtyard")).proven);
        CHECK_FALSE(enclosure(load_scene("room-with-door")).proven);
        CHECK_FALSE(enclosure(load_scene("cornell-box")).proven);  // the camera stands outside
    }
}

TEST_CASE("from the camera of a closed scene every ray meets a front", "[scenes]") {
    const Scene scene = GENERATE(room(), inward_icosahedron());
    const World world = world_at(scene, 0);
    const RayTracer tracer(world);
    std::mt19937 random(5);
    std::normal_distribution<float> normal;
    std::size_t missed = 0;
    for (int i = 0; i < 100'000; ++i) {
        const glm::vec3 wi =
            glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
        const auto hit = tracer.intersect({scene.camera.eye, wi}, BackFaces::Cull);
        missed += hit && !hit->back ? 0 : 1;
    }
    CHECK(missed == 0);
}

}  // namespace plumbline
