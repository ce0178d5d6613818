// SPDX-License-Identifier: Apache-2.0
// The built-in scenes against the numbers of [Dellson 2023], worked out here a second time.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scenes/scene_files.h"
#include "scenes/world.h"

using namespace plumbline;

namespace {

// Coordinates reach 700; a float there is exact to 6e-5.
constexpr float tolerance = 2e-4f;

struct Placed {
    const World::Object* object;
    const WorldMesh* mesh;
};

Placed find(const World& world, const std::string& name) {
    for (const WorldMesh& mesh : world.meshes) {
        const World::Object& object = world.objects[std::size_t(mesh.object)];
        if (object.name == name) return {&object, &mesh};
    }
    FAIL("no mesh " << name);
    return {};
}

bool near(const glm::vec3& a, const glm::vec3& b) {
    return glm::all(glm::lessThan(glm::abs(a - b), glm::vec3(tolerance)));
}

bool has_vertex(const WorldMesh& mesh, const glm::vec3& expected) {
    return std::any_of(mesh.positions.begin(), mesh.positions.end(),
                       [&](const glm::vec3& p) { return near(p, expected); });
}

/// The published transform: scale, turn about y (x,z) -> (x cos + z sin, -x sin + z cos), move.
glm::vec3 place(const glm::dvec3& p, const glm::dvec3& scale, double angle, const glm::dvec3& to) {
    const glm::dvec3 s = p * scale;
    return glm::vec3(glm::dvec3(s.x * std::cos(angle) + s.z * std::sin(angle), s.y,
                                -s.x * std::sin(angle) + s.z * std::cos(angle)) +
                     to);
}

void check_box(const World& world, const std::string& name, const glm::dvec3& lower,
               const glm::dvec3& upper, const glm::dvec3& scale, double angle,
               const glm::dvec3& to) {
    const WorldMesh& mesh = *find(world, name).mesh;
    CHECK(mesh.triangles.size() == 12);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p(corner & 1 ? upper.x : lower.x, corner & 2 ? upper.y : lower.y,
                           corner & 4 ? upper.z : lower.z);
        INFO(name << ", corner " << corner);
        CHECK(has_vertex(mesh, place(p, scale, angle, to)));
    }
}

/// A one-sided rectangle: its bounds, normal and albedo.
void check_plane(const World& world, const std::string& name, const Bounds& bounds,
                 const glm::vec3& normal, const Spectrum& albedo) {
    INFO(name);
    const auto [object, mesh] = find(world, name);
    CHECK(object->bounds == bounds);
    REQUIRE(mesh->triangles.size() == 2);
    for (std::size_t t = 0; t < 2; ++t) {
        const glm::uvec3 i = mesh->triangles[t];
        const auto& p = mesh->positions;
        CHECK(near(glm::normalize(glm::cross(p[i.y] - p[i.x], p[i.z] - p[i.x])), normal));
        const Material& material = world.materials[std::size_t(mesh->triangle_materials[t])];
        CHECK(material.albedo == albedo);
        CHECK_FALSE(material.two_sided);
    }
}

/// The albedo of the triangles whose unit normal is `normal`.
Spectrum face_albedo(const World& world, const std::string& name, const glm::vec3& normal) {
    const WorldMesh& mesh = *find(world, name).mesh;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const glm::uvec3 i = mesh.triangles[t];
        const auto& p = mesh.positions;
        const glm::vec3 n = glm::cross(p[i.y] - p[i.x], p[i.z] - p[i.x]);
        if (near(glm::normalize(n), normal)) {
            return world.materials[std::size_t(mesh.triangle_materials[t])].albedo;
        }
    }
    FAIL("no such face");
    return {};
}

const Spectrum grey(0.7f), green(0, 1, 0), blue(0, 0, 1);

}  // namespace

TEST_CASE("cornell-box has the published planes, each facing inward", "[scenes][library]") {
    const World world = world_at(load_scene("cornell-box"), 0);
    check_plane(world, "floor", {{-183, 17, -183}, {183, 17, 183}}, {0, 1, 0}, grey);
    check_plane(world, "ceiling", {{-183, 383, -183}, {183, 383, 183}}, {0, -1, 0}, grey);
    check_plane(world, "green wall", {{183, 17, -183}, {183, 383, 183}}, {-1, 0, 0}, green);
    check_plane(world, "blue wall", {{-183, 17, -183}, {-183, 383, 183}}, {1, 0, 0}, blue);
    check_plane(world, "far wall", {{-183, 17, 183}, {183, 383, 183}}, {0, 0, -1}, grey);
    check_plane(world, "near wall", {{-183, 17, -183}, {183, 383, -183}}, {0, 0, 1}, grey);
    CHECK(world.meshes.size() == 8);
}

TEST_CASE("cornell-box turns its blocks as published", "[scenes][library]") {
    const Scene scene = load_scene("cornell-box");
    for (const int frame : {0, 200, 275, 350, 599}) {
        const World world = world_at(scene, frame);
        const double t = std::clamp(frame - 200, 0, 150);
        check_box(world, "tall block", {-110, 0, -110}, {110, 220, 110}, {.5, 1, .5},
                  .586 + (457 + t) / 93, {60, 10, 70});
        check_box(world, "cube", {-110, 0, -110}, {110, 220, 110}, glm::dvec3(.5),
                  -.586 + (463 + t) / 93, {-67.5, 10, -70});
    }
}

