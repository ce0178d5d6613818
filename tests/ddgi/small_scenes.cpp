// SPDX-License-Identifier: Apache-2.0
#include "tests/ddgi/small_scenes.h"

#include <algorithm>
#include <cstring>

namespace plumbline::ddgi {
namespace {

/// Six quads that face into [-1,1]^3, of materials 0 to 5, or all of material 0.
void add_walls(Scene& scene, bool unlike) {
    int wall = 0;
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.f, 1.f}) {
            glm::vec3 corner(-1.f);
            glm::vec3 u(0.f);
            glm::vec3 v(0.f);
            corner[axis] = side;
            u[(axis + 1) % 3] = 2.f;
            v[(axis + 2) % 3] = 2.f;
            if (side > 0.f) std::swap(u, v);
            Object object;
            object.name = "wall " + std::to_string(wall);
            object.shape = Quad{corner, u, v, unlike ? wall : 0};
            scene.objects.push_back(object);
            ++wall;
        }
    }
}

Camera small_camera() {
    Camera camera;
    camera.eye = {-.7f, .2f, -.8f};
    camera.target = {.3f, -.1f, .5f};
    camera.vertical_fov = 1.2f;
    camera.width = 24;
    camera.height = 16;
    return camera;
}

Material material(const Spectrum& albedo, const Spectrum& emission) {
    Material result;
    result.albedo = albedo;
    result.emission = emission;
    return result;
}

}  // namespace

Scene closed_room(const Spectrum& albedo, const Spectrum& emission) {
    Scene scene;
    scene.name = "closed room";
    scene.materials = {material(albedo, emission)};
    add_walls(scene, false);
    scene.camera = small_camera();
    scene.probes = ProbeGrid{glm::vec3(-.9f), .6f, {4, 4, 4}};
    return scene;
}

Scene integrating_sphere(float albedo, const glm::vec3& light) {
    Scene scene;
    scene.name = "sphere";
    scene.materials = {material(Spectrum(albedo), Spectrum(0.f))};
    Object object;
    object.shape = Sphere{glm::vec3(0.f), 2.f, true, 0};
    scene.objects = {object};
    PointLight point;
    point.position = light;
    point.intensity = Spectrum(1.f);
    scene.lights = {point};
    scene.camera = small_camera();
    scene.probes = ProbeGrid{glm::vec3(-1.1f), .44f, {6, 6, 6}};  // corners inside too
    return scene;
}

Scene room_with_moving_block() {
    Scene scene;
    scene.name = "moving block";
    scene.materials = {material({.9f, .2f, .1f}, {}), material({.1f, .3f, .8f}, {}),
                       material({.7f, .7f, .7f}, {}), material({.5f, .5f, .6f}, {}),
                       material({.2f, .8f, .2f}, {}), material({.7f, .6f, .5f}, {})};
    add_walls(scene, true);
    Object block;
    block.name = "block";
    block.shape = Box{glm::vec3(-.25f), glm::vec3(.25f), {0, 1, 2, 3, 4, 5}};
    block.animation.translation = {
        Interpolation::Linear, {2.f, 6.f}, {{-.4f, -.5f, .1f}, {.5f, -.2f, .3f}}};
    block.animation.rotation = {Interpolation::Linear,
                                {2.f, 6.f},
                                {glm::angleAxis(.1f, glm::vec3(0.f, 1.f, 0.f)),
                                 glm::angleAxis(1.2f, glm::normalize(glm::vec3(1.f, 1.f, 0.f)))}};
    scene.objects.push_back(block);
    PointLight light;
    light.position = {.1f, .8f, -.2f};
    light.falloff = Falloff::None;
    light.white_radiance = {1.f, .9f, .8f};
    scene.lights = {light};
    scene.camera = small_camera();
    scene.probes = ProbeGrid{glm::vec3(-.95f), .38f, {6, 6, 6}};
    scene.frames = 10;
    scene.thesis = ThesisConstants{.246f, .105f, 26.2f, 5.4f, .07f, 1.f};
    return scene;
}

std::vector<ProbeOptions> all_probe_options() {
    std::vector<ProbeOptions> all;
    for (const auto& [storage_name, storage] : storage_names) {
        if (storage != Storage::Rays) all.push_back({storage});
    }
    for (const Storage storage : {Storage::Rays, Storage::Octants}) {
        for (const auto& [weights_name, weights] : weights_names) all.push_back({storage, weights});
    }
    all.push_back({.weights = ProbeWeights::Moments, .normal_bias = .1f, .skip_inside = true});
    all.push_back({.shifted = false});
    all.push_back({.parallax = false});
    all.push_back({.feedback = Feedback::Rays});
    return all;
}

double mean(const Image& image, const std::string& layer) {
    double sum = 0.;
    for (const std::span<const float> channel : image.layer(layer)) {
        for (const float value : channel) sum += double(value);
    }
    return sum / (3. * double(image.pixels()));
}

bool same_bytes(const Image& a, const Image& b) {
    if (a.channel_names() != b.channel_names()) return false;
    return std::ranges::all_of(a.channel_names(), [&](const std::string& name) {
        const std::span<const float> x = a.channel(name);
        const std::span<const float> y = b.channel(name);
        return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size_bytes()) == 0;
    });
}

bool same_surfels(const Surfels& a, const Surfels& b) {
    if (a.place != b.place || a.object != b.object || a.light != b.light ||
        a.emission != b.emission) {
        return false;
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!a.hit(i)) continue;
        if (a.source_of(i) != b.source_of(i)) return false;
        if (a.own_light(i) && !a.seen.empty() && a.seen[i] != b.seen[i]) return false;
    }
    return true;
}

}  // namespace plumbline::ddgi
