// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "scenes/check_parts.h"

namespace plumbline {
namespace {

double length_of(const glm::vec3& v) { return glm::length(glm::dvec3(v)); }

double largest_scale(const glm::vec3& scale) { return double(max_component(glm::abs(scale))); }

/// The largest size_of(v) of `vectors`, of which there are some.
template <typename SizeOf>
double largest(const std::vector<glm::vec3>& vectors, const SizeOf& size_of) {
    double most = 0.;
    for (const glm::vec3& v : vectors) most = std::max(most, size_of(v));
    return most;
}

/// ... of a track's values, or of the rest where there are none. Between keyframes none is larger.
template <typename SizeOf>
double largest(const Track<glm::vec3>& track, const glm::vec3& rest, const SizeOf& size_of) {
    return track.empty() ? size_of(rest) : largest(track.values, size_of);
}

/// How far an object's shape reaches from the object's own origin.
struct ShapeReach {
    const std::vector<double>& of_meshes;

    double operator()(std::monostate) const { return 0.; }
    double operator()(const Box& box) const {
        return length_of(glm::max(glm::abs(box.lower), glm::abs(box.upper)));
    }
    double operator()(const Quad& quad) const {
        return length_of(quad.corner) + length_of(quad.edge_u) + length_of(quad.edge_v);
    }
    double operator()(const Sphere& sphere) const {
        return length_of(sphere.center) + double(sphere.radius);
    }
    double operator()(const MeshInstance& instance) const {
        return of_meshes[std::size_t(instance.mesh)];
    }
};

/// A point `r` from an object's origin is at most offset + stretch r from the world's.
struct Placing {
    double offset = 0.;
    double stretch = 1.;
};

/// At any frame.
Placing placing_of(const Object& object, const Placing& parent) {
    const auto& [scale, rotation, translation] = object.rest;
    const double offset = largest(object.animation.translation, translation, length_of);
    const double stretch = largest(object.animation.scale, scale, largest_scale);
    return {parent.offset + parent.stretch * offset, parent.stretch * stretch};
}

void expect_near(double distance, std::string_view member, const Checked& checked) {
    // The negation also catches NaN, infinity times a scale of zero.
    if (distance <= farthest_place) return;
    checked.fail(
        member, fmt::format("reaches {:.2g} from the origin", distance),
        fmt::format("rays are followed up to {:g} from it: scale the scene down", farthest_place));
}

void check_object_places(const Scene& scene, const PlaceOf& place_of) {
    std::vector<double> of_meshes;
    for (const Mesh& mesh : scene.meshes) of_meshes.push_back(largest(mesh.positions, length_of));
    std::vector<Placing> placings;
    double farthest = 0.;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        const Placing parent =
            object.parent == -1 ? Placing{} : placings[std::size_t(object.parent)];
        const Placing& own = placings.emplace_back(placing_of(object, parent));
        const double reach =
            own.offset + own.stretch * std::visit(ShapeReach{of_meshes}, object.shape);
        expect_near(reach, "", Checked(place_of, "objects", i));
        farthest = std::max(farthest, reach);
    }
    if (farthest == 0. || farthest >= nearest_reach) return;
    Checked(place_of, "objects", 0)
        .fail("", fmt::format("this and all others reach {:.2g} from the origin at most", farthest),
              fmt::format("surfaces are surely met in scenes that reach {:g}: scale the scene up",
                          nearest_reach));
}

}  // namespace

void check_places(const Scene& scene, const PlaceOf& place_of) {
    check_object_places(scene, place_of);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const PointLight& light = scene.lights[i];
        const Checked checked(place_of, "lights", i);
        expect_near(length_of(light.position), "position", checked);
        expect_near(length_of(light.position) + double(light.radius), "radius", checked);
    }
    const Checked camera(place_of, "camera");
    expect_near(length_of(scene.camera.eye), "eye", camera);
    expect_near(length_of(scene.camera.target), "target", camera);
    if (!scene.probes) return;
    const ProbeGrid& probes = *scene.probes;
    const Checked checked(place_of, "probes");
    expect_near(length_of(probes.origin), "origin", checked);
    expect_near(
        length_of(probes.origin) + double(probes.spacing) * glm::length(glm::dvec3(probes.counts)),
        "spacing", checked);
}

}  // namespace plumbline
