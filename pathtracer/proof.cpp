// SPDX-License-Identifier: Apache-2.0
#include "pathtracer/proof.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "pathtracer/cone.h"
#include "pathtracer/kernels.h"
#include "pathtracer/light_choice.h"
#include "pathtracer/passes.h"
#include "pathtracer/simple_scenes.h"
#include "pathtracer/statistics.h"

namespace plumbline::pathtracer {
namespace {

using std::numbers::pi;

template <Effects F>
PixelEstimate estimate_along(const RayTracer& tracer, const Ray& ray, int batches,
                             const PathOptions& options) {
    Wave<F, RayTracer> wave(tracer, options);
    PixelEstimate estimate;
    for (int batch = 0; batch < batches; ++batch) {
        for (int i = 0; i < Sampler::batch_size; ++i) {
            wave.start(ray, Sampler(pixel_key(0, 0, 0), batch * Sampler::batch_size + i));
        }
        SampleSums group;
        for (const Path& path : wave.follow()) group.add(path, ray.origin, ray.direction);
        estimate.add_group(group);
    }
    return estimate;
}

/// Calls f.template operator()<F>() for each kernel that covers `effects`, the smallest first.
template <std::size_t kernel = 0, typename Function>
void for_each_kernel(Effects effects, const Function& f) {
    if constexpr (kernel < kernels.size()) {
        if (covers(kernels[kernel], effects)) f.template operator()<kernels[kernel]>();
        for_each_kernel<kernel + 1>(effects, f);
    }
}

/// A room with a lamp and a glowing ball, clear of all corners: where an emitter touches a surface,
/// aiming alone has no finite variance, and no deviation could be judged.
Scene room_with_ball(int width, int height) {
    Scene scene = mixed_room(width, height);
    for (Material& material : scene.materials) material.emission = Spectrum(0.f);
    const int glowing = add_material(scene, Spectrum(0.f), {3.f, 2.f, 1.f});
    add_object(scene, Sphere{{-.5f, .45f, .2f}, .2f, false, glowing});
    return scene;
}

/// Its pixels, with one thing about their paths changed.
std::vector<PixelEstimate> pixels_of(std::uint64_t seed,
                                     const std::function<void(PathOptions&)>& change) {
    constexpr int width = 24, height = 18, samples = 64 * Sampler::batch_size;
    const World world = world_at(room_with_ball(width, height), 0);
    const RayTracer tracer(world);
    PathOptions options;
    change(options);
    Passes passes(tracer,
                  Effects{} | Effect::PointLights | Effect::Emission | Effect::EmitterSampling,
                  options, seed);
    Progress progress("", passes.steps(samples));
    passes.add({samples, Sampler::batch_size}, progress);
    return passes.pixels();
}

Finding agreement(const std::string& name, const std::vector<PixelEstimate>& a,
                  const std::vector<PixelEstimate>& b) {
    double largest = 0.;
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const double difference = a[i].sums.radiance()[c] / a[i].sums.samples -
                                      b[i].sums.radiance()[c] / b[i].sums.samples;
            const double variance = a[i].radiance_variance()[c] + b[i].radiance_variance()[c];
            const double z = difference / std::sqrt(variance);
            if (difference != 0. && !(std::abs(z) <= std::abs(largest))) largest = z;
        }
    }
    return {name, "the worst of 24 x 18 pixels and 3 channels", largest,
            sidak_limit(static_cast<int>(3 * a.size()))};
}

/// How unevenly draw(i) falls into 16 x 16 cells of the unit square that it should fill evenly.
Finding evenness(const std::string& name, const std::function<glm::dvec2(int)>& draw) {
    constexpr int cells = 16, draws = 256 * 400;
    std::vector<double> observed(cells * cells, 0.);
    for (int i = 0; i < draws; ++i) {
        const glm::ivec2 cell = glm::clamp(glm::ivec2(draw(i) * double(cells)), 0, cells - 1);
        observed[std::size_t(cell.y) * cells + std::size_t(cell.x)] += 1.;
    }
    const std::vector<double> expected(observed.size(), double(draws) / (cells * cells));
    return {name, "chi-square of 16 x 16 cells", chi_square_z(observed, expected), sidak_limit(4)};
}

