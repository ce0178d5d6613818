// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "scenes/errors.h"
#include "scenes/scene_files.h"
#include "scenes/world.h"
#include "tests/scenes/temporary_folder.h"

using namespace plumbline;

namespace {

const std::string square =
    "mtllib square.mtl\n# a unit square, its second half by negative indices\n"
    "v 0 0 0 1 0.5 0.25\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
    "usemtl red paint\nf 1/1 2/2 3\nusemtl dark\nf -4 -2 -1\n";
const std::string paints = "newmtl red paint\nKd 0.8 0.1 0.1\nnewmtl dark\nKd 0 0 0\nKe 3 2 1\n";

std::string scene_with(const std::string& mesh, const std::string& settings = "") {
    return R"({"name": "s", )" + settings + R"("materials": [{"name": "grey", "albedo": 0.5}],
        "objects": [{"name": "thing", "mesh": )" +
           mesh + R"(, "translation": [0, 0, 7]}],
        "camera": {"eye": [0, 0, 5], "target": [0, 0, 0]}})";
}

/// What a scene says that it leaves out of square.obj with these materials.
std::vector<std::string> left_out_of(const std::string& mtl) {
    const TemporaryFolder folder;
    folder.write("square.mtl", mtl);
    folder.write("square.obj", square);
    return load_scene(folder.write("s.json", scene_with(R"({"file": "square.obj"})")))
        .not_simulated;
}

/// A cube that moves along x through these frames, 60 a second.
Scene moving_cube(const std::vector<float>& frames, const std::vector<float>& x) {
    Scene scene;
    scene.name = "cube";
    scene.materials.emplace_back().name = "grey";
    Object& cube = scene.objects.emplace_back();
    cube.name = "cube";
    cube.shape = Box{glm::vec3(-1.f), glm::vec3(1.f), {}};
    cube.animation.translation.frames = frames;
    for (const float value : x) cube.animation.translation.values.emplace_back(value, 0.f, 0.f);
    scene.frames = 1000;
    return scene;
}

nlohmann::json json_at(const std::filesystem::path& path) {
    return nlohmann::json::parse(std::ifstream(path));
}

/// The keyframes of the cube in cube.gltf, once a scene of this rate brings it.
Track<glm::vec3> brought_track(const TemporaryFolder& folder, const std::string& rate) {
    const std::string settings = "\"frames\": 999, \"frames_per_second\": " + rate + ", ";
    const std::string path =
        folder.write("s.json", scene_with(R"({"file": "cube.gltf"})", settings));
    return load_scene(path).objects[1].animation.translation;
}

/// What is said when an OBJ of this text is loaded, from its name on.
std::string obj_complaint(const std::string& obj) {
    const TemporaryFolder folder;
    folder.write("square.mtl", paints);
    folder.write("square.obj", obj);
    const std::string path = folder.write("s.json", scene_with(R"({"file": "square.obj"})"));
    try {
        load_scene(path);
    } catch (const SceneError& error) {
        return std::string(error.what()).substr(folder.path().string().size() + 1);
    }
    return "accepted";
}

}  // namespace

TEST_CASE("an OBJ file brings its faces, colours and materials", "[scenes][mesh-files]") {
    const TemporaryFolder folder;
    folder.write("square.mtl", paints);
    folder.write("square.obj", square);
    const std::string path = folder.write("s.json", scene_with(R"({"file": "square.obj"})"));
    const Scene scene = load_scene(path);
    REQUIRE(scene.meshes.size() == 1);
    const Mesh& mesh = scene.meshes[0];
    CHECK(mesh.positions == std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    CHECK(mesh.triangles == std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 3}});
    CHECK(mesh.vertex_albedo ==
          std::vector<Spectrum>{{1, .5f, .25f}, Spectrum(1), Spectrum(1), Spectrum(1)});
    CHECK(scene.materials[std::size_t(mesh.triangle_materials[0])].name == "thing/red paint");
    CHECK(scene.materials[std::size_t(mesh.triangle_materials[0])].albedo ==
          Spectrum(.8f, .1f, .1f));
    CHECK(scene.materials[std::size_t(mesh.triangle_materials[1])].emission == Spectrum(3, 2, 1));
    CHECK(world_at(scene, 0).bounds() == Bounds{{0, 0, 7}, {1, 1, 7}});
}

TEST_CASE("a material beside the file replaces the file's own", "[scenes][mesh-files]") {
    const TemporaryFolder folder;
    folder.write("square.obj", square);
    const std::string path =
        folder.write("s.json", scene_with(R"({"file": "square.obj", "material": "grey"})"));
    const Scene scene = load_scene(path);
    CHECK(scene.meshes[0].triangle_materials == std::vector<int>{0, 0});
    CHECK(scene.materials.size() == 1);
}

