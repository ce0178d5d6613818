// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "scenes/check_parts.h"
#include "scenes/nearest_name.h"
#include "scenes/unit_rotation.h"

namespace plumbline {
namespace {

bool even(const glm::vec3& scale) {
    const glm::vec3 size = glm::abs(scale);
    return size.x == size.y && size.y == size.z;
}

bool even(const Object& object) {
    const auto& values = object.animation.scale.values;
    return even(object.rest.scale) &&
           std::all_of(values.begin(), values.end(), [](const glm::vec3& s) { return even(s); });
}

template <typename T>
void check_track(const Track<T>& track, const std::string& member, const Checked& checked) {
    if (track.frames.size() != track.values.size()) {
        checked.fail(
            member,
            fmt::format("has {} frames and {} values", track.frames.size(), track.values.size()),
            "give one value a frame");
    }
    for (std::size_t i = 0; i < track.frames.size(); ++i) {
        checked.expect_finite(fmt::format("{}/frames/{}", member, i), track.frames[i]);
        checked.expect_finite(fmt::format("{}/values/{}", member, i), track.values[i]);
        if (i > 0 && !(track.frames[i - 1] < track.frames[i])) {
            checked.fail(fmt::format("{}/frames/{}", member, i),
                         fmt::format("{:g} comes after {:g}", track.frames[i], track.frames[i - 1]),
                         "keyframes must rise");
        }
    }
}

void check_transform(const Object& object, const Checked& checked) {
    checked.expect_finite("translation", object.rest.translation);
    checked.expect_finite("rotation", object.rest.rotation);
    checked.expect_finite("scale", object.rest.scale);
    if (!unit_rotation(object.rest.rotation)) {
        checked.fail("rotation", "is not of unit length", "a rotation has length 1");
    }
    const glm::vec3& scale = object.rest.scale;
    if (object.animation.scale.empty() && (scale.x == 0.f || scale.y == 0.f || scale.z == 0.f)) {
        checked.fail("scale", "is zero along an axis, for good",
                     "scale by something else, or animate it");
    }
    check_track(object.animation.translation, "animation/translation", checked);
    check_track(object.animation.rotation, "animation/rotation", checked);
    check_track(object.animation.scale, "animation/scale", checked);
}

/// Checks an object's shape, whatever it is.
struct ShapeCheck {
    const Scene& scene;
    const Checked& checked;

    void operator()(std::monostate) const {}
    void operator()(const Box& box) const {
        checked.expect_finite("box/lower", box.lower);
        checked.expect_finite("box/upper", box.upper);
        if (!glm::all(glm::lessThan(box.lower, box.upper))) {
            checked.fail("box/upper", "is not above \"lower\" along every axis",
                         "swap them, or use a quad for something flat");
        }
        for (const int material : box.face_materials) expect_material("box/faces", material);
    }
    void operator()(const Quad& quad) const {
        checked.expect_finite("quad/corner", quad.corner);
        checked.expect_finite("quad/edge_u", quad.edge_u);
        checked.expect_finite("quad/edge_v", quad.edge_v);
        if (glm::length(glm::cross(glm::dvec3(quad.edge_u), glm::dvec3(quad.edge_v))) == 0) {
            checked.fail("quad", "has no area",
                         "its edges must differ from zero and from each other's direction");
        }
        expect_material("quad/material", quad.material);
    }
    void operator()(const Sphere& sphere) const {
        checked.expect_finite("sphere/center", sphere.center);
        checked.expect_finite("sphere/radius", sphere.radius);
        if (!(sphere.radius > 0.f)) {
            checked.fail("sphere/radius", fmt::format("is {:g}", sphere.radius), "it is above 0");
        }
        expect_material("sphere/material", sphere.material);
    }
    void operator()(const MeshInstance& instance) const {
        checked.expect_index("mesh", instance.mesh, scene.meshes.size(), "mesh");
    }

    void expect_material(std::string_view member, int material) const {
        checked.expect_index(member, material, scene.materials.size(), "material");
        const Material& of_shape = scene.materials[std::size_t(material)];
        if (!of_shape.texture) return;
        checked.fail(member,
                     in_quotes(of_shape.name) + " has a texture, and this shape no place for it",
                     "use a mesh with \"texcoords\"");
    }
};

}  // namespace

void check_objects(const Scene& scene, const PlaceOf& place_of) {
    std::set<std::string> names;
    // For each object, itself or the nearest ancestor that scales unevenly, or -1.
    std::vector<int> uneven(scene.objects.size(), -1);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        const Checked checked(place_of, "objects", i);
        checked.expect_new_name(object.name, names);
        if (object.parent != -1) checked.expect_index("parent", object.parent, i, "earlier object");
        check_transform(object, checked);
        std::visit(ShapeCheck{scene, checked}, object.shape);
        if (!even(object)) {
            uneven[i] = static_cast<int>(i);
        } else if (object.parent != -1) {
            uneven[i] = uneven[std::size_t(object.parent)];
        }
        if (uneven[i] != -1 && std::holds_alternative<Sphere>(object.shape)) {
            checked.fail("",
                         "is a sphere, but " +
                             in_quotes(scene.objects[std::size_t(uneven[i])].name) +
                             " scales it unevenly",
                         "scale a sphere alike along x, y and z, or use a mesh");
        }
    }
}

}  // namespace plumbline
