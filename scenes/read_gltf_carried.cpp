// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "scenes/nearest_name.h"
#include "scenes/read_gltf.h"
#include "scenes/read_json.h"
#include "scenes/scene_checks.h"
#include "scenes/world.h"

namespace plumbline {
namespace {

/// Follows the node and its ancestors up to the top.
GltfCarrier carrier(std::size_t index, const GltfBeingRead& gltf) {
    GltfCarrier result{index, gltf.nodes[index], glm::mat4(1.f), false};
    for (int node = static_cast<int>(index); node != -1;) {
        const auto i = static_cast<std::size_t>(node);
        Transform transform = gltf_transform(gltf.nodes[i]);
        if (gltf.node_objects[i] != -1) {
            const Object& object =
                gltf.scene.objects[static_cast<std::size_t>(gltf.node_objects[i])];
            transform = transform_at(object.rest, object.animation, 0.f);
            result.moves = result.moves || !object.animation.empty();
        }
        result.to_world = transform.matrix() * result.to_world;
        node = *gltf.parents[i];
    }
    return result;
}

/// The camera as its extras tell it exactly, if it is still where they say.
std::optional<Camera> exact_camera(const JsonView& item, const Camera& seen) {
    const auto extras = plumbline_extras(item);
    if (!extras) return std::nullopt;
    extras->expect_keys({"eye", "target", "up", "width", "height"});
    Camera exact = read_camera(*extras);
    exact.vertical_fov = seen.vertical_fov;
    constexpr float rounding = 1e-4f;
    const float reach = 1.f + glm::length(exact.eye) + glm::length(exact.target);
    const glm::vec3 view = unit_length(exact.target - exact.eye);
    const bool moved = glm::distance(exact.eye, seen.eye) > rounding * reach;
    const bool turned = glm::distance(view, unit_length(seen.target - seen.eye)) > rounding;
    return moved || turned ? std::nullopt : std::optional(exact);
}

void read_camera_of(const JsonView& reference, const GltfCarrier& at, GltfBeingRead& gltf) {
    const JsonView& item =
        gltf.cameras[static_cast<std::size_t>(reference.index(gltf.cameras.size(), "camera"))];
    const auto perspective = item.find("perspective");
    if (!perspective) return gltf.note("an orthographic camera; left out");
    if (!gltf.camera_place.empty()) return gltf.note("more cameras than one; the first is used");
    if (at.moves) gltf.note("the camera's motion; it stays where it is at frame 0");
    gltf.camera_place = item.pointer();
    Camera camera;
    camera.eye = glm::vec3(at.to_world[3]);
    camera.target = camera.eye - glm::vec3(at.to_world[2]);
    camera.up = glm::vec3(at.to_world[1]);
    camera.vertical_fov = perspective->at("yfov").real();
    if (const auto aspect = perspective->find("aspectRatio")) {
        const double width = std::round(aspect->number() * camera.height);
        if (!(width >= 1 && width <= max_image_side)) {
            aspect->fail(fmt::format("is {:g}", aspect->number()),
                         "it is a picture's width over its height, such as 1.78");
        }
        camera.width = static_cast<int>(width);
    }
    gltf.scene.camera = exact_camera(item, camera).value_or(camera);
}

/// For a file without a camera: one that sees the whole scene at frame 0 from +z.
void place_camera(GltfBeingRead& gltf) {
    gltf.note("no camera in the file; one was placed that sees everything from +z");
    const Bounds bounds = world_at(gltf.scene, 0).bounds();
    if (bounds.empty()) return;
    Camera& camera = gltf.scene.camera;
    camera.target = (bounds.lower + bounds.upper) / 2.f;
    const float half = std::max(max_component(bounds.size()) / 2.f, 1e-6f);
    constexpr float margin = 1.1f;
    const float distance = margin * half / std::tan(camera.vertical_fov / 2.f);
    camera.eye = glm::vec3(camera.target.x, camera.target.y, bounds.upper.z + distance);
}

}  // namespace

std::optional<JsonView> gltf_light_of(const JsonView& node) {
    const auto punctual = extension(node, "KHR_lights_punctual");
    return punctual ? std::optional(punctual->at("light")) : std::nullopt;
}

void read_gltf_carried(GltfBeingRead& gltf) {
    const std::vector<std::string> noted_before = gltf.scene.not_simulated;
    bool any_light = false;
    bool any_camera = false;
    for (std::size_t i = 0; i < gltf.nodes.size(); ++i) {
        const auto light = gltf_light_of(gltf.nodes[i]);
        const auto camera = gltf.nodes[i].find("camera");
        if (!gltf.parents[i] || (!light && !camera)) continue;
        const GltfCarrier at = carrier(i, gltf);
        if (light) read_gltf_light(*light, at, gltf);
        if (camera) read_camera_of(*camera, at, gltf);
        any_light = any_light || light.has_value();
        any_camera = any_camera || camera.has_value();
    }
    if (gltf.host_rate) {
        // Nobody misses the details of what is left out as a whole.
        gltf.scene.not_simulated = noted_before;
        if (any_light) gltf.note("its lights");
        if (any_camera) gltf.note("its camera");
    } else if (gltf.camera_place.empty()) {
        place_camera(gltf);
    }
}

}  // namespace plumbline
