// SPDX-License-Identifier: Apache-2.0
// Light at the limit: on, in and inside surfaces, too weak, too strong, too many, none.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "reports/hard_case.h"
#include "reports/hard_scenes.h"
#include "reports/layer_statistics.h"
#include "scenes/inspection.h"
#include "scenes/scene_files.h"

namespace plumbline::reports {
namespace {

Scene room_with_light(const glm::vec3& position) {
    Scene scene = lit_room();
    scene.lights.clear();
    add_point_light(scene, position, Spectrum(1.f));
    return scene;
}

void every_renderer(Trial& trial, const Scene& scene, int frame = 0) {
    trial.truth(scene, frame, {.spp = 16});
    for (const std::string& model : ddgi::model_names()) trial.probes(scene, model, frame);
}

/// The thesis's look-up knows no walls: what a probe in a block sees of its inside leaks out.
enum class Leaks { None, Thesis };

void stays_dark(Trial& trial, const Scene& scene, Leaks leaks = Leaks::None) {
    const auto truth = trial.truth(scene, 0, {.spp = 16});
    trial.within(Trial::pathtracer, "mean radiance", mean_radiance(truth.image), 0., 0.);
    for (const std::string& model : ddgi::model_names()) {
        ddgi::DdgiOptions options;
        if (model == "thesis") options.set["ambient"] = 0.;
        const double brightest = model == "thesis" && leaks == Leaks::Thesis ? 1. : 0.;
        trial.within(model, "mean radiance",
                     mean_radiance(trial.probes(scene, model, 0, options).image), 0., brightest);
    }
}

/// A light just off the floor: what the floor below it sends back comes from a spot that no
/// path finds. The rest must stay, and the user be told.
void near_a_wall(Trial& trial) {
    const Scene scene = room_with_light({.3f, -1.f + 1e-6f, -.2f});
    every_renderer(trial, scene);
    trial.within("inspect", "warnings of the light's distance",
                 double(scene_warnings(scene, world_at(scene, 0)).size()), 1., 1e9);
}

/// Light is linear: the picture over the intensity is the same at any intensity. The thesis clamps
/// its surfels at 1, as published: it can only be dimmer.
void any_intensity(Trial& trial, float intensity) {
    Scene plain = lit_room();
    Scene extreme = plain;
    for (PointLight& light : extreme.lights) light.intensity *= intensity;
    const pathtracer::RenderOptions options{.spp = 16, .max_bounces = 4};
    const double expected = mean_radiance(pathtracer::render(plain, 0, options).image);
    // Every product and sum rounds relatively, so ratios stay to a few units in the last place.
    trial.near(Trial::pathtracer, "mean radiance over the intensity",
               mean_radiance(trial.truth(extreme, 0, options).image) / double(intensity), expected,
               1e-5 * expected);
    for (const std::string& model : ddgi::model_names()) {
        ddgi::DdgiOptions of_model;
        of_model.model = model;
        if (model == "thesis") of_model.set["ambient"] = 0.;
        const double plainly = mean_radiance(ddgi::render(plain, 0, of_model).image);
        const double dimmest = model == "thesis" && intensity > 1.f ? 0. : plainly * (1. - 1e-5);
        trial.within(
            model, "mean radiance over the intensity",
            mean_radiance(trial.probes(extreme, model, 0, of_model).image) / double(intensity),
            dimmest, plainly * (1. + 1e-5));
    }
}

/// A thousand lights in one place are one light of a thousand times the intensity.
void a_thousand_lights(Trial& trial) {
    Scene one = lit_room();
    Scene thousand = one;
    thousand.lights.clear();
    for (int i = 0; i < 1000; ++i) {
        add_point_light(thousand, one.lights[0].position, one.lights[0].intensity / 1000.f);
    }
    const Image expected = pathtracer::render(one, 0, {.spp = 64}).image;
    const Image truth = trial.truth(thousand, 0, {.spp = 4}).image;
    trial.near(Trial::pathtracer, "mean radiance against one light", mean_radiance(truth),
               mean_radiance(expected), 5. * (mean_error(truth) + mean_error(expected)));
    for (const std::string& model : ddgi::model_names()) {
        ddgi::DdgiOptions options;
        options.model = model;
        const double plain = mean_radiance(ddgi::render(one, 0, options).image);
        // A thousand rounded sums: 1000 / 2^24 relatively at the very most.
        trial.near(model, "mean radiance against one light",
                   mean_radiance(trial.probes(thousand, model, 0, options).image), plain,
                   plain * 1000. * 0x1p-24);
    }
}

/// Irradiance of a point light over its whole sphere of directions is 4 pi I, wherever it stands.
void sphere_off_center(Trial& trial, float distance) {
    Scene scene;
    scene.name = "hard case";
    const int material = add_material(scene, Spectrum(.7f));
    add_object(scene, "sphere", Sphere{glm::vec3(0.f), 1.f, true, material});
    add_point_light(scene, {distance, 0.f, 0.f}, Spectrum(1.f));
    scene.camera.eye = {0.f, 0.f, -.9f};
    scene.camera.target = glm::vec3(0.f);
    scene.camera.vertical_fov = 1.f;
    scene.camera.width = hard_width;
    scene.camera.height = hard_height;
    scene.probes = ProbeGrid{glm::vec3(-.5f), .2f, {6, 6, 6}};
    const auto truth = trial.truth(scene, 0, {.spp = 256});
    // In a sphere every point lights every other alike: indirect = (rho^2 / pi) I / r^2 / (1 -
    // rho).
    const double expected = .49 * std::numbers::inv_pi / .3;
    trial.near(Trial::pathtracer, "mean indirect radiance", layer_mean(truth.image, "indirect"),
               expected, 5. * mean_error(truth.image));
    for (const std::string& model : ddgi::model_names()) trial.probes(scene, model);
}

void add_places(std::vector<HardCase>& cases) {
    const auto add = [&](const char* name, const glm::vec3& position) {
        cases.push_back({"light", name, "every value finite, none negative",
                         [=](Trial& t) { every_renderer(t, room_with_light(position)); }});
    };
    add("light exactly on a wall", {.3f, -1.f, -.2f});
    add("light exactly in a corner", {1.f, 1.f, 1.f});
    add("light on an edge of the block", {-.2f, -.3f, .1f});
    add("light level with the top of the block", {.9f, -.3f, -.5f});
    add("light in the eye", {-.7f, .2f, -.8f});
    cases.push_back({"light", "light inside a block",
                     "black to the bit, but for the thesis, whose look-up knows no walls",
                     [](Trial& t) {
                         stays_dark(t, room_with_light({.1f, -.6f, .4f}), Leaks::Thesis);
                     }});
    cases.push_back({"light", "light outside the closed room", "black to the bit", [](Trial& t) {
                         stays_dark(t, room_with_light({3.f, 0.f, 0.f}));
                     }});
    cases.push_back({"light", "light 1e-6 off a wall",
                     "every value finite; inspect says that the spot below it is not sampled",
                     near_a_wall});
}

}  // namespace

void add_light_cases(std::vector<HardCase>& cases) {
    add_places(cases);
    cases.push_back({"light", "door wide open in room-with-door",
                     "a light level with the edges of the doorway: every value finite",
                     [](Trial& t) {
                         Scene scene = load_scene("room-with-door");
                         scene.camera.width = hard_width;
                         scene.camera.height = hard_height;
                         scene.probes->spacing = 40.f;
                         scene.probes->counts = {11, 6, 11};
                         every_renderer(t, scene);
                     }});
    for (const float intensity : {1e-30f, 1e30f}) {
        cases.push_back({"light", fmt::format("intensity {:g}", intensity),
                         "linear in the light to 1e-5",
                         [=](Trial& t) { any_intensity(t, intensity); }});
    }
    cases.push_back({"light", "no light at all", "black to the bit", [](Trial& t) {
                         Scene scene = lit_room();
                         scene.lights.clear();
                         stays_dark(t, scene);
                     }});
    cases.push_back({"light", "a thousand lights",
                     "the picture of one light a thousand times as strong", a_thousand_lights});
    for (const float distance : {.5f, .99f}) {
        cases.push_back({"light",
                         fmt::format("lamp {:g} from the middle of a unit sphere", distance),
                         "indirect (rho^2 / pi) I / (1 - rho) wherever the lamp stands",
                         [=](Trial& t) { sphere_off_center(t, distance); }});
    }
}

}  // namespace plumbline::reports