/// The pair `pair` of dimensions of the first sample of pixel i: independent of other pixels'.
glm::vec2 point(int pair, int i) {
    Sampler sampler(pixel_key(17, i, pair), i % Sampler::batch_size);
    glm::vec2 u(0.f);
    for (int drawn = 0; drawn <= pair; ++drawn) u = sampler.next_2d();
    return u;
}

/// The share of a full turn that `wi` lies about `axis`, and nothing else of it.
double turn_about(const glm::dvec3& axis, const glm::dvec3& wi) {
    const glm::dvec3 u = glm::normalize(glm::cross(axis, glm::dvec3(.3, -.5, .7)));
    return std::atan2(glm::dot(wi, glm::cross(axis, u)), glm::dot(wi, u)) / (2. * pi) + .5;
}

}  // namespace

Measured measure(const ClosedForm& form, int batches) {
    const World world = world_at(form.scene, 0);
    const RayTracer tracer(world);
    const Effects effects = effects_of(form.scene);
    PathOptions options;
    if (form.max_bounces) {
        options.max_scatterings = *form.max_bounces + 1;
        options.roulette = false;
    }
    const Emitters emitters(world);
    if (has(effects, Effect::EmitterSampling)) options.emitters = &emitters;
    const LightChoice lights(world);
    if (has(effects, Effect::LightChoice)) options.lights = &lights;
    Measured measured;
    for_each_kernel(effects, [&]<Effects F>() {
        const PixelEstimate estimate = estimate_along<F>(tracer, form.ray, batches, options);
        const double radiance = estimate.sums.radiance().x / estimate.sums.samples;
        if (measured.kernels++ > 0) {
            measured.same_bits = measured.same_bits && radiance == measured.radiance;
            return;
        }
        measured.radiance = radiance;
        measured.standard_error = std::sqrt(estimate.radiance_variance().x);
    });
    // What floats leave of a value that every sample finds alike.
    const double rounding = 1e-5 * form.expected;
    const double difference = measured.radiance - form.expected;
    const double beyond = std::max(std::abs(difference) - rounding, 0.);
    measured.z = beyond > 0. ? std::copysign(beyond / measured.standard_error, difference) : 0.;
    return measured;
}

std::vector<Finding> agreements() {
    const auto both = pixels_of(1, [](PathOptions&) {});
    const auto aiming =
        pixels_of(2, [](PathOptions& path) { path.techniques = Techniques::AimingOnly; });
    const auto meeting =
        pixels_of(3, [](PathOptions& path) { path.techniques = Techniques::MeetingOnly; });
    const auto all = pixels_of(4, [](PathOptions& path) {
        path.roulette = false;
        path.max_scatterings = 60;  // what is left after them is below .8^60 of the light
    });
    const auto again = pixels_of(5, [](PathOptions&) {});
    return {agreement("multiple importance sampling and aiming alone", both, aiming),
            agreement("multiple importance sampling and meeting alone", both, meeting),
            agreement("Russian roulette and paths of 60 scatterings", both, all),
            agreement("one seed and another", both, again)};
}

std::vector<Finding> distributions() {
    const glm::vec3 n = glm::normalize(glm::vec3(1.f, -2.f, .5f));
    const SphereCone cone = sphere_cone(3.f * n, 2.f);
    return {evenness("sampler, first pair of dimensions", [](int i) { return point(0, i); }),
            evenness("sampler, one dimension of two pairs each",
                     [](int i) {
                         Sampler sampler(pixel_key(18, i, 0), i % Sampler::batch_size);
                         const float x = sampler.next_2d().y;
                         return glm::dvec2(x, sampler.next_2d().x);
                     }),
            evenness("directions by the cosine",
                     [&](int i) {
                         const glm::dvec3 wi(sample_cosine_hemisphere(point(1, i), n));
                         const double cosine = glm::dot(wi, glm::dvec3(n));
                         return glm::dvec2(cosine * cosine, turn_about(glm::dvec3(n), wi));
                     }),
            evenness("directions to a ball of light", [&](int i) {
                const glm::dvec3 wi(sample_cone(cone, point(2, i)));
                const double depth = 1. - glm::dot(wi, glm::dvec3(cone.axis));
                return glm::dvec2(depth / double(cone.one_minus_cos),
                                  turn_about(glm::dvec3(cone.axis), wi));
            })};
}

}  // namespace plumbline::pathtracer
