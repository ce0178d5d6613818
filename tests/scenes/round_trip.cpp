// SPDX-License-Identifier: Apache-2.0
#include <tiny_gltf.h>

#include <catch2/catch.hpp>
#include <random>

#include "scenes/scene_files.h"
#include "scenes/world.h"
#include "tests/scenes/temporary_folder.h"

using namespace plumbline;

namespace {

/// Numbers with all bits of a float in use, which a decimal of few digits would not keep.
struct Odd {
    std::mt19937 random{20231};
    std::uniform_real_distribution<float> uniform{0.f, 1.f};

    float number() { return uniform(random); }
    glm::vec3 vec() { return {number(), number(), number()}; }
    glm::quat rotation() { return glm::normalize(glm::quat(number(), vec())); }
};

/// A scene with everything that the formats can say, in an awkward order.
Scene awkward_scene() {
    Odd odd;
    Scene scene;
    scene.name = "awkward \"name\"";
    scene.description = "ünïcode\tand a tab";
    scene.length_unit = "m";
    for (int i = 0; i < 3; ++i) {
        scene.materials.push_back({"material " + std::to_string(i),
                                   odd.vec(),
                                   {},
                                   i == 1 ? 40.f * odd.vec() : odd.vec(),
                                   i == 2});
    }
    Mesh mesh{"strip", {}, {}, {}, {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {4, 3, 2}}, {0, 2, 0, 0}};
    for (int i = 0; i < 5; ++i) {
        mesh.positions.push_back(100.f * odd.vec());
        mesh.vertex_albedo.push_back(odd.vec());
    }
    scene.meshes = {mesh};
    mesh.name = "plain strip";
    mesh.vertex_albedo.clear();
    scene.meshes.push_back(mesh);

    const auto add = [&](const std::string& name, int parent, decltype(Object::shape) shape) {
        Object object;
        object.name = name;
        object.parent = parent;
        object.rest = {glm::vec3(odd.number() + 1.f), odd.rotation(), odd.vec()};
        object.shape = shape;
        scene.objects.push_back(object);
    };
    add("group", -1, {});
    add("plain", -1, MeshInstance{1});
    add("child", 0, Box{-odd.vec(), odd.vec(), {0, 1, 2, 0, 1, 2}});
    add("sphere", 2, Sphere{odd.vec(), odd.number(), true, 1});
    add("mesh", 0, MeshInstance{0});
    add("again", 1, MeshInstance{0});
    add("quad", 4, Quad{odd.vec(), {1, 0, odd.number()}, {0, 1, odd.number()}, 2});
    scene.objects[0].animation.translation = {
        Interpolation::Step, {1.3f, 7.7f}, {odd.vec(), odd.vec()}};
    scene.objects[4].animation.rotation = {
        Interpolation::Linear, {0, 100, 333.3f}, {odd.rotation(), odd.rotation(), odd.rotation()}};
    scene.objects[6].animation.scale = {Interpolation::Linear, {5, 6}, {odd.vec(), glm::vec3(0)}};
    scene.lights = {{"none", odd.vec(), Falloff::None, Spectrum(0), odd.vec()},
                    {"physical", odd.vec(), Falloff::InverseSquare, 50.f * odd.vec(), Spectrum(0)},
                    {"dark", odd.vec(), Falloff::InverseSquare, Spectrum(0), Spectrum(0)},
                    {"ball", odd.vec(), Falloff::None, Spectrum(0), odd.vec(), odd.number(), {}},
                    {"spot", odd.vec(), Falloff::InverseSquare, odd.vec(), Spectrum(0), 0.f,
                     SpotCone{-3.f * odd.vec(), .3f * odd.number(), .5f + odd.number()}}};
    scene.directional_lights = {{"sun", 7.f * odd.vec(), 9.f * odd.vec()},
                                {"moon", {0, 0, 1}, Spectrum(0)}};
    scene.environment = odd.vec();
    scene.camera = {odd.vec(), 10.f * odd.vec(), {odd.number(), 1, 0}, odd.number(), 333, 77};
    scene.frames = 700;
    scene.report_frame = 3;
    scene.frames_per_second = 23.976f;
    scene.probes = ProbeGrid{odd.vec(), odd.number(), {3, 4, 5}};
    scene.thesis = ThesisConstants{680.1f, odd.number(), 26.2f, 5.4f, .07f, 1.8f};
    return scene;
}

bool same_world(const World& a, const World& b) {
    if (a.meshes.size() != b.meshes.size() || a.spheres.size() != b.spheres.size()) return false;
    for (std::size_t i = 0; i < a.meshes.size(); ++i) {
        if (a.meshes[i].positions != b.meshes[i].positions) return false;
        if (a.meshes[i].triangles != b.meshes[i].triangles) return false;
        if (a.meshes[i].triangle_materials != b.meshes[i].triangle_materials) return false;
        if (a.meshes[i].vertex_albedo != b.meshes[i].vertex_albedo) return false;
    }
    for (std::size_t i = 0; i < a.spheres.size(); ++i) {
        if (a.spheres[i].center != b.spheres[i].center) return false;
        if (a.spheres[i].radius != b.spheres[i].radius) return false;
    }
    return a.materials == b.materials && a.lights == b.lights &&
           a.directional_lights == b.directional_lights && a.camera == b.camera &&
           a.environment == b.environment;
}

void check_round_trip(const Scene& scene, const std::string& ending) {
    const TemporaryFolder folder;
    const std::string path = (folder / ("some scene" + ending)).string();
    save_scene(scene, path);
    const Scene read = load_scene(path);
    CHECK(read.not_simulated == scene.not_simulated);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        INFO(scene.objects[i].name);
        CHECK(read.objects.at(i) == scene.objects[i]);
    }
    CHECK(read == scene);
    for (const int frame : {0, 1, 6, 200, 275, 350, 599}) {
        CHECK(same_world(world_at(read, frame), world_at(scene, frame)));
    }
}

}  // namespace

