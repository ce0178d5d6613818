// SPDX-License-Identifier: Apache-2.0
// Loops over lanes, in whatever vector registers the processor has, against the functions that they
// are made of, compiled for any processor and called one path at a time: the same bits.
#include "pathtracer/lane_steps.h"

#include <catch2/catch.hpp>
#include <cstring>
#include <memory>
#include <numbers>
#include <random>

#include "pathtracer/hemisphere.h"

namespace plumbline::pathtracer {
namespace {

struct Inputs {
    std::mt19937 random{23};
    std::normal_distribution<float> normal;
    float number() { return normal(random); }
    float unit() { return std::uniform_real_distribution<float>()(random); }
    glm::vec3 vector() { return {number(), number(), number()}; }
    glm::vec3 color() { return {unit(), unit(), unit()}; }
};

/// Paths at surfaces, one a lane; some throughputs are 0.
struct Stage {
    HitLanes hits;
    WalkLanes walks;

    explicit Stage(std::size_t count) {
        Inputs inputs;
        hits.count = walks.rays.count = count;
        for (std::size_t i = 0; i < count; ++i) {
            hits.position.set(i, 100.f * inputs.vector());
            hits.position_error[i] = 1e-4f * inputs.unit();
            hits.n.set(i, i % 5 == 0 ? glm::vec3(0.f, 0.f, -1.f) : glm::normalize(inputs.vector()));
            hits.albedo.set(i, inputs.color());
            walks.beta.set(i, i % 7 == 0 ? glm::vec3(0.f) : inputs.color());
            walks.sampler.set(i, Sampler(pixel_key(1, int(i), 2), int(i)));
        }
    }
};

bool same(const glm::vec3& a, const glm::vec3& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

bool same(const Sampler& a, const Sampler& b) {
    return std::memcmp(&a.state(), &b.state(), sizeof(Sampler::State)) == 0;
}

/// Not a multiple of any vector's width, so that the loops' ends count too.
constexpr std::size_t count = lane_count - 3;

}  // namespace

TEST_CASE("camera rays side by side are those of one path at a time", "[pathtracer][lanes]") {
    const auto stage = std::make_unique<Stage>(count);
    WalkLanes& walks = stage->walks;
    const CameraRays camera({.eye = {1.f, 2.f, 3.f}, .target = {-.5f, .2f, 7.f}});
    const SamplerLanes before = walks.sampler;
    aim_camera(camera, {31.f, 17.f}, walks.sampler, walks.rays);
    std::size_t same_rays = 0;
    for (std::size_t i = 0; i < count; ++i) {
        Sampler sampler = before[i];
        const glm::vec2 at = glm::vec2(31.f, 17.f) + sampler.next_2d();
        const Ray ray = camera.through(at.x, at.y);
        same_rays += same(walks.rays[i].origin, ray.origin) &&
                     same(walks.rays[i].direction, ray.direction) &&
                     same(walks.sampler[i], sampler);
    }
    CHECK(same_rays == count);
}

TEST_CASE("light side by side is that of one path at a time", "[pathtracer][lanes]") {
    const auto stage = std::make_unique<Stage>(count);
    PointLight light;
    light.position = {3.f, -20.f, 11.f};
    light.intensity = {5.f, 6.f, 7.f};
    light.white_radiance = {.5f, .25f, .125f};
    light.falloff = GENERATE(Falloff::InverseSquare, Falloff::None);
    Lanes3 L;
    shine(EvenLight(light), stage->hits, stage->walks.beta, L);
    std::size_t same_light = 0, lit = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Spectrum f_beta =
            stage->walks.beta[i] * stage->hits.albedo[i] * std::numbers::inv_pi_v<float>;
        const SampledLight sample =
            sample_point_light(light, stage->hits.position[i], stage->hits.n[i]);
        same_light += same(L[i], f_beta * sample.E);
        lit += L[i] != Spectrum(0.f);
    }
    CHECK(same_light == count);
    CHECK(lit > count / 4);
    CHECK(lit < count);
}

TEST_CASE("scattering side by side is that of one path at a time", "[pathtracer][lanes]") {
    const auto stage = std::make_unique<Stage>(count);
    const HitLanes& hits = stage->hits;
    WalkLanes& walks = stage->walks;
    const auto before = std::make_unique<WalkLanes>(walks);
    const PathOptions options;
    Lanes<std::int32_t> alive;
    start_rays(hits, walks.rays.origin);
    scatter(hits, walks);
    find_alive(count, walks, alive);
    play_roulette(options, count, walks, alive);
    std::size_t same_paths = 0, living = 0;
    for (std::size_t i = 0; i < count; ++i) {
        Sampler sampler = before->sampler[i];
        const glm::vec3 n = hits.n[i];
        const glm::vec3 wi = sample_cosine_hemisphere(sampler.next_2d(), n);
        const Spectrum beta = before->beta[i] * hits.albedo[i];
        const float survival = glm::min(.95f, max_component(beta) / options.sure_throughput);
        const bool lives = max_component(beta) != 0.f && sampler.next_1d() < survival;
        if (max_component(beta) == 0.f) sampler.next_1d();
        same_paths += same(walks.rays.direction[i], wi) && same(walks.sampler[i], sampler) &&
                      same(walks.rays.origin[i],
                           offset_origin(hits.position[i], hits.position_error[i], n)) &&
                      (alive[i] != 0) == lives && (!lives || same(walks.beta[i], beta / survival));
        living += alive[i] != 0;
    }
    CHECK(same_paths == count);
    CHECK(living > count / 4);
    CHECK(living < count);
}

}  // namespace plumbline::pathtracer
