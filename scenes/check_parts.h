// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <set>
#include <string>

#include "scenes/scene_checks.h"

namespace plumbline {

inline bool finite(float v) { return std::isfinite(v); }
inline bool finite(const glm::vec3& v) { return finite(v.x) && finite(v.y) && finite(v.z); }
inline bool finite(const glm::quat& q) {
    return finite(q.x) && finite(q.y) && finite(q.z) && finite(q.w);
}

/// One element of a scene under check: knows its place, and throws from there.
class Checked {
 public:
    Checked(const PlaceOf& place_of, std::string_view list, std::size_t index = 0)
        : place_of_(place_of), list_(list), index_(index) {}

    [[noreturn]] void fail(std::string_view member, const std::string& problem,
                           const std::string& cure) const;

    template <typename T>
    void expect_finite(std::string_view member, const T& value) const {
        if (!finite(value)) fail(member, "is not finite", "write finite numbers");
    }
    /// Refuses values below zero, such as negative power.
    void expect_not_negative(std::string_view member, const Spectrum& value) const;
    /// Refuses a direction that is not finite or has length zero.
    void expect_direction(std::string_view member, const glm::vec3& value) const;
    void expect_albedo(std::string_view member, const Spectrum& value) const;
    void expect_index(std::string_view member, int index, std::size_t count,
                      const std::string& what) const;
    void expect_new_name(const std::string& name, std::set<std::string>& seen) const;

 private:
    const PlaceOf& place_of_;
    std::string_view list_;
    std::size_t index_;
};

/// The parts of check_scene, in the order in which they run.
void check_materials(const Scene& scene, const PlaceOf& place_of);
void check_meshes(const Scene& scene, const PlaceOf& place_of);
void check_objects(const Scene& scene, const PlaceOf& place_of);
void check_lights(const Scene& scene, const PlaceOf& place_of);
/// Refuses what may at some frame be farther than farthest_place from the origin.
void check_places(const Scene& scene, const PlaceOf& place_of);

}  // namespace plumbline
