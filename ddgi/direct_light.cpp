// SPDX-License-Identifier: Apache-2.0
#include "ddgi/direct_light.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <optional>

#include "scenes/lanes.h"

namespace plumbline::ddgi {
namespace {

/// A number of [0,1) that depends on every bit of a position: PCG's output permutation as a hash
/// [Jarzynski and Olano 2020].
float hashed(const glm::vec3& position, std::uint32_t salt) {
    std::uint32_t hash = salt;
    for (int axis = 0; axis < 3; ++axis) {
        std::uint32_t state = (hash ^ std::bit_cast<std::uint32_t>(position[axis])) * 747796405u;
        state += 2891336453u;
        const std::uint32_t word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
        hash = (word >> 22) ^ word;
    }
    return static_cast<float>(hash >> 8) * 0x1p-24f;
}

/// Irradiance at a point from a light's ball, by rays evenly spread over the solid angle that it
/// fills: a golden-angle spiral, shifted and turned at random from point to point so that
/// neighbours' errors differ and average out.
DirectLight from_ball(const RayTracer& tracer, const PointLight& light, const glm::vec3& position,
                      const glm::vec3& n, int rays) {
    const glm::vec3 way = light.position - position;
    const float d2 = glm::dot(way, way);
    const float r2 = light.radius * light.radius;
    DirectLight result;
    if (d2 <= r2) return result;  // inside the ball, which shines outward
    const float cone_cosine = std::sqrt(1.f - r2 / d2);
    const float height_of_cap = r2 / d2 / (1.f + cone_cosine);  // 1 - cosine, without cancellation
    const Spectrum radiance = normal_irradiance(light, way) * (d2 / (glm::pi<float>() * r2));
    const glm::vec3 axis = way / std::sqrt(d2);
    const glm::vec3 helper = std::abs(axis.x) < .5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::vec3 u = glm::normalize(glm::cross(helper, axis));
    const glm::vec3 v = glm::cross(axis, u);
    const float golden_angle = glm::pi<float>() * (3.f - std::sqrt(5.f));
    const float shift = hashed(position, 1u);
    const float turn = 2.f * glm::pi<float>() * hashed(position, 2u);
    float cosines = 0.f;
    for (int ray = 0; ray < rays; ++ray) {
        const float share = (static_cast<float>(ray) + shift) / static_cast<float>(rays);
        const float down = share * height_of_cap;
        const float sine = std::sqrt(down * (2.f - down));
        const float phi = turn + golden_angle * static_cast<float>(ray);
        const glm::vec3 direction =
            (1.f - down) * axis + sine * (std::cos(phi) * u + std::sin(phi) * v);
        const float cosine = glm::dot(n, direction);
        if (cosine <= 0.f) continue;
        ++result.shadow_rays;
        // To the ball's near side, as the rays to a point end at the point.
        const float along = glm::dot(way, direction);
        const float half_chord = std::sqrt(glm::max(along * along - (d2 - r2), 0.f));
        if (!tracer.occluded(position, position + (along - half_chord) * direction)) {
            cosines += cosine;
        }
    }
    const float solid_angle = 2.f * glm::pi<float>() * height_of_cap;
    result.irradiance = radiance * (solid_angle * cosines / static_cast<float>(rays));
    return result;
}

/// What a light brings to a point if nothing stands on the way.
struct LightWay {
    glm::vec3 end;
    Spectrum irradiance;
};

/// None if no light could come.
std::optional<LightWay> way_to(const PointLight& light, const glm::vec3& position,
                               const glm::vec3& n) {
    const glm::vec3 way = light.position - position;
    const float height = glm::dot(n, way);
    if (height <= 0.f) return std::nullopt;
    const Spectrum E = normal_irradiance(light, way);
    if (light.cone && E == Spectrum(0.f)) return std::nullopt;
    return LightWay{light.position, height / glm::length(way) * E};
}

std::optional<LightWay> way_to(const DirectionalLight& light, float reach,
                               const glm::vec3& position, const glm::vec3& n) {
    const float cosine = -glm::dot(n, light.direction);
    if (cosine <= 0.f) return std::nullopt;
    return LightWay{position - reach * light.direction, cosine * light.irradiance};
}

DirectLight along(const RayTracer& tracer, const std::optional<LightWay>& way,
                  const glm::vec3& position, int rays) {
    DirectLight result;
    if (!way) return result;
    // The rays to a point are all the same.
    int arriving = 0;
    for (int ray = 0; ray < rays; ++ray) {
        if (!tracer.occluded(position, way->end)) ++arriving;
    }
    result.shadow_rays = static_cast<std::uint32_t>(rays);
    result.irradiance = static_cast<float>(arriving) / static_cast<float>(rays) * way->irradiance;
    return result;
}

void add(const DirectLight& light, DirectLight& sum) {
    sum.irradiance += light.irradiance;
    sum.shadow_rays += light.shadow_rays;
}

/// Ways that light comes along if nothing stands on them, as many as are traced together.
struct OpenWays {
    SegmentLanes segments;
    Lanes<std::uint32_t> point;
    Lanes3 irradiance;
};

/// Adds what arrives along `ways` to their points.
void add_arriving(const RayTracer& tracer, OpenWays& ways, std::span<DirectLight> at) {
    Lanes<std::int32_t> hidden;
    tracer.occluded(ways.segments, hidden);
    for (std::size_t i = 0; i < ways.segments.count; ++i) {
        DirectLight& light = at[ways.point[i]];
        ++light.shadow_rays;
        if (hidden[i] == 0) light.irradiance += ways.irradiance[i];
    }
    ways.segments.count = 0;
}

/// Adds what comes along way_of(i) to at[i].
template <typename WayOf>
void add_along(const RayTracer& tracer, std::span<const glm::vec3> positions, const WayOf& way_of,
               std::span<DirectLight> at) {
    OpenWays ways;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const std::optional<LightWay> way = way_of(i);
        if (!way) continue;
        ways.point[ways.segments.count] = static_cast<std::uint32_t>(i);
        ways.irradiance.set(ways.segments.count, way->irradiance);
        ways.segments.push({positions[i], way->end});
        if (ways.segments.count == plumbline::lane_count) add_arriving(tracer, ways, at);
    }
    add_arriving(tracer, ways, at);
}

}  // namespace