TEST_CASE("a concave polygon is cut without covering what is outside", "[scenes][mesh-files]") {
    const TemporaryFolder folder;
    // An arrowhead: cut from its first corner, a triangle would turn over.
    folder.write("square.obj", "v 0 2 0\nv -1 0 0\nv 0 1 0\nv 1 0 0\nf 4 1 2 3\n");
    const std::string path =
        folder.write("s.json", scene_with(R"({"file": "square.obj", "material": "grey"})"));
    const Mesh mesh = load_scene(path).meshes[0];
    double area = 0;
    for (const glm::uvec3& t : mesh.triangles) {
        const auto& p = mesh.positions;
        const glm::vec3 n = glm::cross(p[t.y] - p[t.x], p[t.z] - p[t.x]);
        CHECK(n.z > 0.f);
        area += n.z / 2;
    }
    CHECK(area == Approx(1.));
}

TEST_CASE("a glTF file brings its objects below the one that names it", "[scenes][mesh-files]") {
    const TemporaryFolder folder;
    const Scene room = load_scene("room-with-door");
    save_scene(room, folder / "room.gltf");
    const std::string path = folder.write("s.json", scene_with(R"({"file": "room.gltf"})"));
    const Scene scene = load_scene(path);
    REQUIRE(scene.objects.size() == room.objects.size() + 1);
    const World there = world_at(room, 275);
    const World here = world_at(scene, 275);
    for (std::size_t i = 0; i < room.objects.size(); ++i) {
        CHECK(here.objects[i + 1].name == "thing/" + there.objects[i].name);
        CHECK(here.objects[i + 1].bounds.lower ==
              there.objects[i].bounds.lower + glm::vec3(0, 0, 7));
    }
    CHECK(scene.lights.empty());
    CHECK(scene.not_simulated ==
          std::vector<std::string>{"room.gltf: its lights", "room.gltf: its camera",
                                   "room.gltf: its probes",
                                   "room.gltf: its constants of the thesis"});
}

TEST_CASE("what a glTF file brings beside its objects is said to be left out",
          "[scenes][mesh-files]") {
    const TemporaryFolder folder;
    Scene cube = moving_cube({0}, {0});
    const auto notes = [&](const Scene& brought) {
        save_scene(brought, folder / "cube.gltf");
        const std::string path = folder.write("s.json", scene_with(R"({"file": "cube.gltf"})"));
        return load_scene(path).not_simulated;
    };
    const std::string camera = "cube.gltf: its camera";
    CHECK(notes(cube) == std::vector<std::string>{camera});
    Scene sunny = cube;
    sunny.directional_lights.push_back({"sun", {0, -1, 0}, Spectrum(3.f)});
    CHECK(notes(sunny) == std::vector<std::string>{"cube.gltf: its lights", camera});
    Scene outdoors = cube;
    outdoors.environment = Spectrum(0, 0, 1);
    CHECK(notes(outdoors) == std::vector<std::string>{camera, "cube.gltf: its environment"});
    Scene small = cube;
    small.length_unit = "cm";
    CHECK(notes(small) ==
          std::vector<std::string>{camera, "cube.gltf: its unit of length, \"cm\""});

    // Nothing is said of a camera that is neither there nor needed, nor how unused lights shine.
    save_scene(sunny, folder / "cube.gltf");
    nlohmann::json gltf = json_at(folder / "cube.gltf");
    for (nlohmann::json& node : gltf["nodes"]) node.erase("camera");
    nlohmann::json& light = gltf["extensions"]["KHR_lights_punctual"]["lights"][0];
    light["type"] = "point";
    light["range"] = 5;
    folder.write("cube.gltf", gltf.dump());
    CHECK(load_scene((folder / "s.json").string()).not_simulated ==
          std::vector<std::string>{"cube.gltf: its lights"});
}

TEST_CASE("a glTF file's animation lasts as long in a scene of any frame rate",
          "[scenes][mesh-files]") {
    const TemporaryFolder folder;
    save_scene(moving_cube({0, 1.5f, 60}, {0, 1, 2}), folder / "cube.gltf");
    CHECK(brought_track(folder, "30").frames == std::vector<float>{0, .75f, 30});
    CHECK(brought_track(folder, "60").frames == std::vector<float>{0, 1.5f, 60});
    CHECK(brought_track(folder, "240").frames == std::vector<float>{0, 6, 240});
    CHECK_THROWS_WITH(brought_track(folder, "0"),
                      Catch::EndsWith("/frames_per_second: is 0; it is above 0"));

    // As another program writes it, in seconds alone.
    nlohmann::json gltf = json_at(folder / "cube.gltf");
    gltf.erase("scenes");
    gltf["scenes"] = {{{"nodes", {0}}}};
    for (nlohmann::json& sampler : gltf["animations"][0]["samplers"]) sampler.erase("extras");
    folder.write("cube.gltf", gltf.dump());
    CHECK(brought_track(folder, "30").frames == std::vector<float>{0, .75f, 30});
    CHECK(brought_track(folder, "24").frames == std::vector<float>{0, .6f, 24});
}

TEST_CASE("keyframes of a glTF file keep their bits in a scene of its own frame rate",
          "[scenes][mesh-files]") {
    const TemporaryFolder folder;
    Scene cube = moving_cube({.1f, 1.f / 3.f, 17.7f, 100.3f}, {0, 1, 2, 3});
    cube.frames_per_second = 23.976f;
    save_scene(cube, folder / "cube.gltf");
    CHECK(brought_track(folder, "23.976").frames == cube.objects[0].animation.translation.frames);
    save_scene(load_scene((folder / "s.json").string()), folder / "again.gltf");
    CHECK(load_scene((folder / "again.gltf").string()).objects[1].animation ==
          cube.objects[0].animation);
}

