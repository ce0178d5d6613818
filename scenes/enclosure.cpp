// SPDX-License-Identifier: Apache-2.0
#include "scenes/enclosure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>

#include "scenes/world.h"

namespace plumbline {
namespace {

constexpr std::size_t most_triangles = 1'000'000;

/// One side of a triangle, from the lesser of its ends to the greater.
struct Edge {
    std::uint32_t lesser, greater;
    int way;  ///< +1 if the triangle runs from `lesser` to `greater`, else -1
    std::uint32_t triangle;

    auto ends() const { return std::tie(lesser, greater); }
};

/// Triangles by corners, which are one where their coordinates are the same floats.
struct Triangles {
    std::vector<glm::dvec3> corners;
    std::vector<std::array<std::uint32_t, 3>> of;  ///< indices into corners
};

/// Sets that are joined two at a time [Galler and Fischer 1964].
class Sets {
 public:
    explicit Sets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }
    std::uint32_t of(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::uint32_t a, std::uint32_t b) { parent_[of(a)] = of(b); }

 private:
    std::vector<std::uint32_t> parent_;
};

bool moves(const Scene& scene, int object) {
    for (; object >= 0; object = scene.objects[std::size_t(object)].parent) {
        if (!scene.objects[std::size_t(object)].animation.empty()) return true;
    }
    return false;
}

Triangles unmoved_triangles(const Scene& scene, const World& world) {
    Triangles triangles;
    const auto before = [](const glm::vec3& a, const glm::vec3& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    };
    std::map<glm::vec3, std::uint32_t, decltype(before)> corner_at(before);
    const auto corner = [&](const glm::vec3& p) {
        const auto [found, added] =
            corner_at.try_emplace(p, static_cast<std::uint32_t>(triangles.corners.size()));
        if (added) triangles.corners.emplace_back(p);
        return found->second;
    };
    for (const WorldMesh& mesh : world.meshes) {
        if (moves(scene, mesh.object)) continue;
        for (const glm::uvec3& t : mesh.triangles) {
            triangles.of.push_back({corner(mesh.positions[t.x]), corner(mesh.positions[t.y]),
                                    corner(mesh.positions[t.z])});
        }
    }
    return triangles;
}

constexpr std::uint32_t none = ~0u;

/// For each triangle, the body to which it belongs: triangles connected by edges, each of which is
/// run along as often one way as the other; or `none`.
std::vector<std::uint32_t> bodies_of(const Triangles& triangles) {
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < triangles.of.size(); ++i) {
        for (std::size_t side = 0; side < 3; ++side) {
            const std::uint32_t a = triangles.of[i][side];
            const std::uint32_t b = triangles.of[i][(side + 1) % 3];
            if (a == b) continue;
            edges.push_back(
                {std::min(a, b), std::max(a, b), a < b ? 1 : -1, static_cast<std::uint32_t>(i)});
        }
    }
    std::sort(edges.begin(), edges.end(),
              [](const Edge& a, const Edge& b) { return a.ends() < b.ends(); });
    Sets sets(triangles.of.size());
    std::vector<std::uint32_t> at_a_gap;
    for (std::size_t first = 0; first < edges.size();) {
        std::size_t last = first;
        int sum = 0;
        for (; last < edges.size() && edges[last].ends() == edges[first].ends(); ++last) {
            sum += edges[last].way;
            sets.join(edges[last].triangle, edges[first].triangle);
        }
        if (sum != 0) at_a_gap.push_back(edges[first].triangle);
        first = last;
    }
    std::vector<bool> open(triangles.of.size(), false);
    for (const std::uint32_t triangle : at_a_gap) open[sets.of(triangle)] = true;
    std::vector<std::uint32_t> bodies(triangles.of.size());
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
        bodies[i] = open[sets.of(i)] ? none : sets.of(i);
    }
    return bodies;
}

/// The solid angle of a triangle seen from the origin, above 0 if it faces it; NaN if it holds the
/// origin, as nearly as can be told [van Oosterom and Strackee 1983, eq. 8].
double solid_angle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    const double scale = la * lb * lc;
    const double volume = -glm::dot(a, glm::cross(b, c));
    const double cosines = scale + glm::dot(a, b) * lc + glm::dot(a, c) * lb + glm::dot(b, c) * la;
    constexpr double nearest = 1e-6;  // as a share of `scale`
    const bool told = std::abs(volume) > nearest * scale || cosines > nearest * scale;
    return told ? 2. * std::atan2(volume, cosines) : std::numeric_limits<double>::quiet_NaN();
}

bool body_of_triangles_holds(const Triangles& triangles, const glm::dvec3& x) {
    const std::vector<std::uint32_t> bodies = bodies_of(triangles);
    std::map<std::uint32_t, double> angles;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (bodies[i] == none) continue;
        const auto& [a, b, c] = triangles.of[i];
        angles[bodies[i]] += solid_angle(triangles.corners[a] - x, triangles.corners[b] - x,
                                         triangles.corners[c] - x);
    }
    return std::ranges::any_of(angles, [](const auto& body) {
        const double w = body.second / (4. * glm::pi<double>());
        constexpr double rounding = .01;  // far more than a million sums can come to
        return std::abs(w - std::round(w)) < rounding && std::round(w) >= 1.;
    });
}

bool sphere_holds(const WorldSphere& sphere, const glm::dvec3& x) {
    constexpr double too_near = 1e-4;  // as a share of the radius
    return sphere.inward &&
           glm::length(x - glm::dvec3(sphere.center)) < (1. - too_near) * double(sphere.radius);
}

}  // namespace

Enclosure enclosure(const Scene& scene) {
    const std::string not_proven = "the scene is not proven closed: ";
    const World world = world_at(scene, 0);
    if (world.triangle_count() > most_triangles) {
        return {false, not_proven + fmt::format("more than {} triangles", most_triangles)};
    }
    const glm::dvec3 eye(scene.camera.eye);
    const bool held = std::ranges::any_of(world.spheres, [&](const WorldSphere& sphere) {
        return !moves(scene, sphere.object) && sphere_holds(sphere, eye);
    });
    if (!held && !body_of_triangles_holds(unmoved_triangles(scene, world), eye)) {
        return {false, not_proven + "no body without a gap holds the camera and faces it"};
    }
    return {true, "a body without a gap holds the camera and faces it: no ray leaves the scene"};
}

}  // namespace plumbline
