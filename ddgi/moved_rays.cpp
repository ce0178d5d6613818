// SPDX-License-Identifier: Apache-2.0
#include "ddgi/moved_rays.h"

#include <algorithm>
#include <array>

#include "ddgi/float8.h"
#include "scenes/wide.h"

namespace plumbline::ddgi {
namespace {

static_assert(rays_in_block == float8_lanes);

/// Of the size of a solid box: a light this far from it is not in it, whatever the rounding.
constexpr float solid_clearance = 1e-3f;

/// A vector a lane.
struct Vector8 {
    Float8 x, y, z;
};

[[gnu::always_inline]] inline Vector8 load_vector8(const float* x, const float* y, const float* z) {
    return {load_float8(x), load_float8(y), load_float8(z)};
}

[[gnu::always_inline]] inline Vector8 same_vector8(const glm::vec3& v) {
    return {same_float8(v.x), same_float8(v.y), same_float8(v.z)};
}

[[gnu::always_inline]] inline Vector8 to_box(const OrientedBox& box, const Vector8& v) {
    const glm::mat3& axes = box.axes;
    return {v.x * axes[0].x + v.y * axes[0].y + v.z * axes[0].z,
            v.x * axes[1].x + v.y * axes[1].y + v.z * axes[1].z,
            v.x * axes[2].x + v.y * axes[2].y + v.z * axes[2].z};
}

/// The part of the lines origin + t direction, t from `enter` to `leave`, that lies in a slab.
[[gnu::always_inline]] inline void clip(const Float8& origin, const Float8& direction, float lower,
                                        float upper, Float8& enter, Float8& leave) {
    // 1 / 0 would give 0 * infinity, NaN, for an origin on the slab's plane.
    const Float8 inverse = 1.f / (direction == 0.f ? same_float8(1e-30f) : direction);
    const Float8 a = (lower - origin) * inverse;
    const Float8 b = (upper - origin) * inverse;
    enter = larger(enter, smaller(a, b));
    leave = smaller(leave, larger(a, b));
}

/// Bit i is set where a point origin + t direction of lane i, 0 <= t <= length, is in `bounds`, all
/// in the coordinates of the box.
[[gnu::always_inline]] inline Mask8 meeting(const Vector8& origin, const Vector8& direction,
                                            const Float8& length, const Bounds& bounds) {
    Float8 enter{};
    Float8 leave = length;
    clip(origin.x, direction.x, bounds.lower.x, bounds.upper.x, enter, leave);
    clip(origin.y, direction.y, bounds.lower.y, bounds.upper.y, enter, leave);
    clip(origin.z, direction.z, bounds.lower.z, bounds.upper.z, enter, leave);
    return enter <= leave;
}

[[gnu::always_inline]] inline bool any(const Mask8& mask) {
    std::array<std::uint64_t, sizeof mask / sizeof(std::uint64_t)> words;
    std::memcpy(&words, &mask, sizeof mask);
    std::uint64_t all = 0;
    for (const std::uint64_t word : words) all |= word;
    return all != 0;
}

[[gnu::always_inline]] inline void set(const Mask8& where, std::uint8_t mark, std::uint8_t* marks) {
    for (std::size_t i = 0; i < float8_lanes; ++i) {
        marks[i] = static_cast<std::uint8_t>(marks[i] | (where[i] & mark));
    }
}

/// The ways to a light in the coordinates of a box, which is larger by a radius: where they meet
/// it.
class WaysToBox {
 public:
    [[gnu::always_inline]] WaysToBox(const LampWay& light, const OrientedBox& box, float radius)
        : axes_{box.axes, {}},
          bounds_(box.bounds.grown(radius)),
          far_(light.direction != glm::vec3(0.f)),
          end_(box.to_box(far_ ? light.direction : light.position)),
          length_(light.length) {}

    /// Where the way from a surfel to the light comes as near to the box as the radius, or nearer.
    [[gnu::always_inline]] Mask8 meeting(const Vector8& surfels) const {
        const Vector8 surfel = to_box(axes_, surfels);
        const Vector8 end = same_vector8(end_);
        const Vector8 way =
            far_ ? end : Vector8{end.x - surfel.x, end.y - surfel.y, end.z - surfel.z};
        return ddgi::meeting(surfel, way, same_float8(length_), bounds_);
    }