TEST_CASE("room-with-door stands and opens as published", "[scenes][library]") {
    const Scene scene = load_scene("room-with-door");
    const glm::dvec3 lower(-25, 0, -25), upper(25, 50, 25);
    const double half_turn = glm::pi<double>();
    for (const int frame : {0, 200, 275, 350, 599}) {
        const World world = world_at(scene, frame);
        const double t = std::clamp(frame - 200, 0, 150);
        check_box(world, "door", lower, upper, {.6, 3, 2}, 0, {120, 17 + t, 15});
        check_box(world, "far doorway", lower, upper, {.6, 3, 2.4}, half_turn, {120, 17, 122});
        check_box(world, "near doorway", lower, upper, {.6, 3, 3}, 0, {120, 17, -107});
        check_box(world, "wall", lower, upper, {.6, 3, 7.31}, 0, {-178, 17, 0});
        check_box(world, "far wall", lower, upper, {5.89, 3, .6}, 0, {-42.5, 17, 178});
        check_box(world, "roof", lower, upper, {5.89, 1, 7.31}, 0, {-42.5, 166, 0});
        check_plane(world, "floor", {{-183, 17, -183}, {183, 17, 183}}, {0, 1, 0}, grey);
        check_plane(world, "green wall", {{183, 17, -183}, {183, 203, 183}}, {-1, 0, 0}, green);
        CHECK(world.meshes.size() == 8);
    }
}

TEST_CASE("room-with-door's blocks have a green +x and a blue -z face", "[scenes][library]") {
    const World world = world_at(load_scene("room-with-door"), 0);
    for (const char* name : {"door", "near doorway", "wall", "far wall", "roof"}) {
        INFO(name);
        CHECK(face_albedo(world, name, {1, 0, 0}) == green);
        CHECK(face_albedo(world, name, {0, 0, -1}) == blue);
        CHECK(face_albedo(world, name, {-1, 0, 0}) == grey);
        CHECK(face_albedo(world, name, {0, 1, 0}) == grey);
    }
    // The far doorway is turned by pi.
    CHECK(face_albedo(world, "far doorway", {-1, 0, 0}) == green);
    CHECK(face_albedo(world, "far doorway", {0, 0, 1}) == blue);
}

TEST_CASE("the thesis's scenes have its lights, cameras, grids and constants",
          "[scenes][library]") {
    struct Published {
        const char* name;
        glm::vec3 light, eye, target;
        glm::ivec3 counts;
        ThesisConstants constants;
    };
    const auto published = GENERATE(Published{"cornell-box",
                                              {0, 313, 0},
                                              {0, 200, -700},
                                              {0, 200, 0},
                                              {21, 21, 21},
                                              {680.f, .105f, 26.2f, 5.4f, .07f, 1.f}},
                                    Published{"room-with-door",
                                              {170, 167, 15},
                                              {-100, 100, -300},
                                              {0, 100, 0},
                                              {21, 12, 21},
                                              {690.f, .05f, 50.f, 8.4f, .01f, 1.8f}});
    const Scene scene = load_scene(published.name);
    REQUIRE(scene.lights.size() == 1);
    CHECK(scene.lights[0].position == published.light);
    CHECK(scene.lights[0].falloff == Falloff::None);
    CHECK(scene.lights[0].white_radiance == Spectrum(1.f));
    CHECK(scene.camera ==
          Camera{published.eye, published.target, {0, 1, 0}, glm::radians(45.f), 1920, 1080});
    CHECK(scene.probes == ProbeGrid{{-200, 0, -200}, 20, published.counts});
    CHECK(scene.thesis == published.constants);
    CHECK(scene.frames == 600);
    CHECK(scene.environment == Spectrum(0.f));
}

TEST_CASE("two-rooms' wall is a tenth of a cell thick, and its door covers the doorway when shut",
          "[scenes][library]") {
    const Scene scene = load_scene("two-rooms");
    const World shut = world_at(scene, 0);
    const Bounds wall = find(shut, "lintel").object->bounds;
    CHECK(wall.size().x == Approx(scene.probes->spacing / 10));
    const Bounds doorway{{0, 0, -.5f}, {0, 2, .5f}};
    const Bounds door = find(shut, "door").object->bounds;
    CHECK(door.contains(doorway.lower));
    CHECK(door.contains(doorway.upper));
    const Bounds open = find(world_at(scene, scene.frames - 1), "door").object->bounds;
    CHECK(open.lower.z >= doorway.upper.z);
}

TEST_CASE("a report shows the Cornell Box at rest and the room with its door open",
          "[scenes][library]") {
    CHECK(load_scene("cornell-box").report_frame == 0);
    const Scene room = load_scene("room-with-door");
    CHECK(room.report_frame == 350);
    const float shut = find(world_at(room, 0), "door").object->bounds.lower.y;
    const float open = find(world_at(room, room.report_frame), "door").object->bounds.lower.y;
    CHECK(open - shut == Approx(150));
}