TEST_CASE("a built-in scene that is written and read is the same to the bit", "[scenes][files]") {
    const std::string ending = GENERATE(".json", ".gltf");
    const auto names = builtin_scene_names();
    CHECK(names == std::vector<std::string>{"cornell-box", "courtyard", "emitters", "furnace",
                                            "integrating-sphere", "room-with-door", "two-rooms"});
    for (const std::string& name : names) {
        INFO(name << ending);
        check_round_trip(load_scene(name), ending);
    }
}

TEST_CASE("a scene with everything in it that is written and read is the same to the bit",
          "[scenes][files]") {
    const std::string ending = GENERATE(".json", ".gltf");
    INFO(ending);
    check_round_trip(awkward_scene(), ending);
}

TEST_CASE("an independent reader accepts what is written as glTF", "[scenes][files]") {
    const TemporaryFolder folder;
    const Scene scene = awkward_scene();
    const std::string path = (folder / "scene.gltf").string();
    save_scene(scene, path);
    tinygltf::Model model;
    tinygltf::TinyGLTF reader;
    std::string error, warning;
    REQUIRE(reader.LoadASCIIFromFile(&model, &error, &warning, path));
    CHECK(error.empty());
    CHECK(warning.empty());
    // A node more for each light and for the camera; a mesh more for each box, quad and sphere.
    const std::size_t lights = scene.lights.size() + scene.directional_lights.size();
    CHECK(model.nodes.size() == scene.objects.size() + lights + 1);
    CHECK(model.meshes.size() == scene.meshes.size() + 3);
    CHECK(model.lights.size() == lights);
    CHECK(model.lights.at(4).type == "spot");
    CHECK(model.lights.at(4).spot.outerConeAngle ==
          Approx(scene.lights[4].cone.value().outer_angle));
    CHECK(model.lights.at(5).type == "directional");
    CHECK(model.animations.at(0).channels.size() == 3);
    const auto& colour =
        model.accessors[std::size_t(model.meshes[0].primitives[0].attributes.at("COLOR_0"))];
    CHECK(colour.count == 5);
}

TEST_CASE("a shape whose mesh another program edited is read as that mesh", "[scenes][files]") {
    const TemporaryFolder folder;
    const std::string path = (folder / "scene.gltf").string();
    save_scene(load_scene("integrating-sphere"), path);
    CHECK(std::holds_alternative<Sphere>(load_scene(path).objects[0].shape));
    // The sphere's vertices come first; the first but one is a pole that a triangle uses.
    std::fstream file(folder / "scene.bin", std::ios::in | std::ios::out | std::ios::binary);
    const float farther[3] = {0.f, 1.5f, 0.f};
    file.seekp(sizeof farther);
    file.write(reinterpret_cast<const char*>(farther), sizeof farther);
    file.close();
    CHECK(std::holds_alternative<MeshInstance>(load_scene(path).objects[0].shape));
}
