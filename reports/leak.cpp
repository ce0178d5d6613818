// SPDX-License-Identifier: Apache-2.0
#include "reports/leak.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "scenes/errors.h"
#include "scenes/progress.h"
#include "scenes/scene_files.h"
#include "scenes/world.h"

namespace plumbline::reports {

namespace {

/// What the wall between the rooms is made of.
constexpr std::array<std::string_view, 4> wall_parts{"near half of the wall",
                                                     "far half of the wall", "lintel", "door"};

/// The rooms' pixels lie on either side of the wall, so both are seen from within its plane.
bool is_wall(const Object& object) {
    return std::ranges::find(wall_parts, object.name) != wall_parts.end();
}

/// The part as a sheet in the plane x = 0.
Quad sheet(const Box& box, int two_sided_material) {
    const glm::vec3 size = box.upper - box.lower;
    return {{0.f, box.lower.y, box.lower.z},
            {0.f, 0.f, size.z},
            {0.f, size.y, 0.f},
            two_sided_material};
}

/// The part thinned or thickened to reach `half` to either side. The door, which slides into the
/// wall, stays thinner than it in the scene's own proportion.
Box slab(const Box& box, float half, float half_in_scene) {
    Box result = box;
    result.lower.x *= half / half_in_scene;
    result.upper.x *= half / half_in_scene;
    return result;
}

void check(const LeakOptions& options) {
    for (const double cells : options.cells) {
        if (cells >= 0. && cells <= 1.) continue;
        throw UsageError("--cells", fmt::format("a wall {} cells thick", cells),
                         "give thicknesses from 0 to 1");
    }
    if (options.cells.empty())
        throw UsageError("--cells", "no thickness", "give one or more, such as 0,0.1,1");
}

}  // namespace

Scene rooms_with_wall(double cells) {
    Scene scene = load_scene("two-rooms");
    const auto half = static_cast<float>(cells / 2.) * probe_grid(scene).spacing;
    const auto half_of = [](const Object& object) { return std::get<Box>(object.shape).upper.x; };
    float half_in_scene = 0.f;
    for (const Object& object : scene.objects)
        if (is_wall(object)) half_in_scene = std::max(half_in_scene, half_of(object));
    for (Object& object : scene.objects) {
        if (!is_wall(object)) continue;
        const Box box = std::get<Box>(object.shape);
        if (half > 0.f) {
            object.shape = slab(box, half, half_in_scene);
            continue;
        }
        Material material = scene.materials[static_cast<std::size_t>(box.face_materials[0])];
        material.two_sided = true;
        object.shape = sheet(box, static_cast<int>(scene.materials.size()));
        scene.materials.push_back(material);
    }
    return scene;
}

Leak leak_in(const Image& picture, const Scene& rooms, double cells) {
    const Camera& camera = rooms.camera;
    const glm::vec3 right = glm::cross(camera.target - camera.eye, camera.up);
    // The lamp tells which room is lit.
    const bool lit_is_right = right.x * rooms.lights.front().position.x > 0.f;
    const auto layer = picture.layer("indirect");
    const auto object = picture.channel("object.Y");
    std::array<double, 2> sum{};
    std::array<std::size_t, 2> pixels{};
    for (std::size_t i = 0; i < picture.pixels(); ++i) {
        const auto seen = static_cast<int>(object[i]);
        if (seen < 0 || is_wall(rooms.objects[static_cast<std::size_t>(seen)])) continue;
        const bool is_right =
            2 * static_cast<int>(i % std::size_t(picture.width())) >= picture.width();
        const std::size_t room = is_right == lit_is_right ? 0 : 1;
        for (const auto& channel : layer) sum[room] += double(channel[i]);
        ++pixels[room];
    }
    return {cells, sum[0] / (3. * double(pixels[0])), sum[1] / (3. * double(pixels[1]))};
}

std::vector<LeakCurve> measure_leak(const std::vector<AblationCase>& cases,
                                    const LeakOptions& options) {
    check(options);
    Progress progress("Leak", cases.size() * options.cells.size());
    std::vector<LeakCurve> curves;
    for (const AblationCase& subject : cases) {
        LeakCurve curve{subject, {}};
        for (const double cells : options.cells) {
            Scene rooms = rooms_with_wall(cells);
            rooms.camera.width = options.width;
            rooms.camera.height = options.height;
            curve.leaks.push_back(
                leak_in(ddgi::render(rooms, 0, subject.ddgi).image, rooms, cells));
            progress.advance();
        }
        curves.push_back(curve);
    }
    return curves;
}

}  // namespace plumbline::reports
