// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/use_scene.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "scenes/camera_rays.h"
#include "scenes/errors.h"
#include "scenes/inspection.h"
#include "scenes/json_layout.h"
#include "scenes/ray_tracer.h"
#include "scenes/read_json.h"
#include "tests/fuzz/held.h"

namespace plumbline::fuzz {
namespace {

void trace(const World& world) {
    const RayTracer tracer(world);
    const CameraRays camera(world.camera);
    const auto width = static_cast<float>(world.camera.width);
    const auto height = static_cast<float>(world.camera.height);
    for (const glm::vec2 place : {glm::vec2(.5f, .5f), glm::vec2(.3f, .6f), glm::vec2(0, 1)}) {
        const Ray ray = camera.through(place.x * width, place.y * height);
        const auto hit = tracer.intersect(ray, BackFaces::Cull);
        if (!hit) continue;
        for (const PointLight& light : world.lights) {
            tracer.occluded(offset_origin(*hit, hit->n()), light.position);
        }
    }
}

/// Scenes whose pictures stand beside them are read again by the tests of round trips.
bool has_pictures(const Scene& scene) {
    const auto textured = [](const Material& material) { return material.texture.has_value(); };
    return scene.environment_image ||
           std::any_of(scene.materials.begin(), scene.materials.end(), textured);
}

void read_again(const Scene& scene) {
    const std::string text = laid_out(json_of(scene));
    try {
        read_json_scene(text, "written", {});
    } catch (const InputError& error) {
        throw std::logic_error(std::string("a scene cannot be read again: ") + error.what());
    }
}

}  // namespace

void use_scene(const Scene& scene) {
    static const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    for (const int frame : {0, scene.frames / 2, scene.frames - 1}) {
        const auto json = inspection(scene, frame);
        for (const auto& warning : json.at("warnings")) {
            hold_to_one_line(warning.get<std::string>());
        }
        laid_out(json);
        trace(world_at(scene, frame));
    }
    if (!has_pictures(scene)) read_again(scene);
}

}  // namespace plumbline::fuzz
