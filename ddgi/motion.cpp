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

/// Half the surface: how likely a box is met by a ray [Pharr et al. 2023, section 7.3.2].
float half_area(const Bounds& box) {
    const glm::vec3 size = box.size();
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

/// Where an object was, and where it is.
void add_boxes(const Bounds& was, const Bounds& is, std::vector<Bounds>& boxes) {
    Bounds both = was;
    both.extend(is);
    if (both.empty()) return;  // an object without surfaces
    // A sphere scaled to nothing has no box, but it had one, or will have.
    if (was.empty() || is.empty() || half_area(both) <= half_area(was) + half_area(is)) {
        boxes.push_back(with_margin(both));
        return;
    }
    boxes.push_back(with_margin(was));
    boxes.push_back(with_margin(is));
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
        add_boxes(was.bounds, is.bounds, motion.boxes);
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

BoxRay::BoxRay(const glm::vec3& origin, const glm::vec3& direction, float length)
    : origin_(origin), length_(length) {
    // 1 / 0 would give 0 * infinity, NaN, for an origin on the box's plane.
    constexpr float steepest = 1e-30f;
    for (int axis = 0; axis < 3; ++axis) {
        inverse_[axis] = 1.f / (direction[axis] == 0.f ? steepest : direction[axis]);
    }
}

}  // namespace plumbline::ddgi
