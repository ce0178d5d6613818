// SPDX-License-Identifier: Apache-2.0
#include "reports/truth.h"

#include <catch2/catch.hpp>

#include "compare/comparison.h"
#include "pathtracer/render.h"
#include "scenes/errors.h"
#include "scenes/scene_files.h"
#include "tests/scenes/temporary_folder.h"

using namespace plumbline;

namespace {

Image traced(Scene scene, int frame, int spp, std::uint64_t seed) {
    scene.camera.width = 48;
    scene.camera.height = 27;
    pathtracer::RenderOptions options;
    options.spp = spp;
    options.seed = seed;
    return pathtracer::render(scene, frame, options).image;
}

}  // namespace

TEST_CASE("a truth is of its scene and frame, or from another program", "[reports]") {
    Scene scene = load_scene("room-with-door");
    const TemporaryFolder folder;
    const std::string file = (folder / "t.exr").string();
    Image picture = traced(scene, 350, 4, 0);
    write_exr(file, picture);
    const CommonOptions options;
    CHECK(reports::truth_of(scene, 350, {file, 0., 0}, options).width() == 48);
    CHECK(scene.camera.height == 27);
    CHECK_THROWS_WITH(reports::truth_of(scene, 0, {file, 0., 0}, options),
                      Catch::Contains("shows frame '350'; give a picture of frame '0'"));
    Scene other = load_scene("cornell-box");
    CHECK_THROWS_WITH(
        reports::truth_of(other, 350, {file, 0., 0}, options),
        Catch::Contains("shows scene 'room-with-door'; give a picture of scene 'cornell-box'"));
    CommonOptions sized;
    sized.width = sized.height = 64;
    CHECK_THROWS_WITH(
        reports::truth_of(scene, 350, {file, 0., 0}, sized),
        Catch::Contains("--size: is 64x64, but ") && Catch::Contains(" has 48x27 pixels"));
    picture.metadata.clear();
    write_exr(file, picture);
    CHECK(reports::truth_of(other, 0, {file, 0., 0}, options).width() == 48);
}

TEST_CASE("noise of path-traced pictures passes for no bias, whatever their seeds and samples",
          "[reports][statistics]") {
    const Scene scene = load_scene("cornell-box");
    const Image reference = traced(scene, 0, 128, 0);
    // The first half of the reference's samples, or others.
    for (const std::uint64_t seed : {0u, 5u}) {
        const auto noise =
            compare::compare_images(reference, traced(scene, 0, 64, seed), "indirect").noise;
        REQUIRE(noise);
        CHECK(noise->shared_samples == (seed == 0));
        // Of four batches' variances, in pixels of which fireflies hold most: twice the interval.
        CHECK(std::abs(noise->bias_mse) < 2 * (noise->bias_mse_ci95[1] - noise->bias_mse));
        CHECK(noise->z_fraction_above_3 > 0.);
    }
    // Variances of 16 samples are too large by half or more: MSE less noise is far below 0.
    const auto few =
        compare::compare_images(traced(scene, 0, 16, 21), traced(scene, 0, 16, 22), "indirect");
    REQUIRE(few.noise);
    CHECK(few.noise->bias_mse < 0.);
    CHECK(few.noise->bias_mse_ci95[0] < 0.);
    CHECK(few.noise->bias_mse_ci95[1] > 0.);
}