 private:
    OrientedBox axes_;
    Bounds bounds_;
    bool far_;
    glm::vec3 end_;
    float length_;
};

/// Whether the ways to this light all end outside of `box`, by its margin.
bool ends_outside(const LampWay& light, const OrientedBox& box) {
    if (light.direction != glm::vec3(0.f)) return true;
    if (light.radius > 0.f) return false;
    const glm::vec3 size = box.bounds.size();
    return !box.bounds.grown(solid_clearance * max_component(size))
                .contains(box.to_box(light.position));
}

}  // namespace

std::vector<LampWay> lamp_ways(const World& world, const Motion& motion) {
    std::vector<LampWay> ways;
    for (const PointLight& light : world.lights) {
        ways.push_back({.position = light.position, .radius = light.radius});
    }
    for (const DirectionalLight& light : world.directional_lights) {
        ways.push_back(
            {.direction = -light.direction, .length = std::numeric_limits<float>::infinity()});
    }
    for (LampWay& way : ways) {
        std::ranges::copy_if(motion.solids, std::back_inserter(way.solids),
                             [&](const SolidMove& solid) {
                                 return ends_outside(way, solid.was) && ends_outside(way, solid.is);
                             });
    }
    return ways;
}

void ProbeRays::set_direction(std::size_t probe, std::size_t ray, const glm::vec3& direction) {
    values_.put(probe, Dx, ray, direction);
}

void ProbeRays::set_end(std::size_t probe, std::size_t ray, float length, const glm::vec3* surfel) {
    values_.at(probe, Length, ray) = length;
    values_.at(probe, HasSurfel, ray) = surfel != nullptr ? 1.f : 0.f;
    if (surfel != nullptr) values_.put(probe, X, ray, *surfel);
}

PLUMBLINE_WIDE void ProbeRays::mark_rays(std::size_t probe, const glm::vec3& origin,
                                         const OrientedBox& mover, std::uint8_t mark,
                                         std::span<std::uint8_t> marks) const {
    const OrientedBox box = mover;  // its own: the marks, being bytes, could be part of `mover`
    const Vector8 start = same_vector8(box.to_box(origin));
    for (std::size_t i = 0; i < values_.rays(); i += float8_lanes) {
        const Vector8 direction = load_vector8(
            values_.block(probe, Dx, i), values_.block(probe, Dy, i), values_.block(probe, Dz, i));
        const Mask8 met = meeting(start, to_box(box, direction),
                                  load_float8(values_.block(probe, Length, i)), box.bounds);
        if (any(met)) set(met, mark, &marks[i]);
    }
}

PLUMBLINE_WIDE void ProbeRays::mark_shadows(std::size_t probe, const LampWay& light,
                                            std::span<const OrientedBox> boxes, std::uint8_t mark,
                                            std::span<std::uint8_t> marks) const {
    // Box by box, so that what is known of one stays in registers.
    constexpr std::size_t groups_at_once = 8;
    std::array<Mask8, groups_at_once> met;
    for (std::size_t first = 0; first < values_.rays(); first += groups_at_once * float8_lanes) {
        const std::size_t groups =
            std::min(groups_at_once, (values_.rays() - first) / float8_lanes);
        const auto surfels = [&](std::size_t group) {
            const std::size_t i = first + group * float8_lanes;
            return load_vector8(values_.block(probe, X, i), values_.block(probe, Y, i),
                                values_.block(probe, Z, i));
        };
        met.fill(Mask8{});
        // Ways to a ball stay within its radius of the way to its centre.
        for (const OrientedBox& box : boxes) {
            const WaysToBox ways(light, box, light.radius);
            for (std::size_t g = 0; g < groups; ++g) met[g] |= ways.meeting(surfels(g));
        }
        for (std::size_t g = 0; g < groups; ++g) {
            const std::size_t i = first + g * float8_lanes;
            met[g] &= load_float8(values_.block(probe, HasSurfel, i)) > 0.f;
        }
        for (const SolidMove& solid : light.solids) {
            const WaysToBox was(light, solid.was, 0.f);
            const WaysToBox is(light, solid.is, 0.f);
            for (std::size_t g = 0; g < groups; ++g) {
                if (any(met[g])) met[g] &= ~(was.meeting(surfels(g)) & is.meeting(surfels(g)));
            }
        }
        for (std::size_t g = 0; g < groups; ++g) {
            if (any(met[g])) set(met[g], mark, &marks[first + g * float8_lanes]);
        }
    }
}

}  // namespace plumbline::ddgi
