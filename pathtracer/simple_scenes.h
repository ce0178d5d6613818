// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <utility>

#include "scenes/scene.h"

// Scenes as small as closed forms and statistics need them.

namespace plumbline::pathtracer {

inline int add_material(Scene& scene, const Spectrum& albedo, const Spectrum& emission = {}) {
    scene.materials.push_back({.name = "material", .albedo = albedo, .emission = emission});
    return static_cast<int>(scene.materials.size()) - 1;
}

template <typename Shape>
void add_object(Scene& scene, const Shape& shape) {
    Object object;
    object.name = "object";
    object.shape = shape;
    scene.objects.push_back(object);
}

inline PointLight inverse_square(const glm::vec3& position, const Spectrum& intensity) {
    return {.name = "light", .position = position, .intensity = intensity};
}

/// The six walls of the room [-1,1]^3, facing inward, with materials in the order of Face.
inline std::array<Quad, 6> room_walls(const std::array<int, 6>& materials) {
    std::array<Quad, 6> walls;
    for (int axis = 0; axis < 3; ++axis) {
        for (int side = 0; side < 2; ++side) {
            const float sign = side == 0 ? 1.f : -1.f;
            glm::vec3 normal(0.f), u(0.f), v(0.f);
            normal[axis] = -sign;
            u[(axis + 1) % 3] = 2.f;
            v[(axis + 2) % 3] = 2.f;
            if (glm::dot(glm::cross(u, v), normal) < 0.f) std::swap(u, v);
            const std::size_t face = 2 * std::size_t(axis) + std::size_t(side);
            walls[face] = {-normal - u / 2.f - v / 2.f, u, v, materials[face]};
        }
    }
    return walls;
}

/// A room of uneven walls with a block, lit by a point light and a glowing wall; the camera sees
/// all.
inline Scene mixed_room(int width, int height) {
    Scene scene;
    scene.name = "mixed room";
    const int grey = add_material(scene, Spectrum(.7f));
    const int red = add_material(scene, {.8f, .2f, .1f});
    const int glowing = add_material(scene, Spectrum(.3f), {.2f, .3f, .4f});
    for (const Quad& wall : room_walls({red, glowing, grey, grey, grey, grey})) {
        add_object(scene, wall);
    }
    add_object(scene,
               Box{{-.5f, -1.f, -.6f}, {.1f, -.2f, 0.f}, {grey, grey, grey, grey, red, grey}});
    scene.lights = {inverse_square({.4f, .7f, -.2f}, {.6f, .5f, .4f})};
    scene.camera = {.eye = {0.f, 0.f, .95f},
                    .target = {0.f, -.2f, 0.f},
                    .vertical_fov = 1.2f,
                    .width = width,
                    .height = height};
    return scene;
}

}  // namespace plumbline::pathtracer
