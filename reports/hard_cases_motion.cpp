// SPDX-License-Identifier: Apache-2.0
// Motion: whatever moves, and however, the cache shows what placing every surfel afresh shows.
#include "reports/hard_case.h"
#include "reports/hard_scenes.h"

namespace plumbline::reports {
namespace {

constexpr int frames = 8;

/// A block whose place is given at each frame, in a lit room.
Object moving(const char* name, std::vector<glm::vec3> places) {
    Object block;
    block.name = name;
    block.shape = Box{glm::vec3(-.2f), glm::vec3(.2f), {0, 0, 0, 0, 0, 0}};
    block.animation.translation.interpolation = Interpolation::Step;
    for (std::size_t i = 0; i < places.size(); ++i) {
        block.animation.translation.frames.push_back(float(i));
    }
    block.animation.translation.values = std::move(places);
    return block;
}

Scene room_with(std::vector<Object> blocks) {
    Scene scene = lit_room();
    scene.objects.pop_back();  // the resting block
    for (Object& block : blocks) scene.objects.push_back(std::move(block));
    scene.frames = frames;
    return scene;
}

void same_as_afresh(Trial& trial, const Scene& scene) {
    for (const std::string& model : ddgi::model_names()) {
        for (const int frame : {3, frames - 1}) {
            ddgi::DdgiOptions options;
            options.updates = 1;
            const Image cached = trial.probes(scene, model, frame, options).image;
            options.cache = false;
            trial.claim(model, "same bytes without the cache at frame " + std::to_string(frame),
                        same_pixels(cached, trial.probes(scene, model, frame, options).image));
        }
    }
    trial.truth(scene, frames - 1, {.spp = 4});
}

/// From here to there by equal steps, over all frames.
std::vector<glm::vec3> steps(const glm::vec3& from, const glm::vec3& to) {
    std::vector<glm::vec3> places;
    for (int i = 0; i < frames; ++i) places.push_back(glm::mix(from, to, float(i) / (frames - 1)));
    return places;
}

Object vanishing() {
    Object block = moving("vanishing", {{.2f, -.3f, .1f}});
    block.animation.scale = {
        Interpolation::Linear, {0.f, 3.f, 7.f}, {glm::vec3(1.f), glm::vec3(0.f), glm::vec3(1.2f)}};
    return block;
}

Object turning() {
    Object block = moving("turning", {{.1f, -.2f, 0.f}});
    const glm::vec3 axis = glm::normalize(glm::vec3(1.f, 1.f, 0.f));
    block.animation.rotation = {
        Interpolation::Linear, {0.f, 7.f}, {glm::angleAxis(0.f, axis), glm::angleAxis(2.f, axis)}};
    return block;
}

}  // namespace

void add_motion_cases(std::vector<HardCase>& cases) {
    const auto add = [&](const char* name, std::vector<Object> blocks) {
        cases.push_back(
            {"motion", name, "same bytes as placing every surfel afresh each frame",
             [scene = room_with(std::move(blocks))](Trial& t) { same_as_afresh(t, scene); }});
    };
    const glm::vec3 here(-.4f, -.5f, .1f), there(.4f, .2f, -.2f), outside(3.f, 0.f, 0.f);
    add("a block passes through probes",
        {moving("passing", steps({-.9f, -.3f, -.3f}, {.9f, -.3f, -.3f}))});
    add("a block leaves the grid", {moving("leaving", steps(there, outside))});
    add("a block comes in from outside", {moving("coming", steps(outside, here))});
    add("a block stands still for a frame",
        {moving("pausing", {here, here * .8f, here * .6f, here * .6f, here * .4f, here * .2f})});
    add("a block teleports",
        {moving("teleporting", {here, here, there, there, here, outside, there})});
    add("a block is scaled to zero and back", {vanishing()});
    add("a block turns in place", {turning()});
    add("two blocks swap places", {moving("one", {here, here, there, there, here, there}),
                                   moving("other", {there, there, here, here, there, here})});
    add("two blocks in one place",
        {moving("one", steps(here, there)), moving("other", steps(here, there))});
}

}  // namespace plumbline::reports