TEST_CASE("a spline in a glTF file is met at each whole frame of the scene that brings it",
          "[scenes][mesh-files]") {
    const TemporaryFolder folder;
    // Two keys, each between its tangents: from 0 to 1 in a second, flat at both ends.
    save_scene(moving_cube({0, 60, 70, 80, 90, 100}, {0, 0, 0, 0, 1, 0}), folder / "cube.gltf");
    nlohmann::json gltf = json_at(folder / "cube.gltf");
    nlohmann::json& sampler = gltf["animations"][0]["samplers"][0];
    sampler.erase("extras");
    sampler["interpolation"] = "CUBICSPLINE";
    gltf["accessors"][sampler["input"].get<std::size_t>()]["count"] = 2;
    folder.write("cube.gltf", gltf.dump());
    const Track<glm::vec3> track = brought_track(folder, "7");
    REQUIRE(track.frames == std::vector<float>{0, 1, 2, 3, 4, 5, 6, 7});
    for (std::size_t i = 0; i < track.frames.size(); ++i) {
        const float t = track.frames[i] / 7.f;
        CHECK(track.values[i].x == Approx(t * t * (3.f - 2.f * t)).margin(1e-6));
    }
}

TEST_CASE("what a .mtl file asks for beyond albedo and emission is said to be left out",
          "[scenes][mesh-files]") {
    CHECK(left_out_of(paints).empty());
    CHECK(left_out_of("newmtl red paint\nKa 1 1 1\nKd 1 0 0\nKs 0 0 0\nNs 96\nNi 1.45\nd 1.0\n"
                      "Tr 0\nTf 1 1 1\nillum 2\nmap_Ka a.png\nPr 0.5\nPm 0\nPc 0\nnewmtl dark\n")
              .empty());
    const std::string who = "square.obj: material \"red paint\": ";
    const auto noted = [&](const std::string& statement) {
        return left_out_of("newmtl dark\nnewmtl red paint\n" + statement + "\n");
    };
    const auto line = [&](const std::string& what) { return std::vector{who + what}; };
    CHECK(noted("map_Kd -s 2 2 2 wood.png") == line("albedo texture"));
    CHECK(noted("map_Ke lamp.png") == line("emission texture"));
    CHECK(noted("map_Bump -bm 1 bumps.png") == line("normal map"));
    CHECK(noted("d 0.5\nmap_d leaf.png\nTr 0.5") == line("transparency"));
    CHECK(noted("d -halo 1") == line("transparency"));
    CHECK(noted("Ks 0 0.5 0") == line("specular reflection: the surface is taken as matt"));
    CHECK(noted("map_Ks shine.png") == line("specular reflection: the surface is taken as matt"));
    CHECK(noted("Pm 1") == line("metallic reflection: the surface is taken as matt"));
    CHECK(noted("Pc 0.3") == line("statements \"Pc\""));
    CHECK(noted("illum 5") == line("illumination model 5: the surface is taken as matt"));
    // Of materials that the OBJ does not use nothing is missed.
    CHECK(left_out_of(paints + "newmtl glass\nd 0.1\n").empty());
}

TEST_CASE("a bad OBJ file gets one line that names its line", "[scenes][bad-input]") {
    CHECK(obj_complaint(square) == "accepted");
    CHECK(obj_complaint("v 0 0 x\n") ==
          "square.obj:1: \"x\" is no finite number; write one such as 0.5");
    CHECK(obj_complaint("\n\nv 0 0\n") == "square.obj:3: has too few numbers; write 3 or more");
    CHECK(obj_complaint("v 0 0 nan\n") ==
          "square.obj:1: \"nan\" is no finite number; write one such as 0.5");
    CHECK(obj_complaint("v 0 0 0\nf 1 1 2\n") ==
          "square.obj:2: asks for vertex 2; there are 1 to 1 so far");
    CHECK(obj_complaint("v 0 0 0\nf 1 1 0\n") ==
          "square.obj:2: asks for vertex 0; there are 1 to 1 so far");
    CHECK(obj_complaint("v 0 0 0\nf 1 1\n") == "square.obj:2: has 2 corners; a face has 3 to 1000");
    CHECK(obj_complaint("v 0 0 0\n") ==
          "square.obj: has no faces; it may not be a Wavefront OBJ file");
    CHECK(obj_complaint("v 0 0 0\nf 1 1 1\n") ==
          "s.json: /objects/0/mesh/file: has faces without a material; give \"material\" beside "
          "\"file\"");
    CHECK(obj_complaint("mtllib ../m.mtl\nv 0 0 0\nusemtl a\nf 1 1 1\n") ==
          "s.json: /objects/0/mesh/file: \"../m.mtl\" is not in the scene's folder; put the file "
          "into that folder or below, and name it relative to it");
}
