// SPDX-License-Identifier: Apache-2.0
// Probes where they should not be, in numbers that they should not have.
#include <cmath>

#include "reports/hard_case.h"
#include "reports/hard_scenes.h"
#include "scenes/errors.h"

namespace plumbline::reports {
namespace {

bool refuses(const Scene& scene, const std::string& model) {
    ddgi::DdgiOptions options;
    options.model = model;
    try {
        ddgi::render(scene, 0, options);
    } catch (const UsageError&) {
        return true;
    }
    return false;
}

/// Whatever the grid: finite values, the cache changes nothing, and in a furnace no model that
/// conserves energy shows more than there is.
void any_grid(Trial& trial, const Scene& scene, double darkest) {
    for (const std::string& model : ddgi::model_names()) {
        if (model == "thesis" && glm::any(glm::lessThan(scene.probes->counts, glm::ivec3(3)))) {
            trial.claim(model, "refuses a grid without inner probes", refuses(scene, model));
            continue;
        }
        const Image cached = trial.probes(scene, model).image;
        ddgi::DdgiOptions options;
        options.cache = false;
        trial.claim(model, "same bytes without the cache",
                    same_pixels(cached, trial.probes(scene, model, 0, options).image));
        if (model == "thesis") continue;  // it does not conserve energy
        double highest = 0.;
        for (const std::span<const float> channel : cached.layer("")) {
            for (const float value : channel) highest = std::max(highest, double(value));
        }
        trial.within(model, "brightest value", highest, 0., furnace_radiance * (1. + 1e-5));
        trial.within(model, "mean radiance", mean_radiance(cached), darkest,
                     furnace_radiance * (1. + 1e-5));
    }
}

Scene with_grid(const glm::vec3& origin, float spacing, const glm::ivec3& counts) {
    Scene scene = furnace();
    scene.probes = ProbeGrid{origin, spacing, counts};
    return scene;
}

constexpr double all_light = furnace_radiance * (1. - 2e-4);
constexpr double own_glow = 1. - 1e-6;  // what a surface shows that gets nothing from the probes

}  // namespace

void add_probe_cases(std::vector<HardCase>& cases) {
    const char* full = "2 in every pixel where all probes are inside; same bytes without the cache";
    const char* bounded = "between the surfaces' own glow of 1 and 2; same bytes without the cache";
    const auto add = [&](const char* name, const char* law, Scene scene, double darkest) {
        cases.push_back({"probes", name, law, [scene = std::move(scene), darkest](Trial& t) {
                             any_grid(t, scene, darkest);
                         }});
    };
    add("a single probe", full, with_grid({.1f, 0.f, .2f}, 1.f, {1, 1, 1}), all_light);
    add("a grid of 2 x 1 x 2", full, with_grid({-.5f, 0.f, -.5f}, 1.f, {2, 1, 2}), all_light);
    add("a grid of 1000 x 1 x 1", full, with_grid({-.999f, .1f, .1f}, .002f, {1000, 1, 1}),
        all_light);
    add("probes exactly on the walls", bounded, with_grid(glm::vec3(-1.f), 1.f, {3, 3, 3}),
        own_glow);
    add("probes 1e-6 off the walls", full, with_grid(glm::vec3(-1.f + 1e-6f), .6666660f, {4, 4, 4}),
        all_light);
    add("all probes outside the scene", bounded, with_grid(glm::vec3(5.f), 1.f, {3, 3, 3}),
        own_glow);
    add("grid far larger than the scene", bounded, with_grid(glm::vec3(-8.f), 4.f, {5, 5, 5}),
        own_glow);
    add("scene far larger than the grid", full, with_grid(glm::vec3(-.05f), .05f, {3, 3, 3}),
        all_light);
    Scene inside = with_grid(glm::vec3(-.1f), .1f, {3, 3, 3});
    add_object(inside, "block", Box{glm::vec3(-.2f), glm::vec3(.2f), {0, 0, 0, 0, 0, 0}});
    add("all probes inside a block", bounded, inside, own_glow);
    Scene some = with_grid(glm::vec3(-.9f), .6f, {4, 4, 4});
    add_object(some, "block", Box{{.1f, -1.f, .1f}, {.8f, .4f, .8f}, {0, 0, 0, 0, 0, 0}});
    add("some probes inside a block", bounded, some, own_glow);
    Scene touching = with_grid(glm::vec3(-.9f), .6f, {4, 4, 4});
    add_object(touching, "block", Box{{-.3f, -1.f, -.3f}, {.3f, .3f, .3f}, {0, 0, 0, 0, 0, 0}});
    add("probes on the corners of a block", bounded, touching, own_glow);
}

}  // namespace plumbline::reports
