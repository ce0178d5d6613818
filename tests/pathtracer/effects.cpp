// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "pathtracer/kernels.h"
#include "scenes/camera_rays.h"
#include "scenes/scene_files.h"
#include "tests/pathtracer/scenes.h"

namespace plumbline::pathtracer {
namespace {

constexpr int width = 12, height = 8, spp = 8;

/// The radiance of every sample of a small picture, by the kernel for F.
template <Effects F>
std::vector<Spectrum> samples_of(const RayTracer& tracer, const PathOptions& options,
                                 std::uint64_t seed = 0) {
    Wave<F, RayTracer> wave(tracer, options);
    const CameraRays camera_rays(tracer.world().camera);
    for (int i = 0; i < width * height * spp; ++i) {
        const int x = i / spp % width;
        const int y = i / spp / width;
        Sampler sampler(pixel_key(seed, x, y), i % spp);
        const glm::vec2 at = glm::vec2(x, y) + sampler.next_2d();
        wave.start(camera_rays.through(at.x, at.y), sampler);
    }
    std::vector<Spectrum> samples;
    for (const Path& path : wave.follow()) samples.push_back(path.direct + path.indirect);
    return samples;
}

}  // namespace

TEST_CASE("an effect that a built-in scene does not call for changes no bit of its picture",
          "[pathtracer]") {
    for (const std::string& name : builtin_scene_names()) {
        INFO(name);
        Scene scene = load_scene(name);
        scene.camera.width = width;
        scene.camera.height = height;
        const World world = world_at(scene, scene.report_frame);
        const RayTracer tracer(world);
        const Emitters emitters(world);
        const Effects effects = effects_of(scene);
        PathOptions options;
        if (has(effects, Effect::EmitterSampling)) options.emitters = &emitters;
        std::vector<Spectrum> special;
        with_effects(effects, [&]<Effects F>() {
            CHECK(F != test::all_effects);
            special = samples_of<F>(tracer, options);
        });
        CHECK(special == samples_of<test::all_effects>(tracer, options));
        CHECK(std::any_of(special.begin(), special.end(),
                          [](const Spectrum& L) { return L != Spectrum(0.f); }));
    }
}

TEST_CASE("the environment of a closed scene changes no bit of its picture", "[pathtracer]") {
    Scene scene = GENERATE(load_scene("furnace"), load_scene("integrating-sphere"),
                           test::mixed_room(width, height));
    INFO(scene.name);
    scene.environment = {3.f, 4.f, 5.f};
    scene.camera.width = width;
    scene.camera.height = height;
    const Effects effects = effects_of(scene);
    CHECK_FALSE(has(effects, Effect::Environment));
    const World world = world_at(scene, 0);
    REQUIRE(world.environment != Spectrum(0.f));
    const RayTracer tracer(world);
    with_effects(effects, [&]<Effects F>() {
        CHECK_FALSE(has(F, Effect::Environment));
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            CHECK(samples_of<F>(tracer, {}, seed) ==
                  samples_of<F | Effect::Environment>(tracer, {}, seed));
        }
    });
    // With a wall less the environment counts again.
    if (scene.objects.size() < 6) return;
    scene.objects.erase(scene.objects.begin() + 1);
    CHECK(has(effects_of(scene), Effect::Environment));
}

}  // namespace plumbline::pathtracer
