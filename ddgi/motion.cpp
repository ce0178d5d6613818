// SPDX-License-Identifier: Apache-2.0
#include "ddgi/motion.h"

#include <algorithm>
#include <cassert>

namespace plumbline::ddgi {
namespace {

/// Of a box's largest coordinate: well above the rounding of ray tracing, well below any object.
constexpr float rounding_margin = 1e-5f;

Bounds with_margin(const Bounds& box) {
    const glm::vec3 reach = glm::max(glm::abs(box.lower), glm::abs(box.upper));
    return box.grown(rounding_margin * max_component(reach));
}

}  // namespace

Motion motion_between(const World& before, const World& after) {
    assert(before.objects.size() == after.objects.size());
    Motion motion;
    motion.moved.resize(after.objects.size(), false);
    for (std::size_t i = 0; i < after.objects.size(); ++i) {
        const World::Object& was = before.objects[i];
        const World::Object& is = after.objects[i];
        // A turning object may keep its box, so transforms are compared.
        if (was.to_world == is.to_world) continue;
        motion.moved[i] = true;
        if (!was.bounds.empty()) motion.boxes.push_back(with_margin(was.bounds));
        if (!is.bounds.empty()) motion.boxes.push_back(with_margin(is.bounds));
    }
    motion.lights =
        before.lights != after.lights || before.directional_lights != after.directional_lights;
    return motion;
}

World moved_part(const World& world, const Motion& motion) {
    const auto moved = [&](const auto& part) {
        return motion.moved[static_cast<std::size_t>(part.object)];
    };
    World movers;
    movers.objects = world.objects;
    movers.materials = world.materials;
    std::ranges::copy_if(world.meshes, std::back_inserter(movers.meshes), moved);
    std::ranges::copy_if(world.spheres, std::back_inserter(movers.spheres), moved);
    return movers;
}

bool meets(const Bounds& box, const glm::vec3& origin, const glm::vec3& direction, float length) {
    float enter = 0.f;
    float leave = length;
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0.f) {
            // Dividing by zero would give NaN for an origin on the box's plane.
            if (origin[axis] < box.lower[axis] || origin[axis] > box.upper[axis]) return false;
            continue;
        }
        const float a = (box.lower[axis] - origin[axis]) / direction[axis];
        const float b = (box.upper[axis] - origin[axis]) / direction[axis];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave;
}

}  // namespace plumbline::ddgi
