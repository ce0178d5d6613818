// SPDX-License-Identifier: Apache-2.0
#include "scenes/scene_checks.h"

#include <fmt/format.h>

#include <glm/gtc/constants.hpp>

#include "scenes/check_parts.h"
#include "scenes/errors.h"
#include "scenes/nearest_name.h"

namespace plumbline {

void Checked::fail(std::string_view member, const std::string& problem,
                   const std::string& cure) const {
    throw SceneError(place_of_(list_, index_, member), problem, cure);
}

void Checked::expect_not_negative(std::string_view member, const Spectrum& value) const {
    expect_finite(member, value);
    if (min_component(value) < 0.f) {
        fail(member, fmt::format("is negative ({:g})", min_component(value)),
             "light has a power of 0 or more");
    }
}

void Checked::expect_direction(std::string_view member, const glm::vec3& value) const {
    expect_finite(member, value);
    if (value == glm::vec3(0.f)) fail(member, "has length zero", "[0, -1, 0] is straight down");
}

void Checked::expect_albedo(std::string_view member, const Spectrum& value) const {
    expect_finite(member, value);
    if (min_component(value) >= 0.f && max_component(value) <= 1.f) return;
    const float bad = min_component(value) < 0.f ? min_component(value) : max_component(value);
    fail(member, fmt::format("is {:g}, outside [0, 1]", bad),
         "a surface cannot reflect more light than falls on it, nor less than none");
}

void Checked::expect_index(std::string_view member, int index, std::size_t count,
                           const std::string& what) const {
    if (index >= 0 && std::size_t(index) < count) return;
    fail(member, fmt::format("asks for {} {}", what, index),
         count == 0 ? "there are none" : fmt::format("there are 0 to {}", count - 1));
}

void Checked::expect_new_name(const std::string& name, std::set<std::string>& seen) const {
    if (seen.insert(name).second) return;
    fail("name", in_quotes(name) + " is the name of an earlier one too",
         "give each a name of its own");
}

namespace {

void check_camera(const Camera& camera, const PlaceOf& place_of) {
    const Checked checked(place_of, "camera");
    checked.expect_finite("eye", camera.eye);
    checked.expect_finite("target", camera.target);
    checked.expect_finite("up", camera.up);
    const glm::dvec3 view = glm::dvec3(camera.target) - glm::dvec3(camera.eye);
    const glm::dvec3 up(camera.up);
    if (glm::length(view) == 0) checked.fail("target", "is the eye itself", "look elsewhere");
    if (glm::length(up) == 0) checked.fail("up", "has length zero", "[0, 1, 0] is y up");
    // Below this sine a float has too few digits left to say where "right" is.
    constexpr double least_sine = 1e-5;
    if (glm::length(glm::cross(view, up)) < least_sine * glm::length(view) * glm::length(up)) {
        checked.fail("up", "is parallel to the view", "[0, 0, 1] serves when looking along y");
    }
    if (!(camera.vertical_fov > 0.f && camera.vertical_fov < glm::pi<float>())) {
        checked.fail("vertical_fov", fmt::format("is {:g}", glm::degrees(camera.vertical_fov)),
                     "it lies between 0 and 180 degrees");
    }
    if (camera.width < 1 || camera.height < 1 || camera.width > max_image_side ||
        camera.height > max_image_side || camera.width > max_pixels / camera.height) {
        checked.fail("", fmt::format("asks for {}x{} pixels", camera.width, camera.height),
                     fmt::format("a picture has 1 to {} pixels a side, {} in all", max_image_side,
                                 max_pixels));
    }
}

void check_probes(const ProbeGrid& probes, const PlaceOf& place_of) {
    const Checked checked(place_of, "probes");
    checked.expect_finite("origin", probes.origin);
    if (!(probes.spacing >= smallest_size) || !finite(probes.spacing)) {
        checked.fail("spacing", fmt::format("is {:g}", probes.spacing),
                     fmt::format("the distance between probes is {:g} or more", smallest_size));
    }
    const glm::dvec3 counts(probes.counts);
    if (glm::any(glm::lessThan(probes.counts, glm::ivec3(1))) ||
        counts.x * counts.y * counts.z > max_probes) {
        checked.fail("counts",
                     fmt::format("ask for {} x {} x {} probes", probes.counts.x, probes.counts.y,
                                 probes.counts.z),
                     fmt::format("each is at least 1, and all probes at most {}", max_probes));
    }
}

void check_frames(const Scene& scene, const PlaceOf& place_of) {
    if (scene.frames < 1 || scene.frames > max_frames) {
        Checked(place_of, "frames")
            .fail("", fmt::format("is {}", scene.frames),
                  fmt::format("a scene has 1 to {}", max_frames));
    }
    if (scene.report_frame < 0 || scene.report_frame >= scene.frames) {
        Checked(place_of, "report_frame")
            .fail("", fmt::format("is {}", scene.report_frame),
                  fmt::format("the scene has frames 0 to {}", scene.frames - 1));
    }
    if (!(scene.frames_per_second > 0.f) || !finite(scene.frames_per_second)) {
        Checked(place_of, "frames_per_second")
            .fail("", fmt::format("is {:g}", scene.frames_per_second), "it is above 0");
    }
}

void check_thesis(const ThesisConstants& thesis, const PlaceOf& place_of) {
    const Checked checked(place_of, "thesis");
    checked.expect_finite("falloffRegulator", thesis.falloffRegulator);
    checked.expect_finite("bounceAttenuation", thesis.bounceAttenuation);
    checked.expect_finite("probeBrightness", thesis.probeBrightness);
    checked.expect_finite("multiBounceIntensity", thesis.multiBounceIntensity);
    checked.expect_finite("ambient", thesis.ambient);
    checked.expect_finite("imageBrightness", thesis.imageBrightness);
}

}  // namespace

void check_scene(const Scene& scene, const PlaceOf& place_of) {
    check_materials(scene, place_of);
    check_meshes(scene, place_of);
    check_objects(scene, place_of);
    check_lights(scene, place_of);
    const Checked environment(place_of, "environment");
    environment.expect_not_negative("", scene.environment);
    if (scene.environment_image) {
        environment.expect_finite("rotation", scene.environment_image->rotation);
    }
    check_camera(scene.camera, place_of);
    check_frames(scene, place_of);
    if (scene.probes) check_probes(*scene.probes, place_of);
    check_places(scene, place_of);
    if (scene.thesis) check_thesis(*scene.thesis, place_of);
}

}  // namespace plumbline
