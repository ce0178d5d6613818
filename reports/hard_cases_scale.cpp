// SPDX-License-Identifier: Apache-2.0
// Scale and place: radiance has no unit of length in it.
#include <fmt/format.h>

#include <limits>
#include <numbers>

#include "reports/hard_case.h"
#include "reports/hard_scenes.h"
#include "scenes/inspection.h"
#include "scenes/scene_files.h"

namespace plumbline::reports {
namespace {

/// Radiance of an integrating sphere of albedo rho with a lamp of intensity I in its middle:
/// (rho / pi) I / r^2 / (1 - rho), everywhere alike [Jacquez and Kuppenheim 1955].
constexpr double sphere_radiance = .7 * std::numbers::inv_pi / .3;

Scene library_scene(const char* name) {
    Scene scene = load_scene(name);
    scene.camera.width = hard_width;
    scene.camera.height = hard_height;
    return scene;
}

/// With every fourth probe along each axis.
Scene cornell_box() {
    Scene scene = library_scene("cornell-box");
    scene.probes->spacing *= 4.f;
    scene.probes->counts = (scene.probes->counts - 1) / 4 + 1;
    return scene;
}

/// How far a float can place a point of this scene, relative to its size.
double resolution(const Scene& scene) {
    const Bounds bounds = world_at(scene, 0).bounds();
    const float farthest =
        std::max(max_component(glm::abs(bounds.lower)), max_component(glm::abs(bounds.upper)));
    const float step = std::nextafter(farthest, std::numeric_limits<float>::infinity()) - farthest;
    return double(step) / double(max_component(bounds.size()));
}

void glow(Trial& trial, const Scene& scene) {
    const auto truth = trial.truth(scene, 0, {.spp = 16, .max_bounces = 8});
    // Points are off their walls by the resolution; a path that slips out there loses its light.
    const double rounding = 1e-5 + 10. * resolution(scene);
    trial.near(Trial::pathtracer, "mean radiance after 8 bounces", mean_radiance(truth.image),
               furnace_series(8), rounding);
    for (const std::string& model : ddgi::model_names()) {
        const auto probes = trial.probes(scene, model);
        if (model == "thesis") continue;  // its energy depends on the unit of length
        // Converged to a relative change of 1e-4, albedo 1/2: twice that from the limit.
        trial.near(model, "mean radiance", mean_radiance(probes.image), furnace_radiance,
                   furnace_radiance * 2e-4 + rounding);
    }
}

void sphere(Trial& trial, const Scene& scene) {
    const auto truth = trial.truth(scene, 0, {.spp = 64});
    trial.near(Trial::pathtracer, "mean radiance", mean_radiance(truth.image), sphere_radiance,
               5. * mean_error(truth.image) + 10. * resolution(scene));
    for (const std::string& model : ddgi::model_names()) trial.probes(scene, model);
}

/// The picture at another scale or place must be the picture.
void same_picture(Trial& trial, const Scene& plain, const Scene& scene) {
    const pathtracer::RenderOptions options{.spp = 16};
    const Image reference = pathtracer::render(plain, 0, options).image;
    const Image truth = trial.truth(scene, 0, options).image;
    trial.near(Trial::pathtracer, "mean radiance against the plain scene", mean_radiance(truth),
               mean_radiance(reference), 5. * (mean_error(truth) + mean_error(reference)));
    for (const std::string& model : ddgi::model_names()) {
        const Image probes = trial.probes(scene, model).image;
        if (model == "thesis") continue;
        ddgi::DdgiOptions of_model;
        of_model.model = model;
        const double expected = mean_radiance(ddgi::render(plain, 0, of_model).image);
        // Of 14 thousand rays those level with an edge or a face fall on either side of it once
        // rounding moves it: some tens, and what the pixels near them see.
        trial.near(model, "mean radiance against the plain scene", mean_radiance(probes), expected,
                   expected * (.004 + 20. * resolution(scene)));
    }
}

void beyond_floats(Trial& trial, const Scene& scene) {
    const std::vector<std::string> warnings = scene_warnings(scene, world_at(scene, 0));
    trial.within("inspect", "warnings that a float cannot carry this", double(warnings.size()), 1.,
                 1e9);
    trial.truth(scene, 0, {.spp = 4});
    for (const std::string& model : ddgi::model_names()) trial.probes(scene, model);
}

void add_scaled(std::vector<HardCase>& cases, float scale) {
    const std::string place = fmt::format("at scale {:g}", scale);
    cases.push_back({"scale", "furnace " + place,
                     "radiance 2 at any scale: series exact, converged to twice the last change",
                     [=](Trial& t) { glow(t, scaled_and_moved(furnace(), scale, {})); }});
    cases.push_back({"scale", "integrating sphere " + place, "closed form within 5 standard errors",
                     [=](Trial& t) {
                         sphere(t,
                                scaled_and_moved(library_scene("integrating-sphere"), scale, {}));
                     }});
    cases.push_back({"scale", "cornell-box " + place,
                     "the picture of scale 1 within 5 standard errors", [=](Trial& t) {
                         const Scene plain = cornell_box();
                         same_picture(t, plain, scaled_and_moved(plain, scale, {}));
                     }});
}

void add_moved(std::vector<HardCase>& cases, float distance) {
    const glm::vec3 shift(distance, -distance, distance / 2.f);
    const std::string place = fmt::format("moved by {:g}", distance);
    const Scene moved = scaled_and_moved(furnace(), 1.f, shift);
    const char* told = "beyond what a float can carry: told by inspect, nothing not finite";
    if (resolution(moved) > 1e-3) {
        cases.push_back(
            {"scale", "furnace " + place, told, [=](Trial& t) { beyond_floats(t, moved); }});
    } else {
        cases.push_back({"scale", "furnace " + place, "radiance 2 within ten steps of a float",
                         [=](Trial& t) { glow(t, moved); }});
    }
    const Scene box = cornell_box();
    const Scene moved_box = scaled_and_moved(box, 1.f, shift);
    constexpr double coarse = 1e-4;  // from here on inspect warns
    if (resolution(moved_box) > coarse) {
        cases.push_back({"scale", "cornell-box " + place, told,
                         [=](Trial& t) { beyond_floats(t, moved_box); }});
        return;
    }
    cases.push_back({"scale", "cornell-box " + place,
                     "the picture at the origin within 5 standard errors",
                     [=](Trial& t) { same_picture(t, box, moved_box); }});
}

}  // namespace

void add_scale_cases(std::vector<HardCase>& cases) {
    for (const float scale : {1e-6f, 1e-4f, 1.f, 1e4f, 1e9f}) add_scaled(cases, scale);
    for (const float distance : {1e3f, 1e5f, 1e6f}) add_moved(cases, distance);
}

}  // namespace plumbline::reports