DirectLight direct_light(const RayTracer& tracer, const glm::vec3& position, const glm::vec3& n,
                         int rays) {
    DirectLight sum;
    for (const PointLight& light : tracer.world().lights) {
        add(light.radius > 0.f ? from_ball(tracer, light, position, n, rays)
                               : along(tracer, way_to(light, position, n), position, rays),
            sum);
    }
    for (const DirectionalLight& light : tracer.world().directional_lights) {
        add(along(tracer, way_to(light, tracer.world().reach, position, n), position, 1), sum);
    }
    return sum;
}

void direct_light(const RayTracer& tracer, std::span<const glm::vec3> positions,
                  std::span<const glm::vec3> n, std::span<DirectLight> at) {
    const World& world = tracer.world();
    std::ranges::fill(at, DirectLight{});
    for (const PointLight& light : world.lights) {
        if (light.radius > 0.f) {
            for (std::size_t i = 0; i < positions.size(); ++i) {
                add(from_ball(tracer, light, positions[i], n[i], 1), at[i]);
            }
            continue;
        }
        add_along(
            tracer, positions, [&](std::size_t i) { return way_to(light, positions[i], n[i]); },
            at);
    }
    for (const DirectionalLight& light : world.directional_lights) {
        add_along(
            tracer, positions,
            [&](std::size_t i) { return way_to(light, world.reach, positions[i], n[i]); }, at);
    }
}

}  // namespace plumbline::ddgi
