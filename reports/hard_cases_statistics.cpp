// SPDX-License-Identifier: Apache-2.0
// Statistics: the ends of the random numbers, fireflies, a million samples a pixel, long sums.
#include <algorithm>
#include <cmath>

#include "pathtracer/estimate.h"
#include "pathtracer/hemisphere.h"
#include "reports/hard_case.h"
#include "reports/hard_scenes.h"

namespace plumbline::reports {
namespace {

/// Directions from random numbers of exactly 0 and just under 1.
void ends_of_the_unit_square(Trial& trial) {
    const float last = std::nextafter(1.f, 0.f);
    double longest = 0.;
    double lowest = 1.;
    for (const float x : {0.f, 0x1p-149f, .5f, last}) {
        for (const float y : {0.f, 0x1p-149f, .25f, last}) {
            for (const glm::vec3& n : {glm::vec3(0, 0, 1), glm::vec3(0, 0, -1), glm::vec3(1, 0, 0),
                                       glm::normalize(glm::vec3(1e-4f, 1e-4f, -1.f))}) {
                const glm::vec3 w = pathtracer::sample_cosine_hemisphere({x, y}, n);
                longest = std::max(longest, std::abs(double(glm::length(w)) - 1.));
                lowest = std::min(lowest, double(glm::dot(w, n)));
            }
        }
    }
    trial.within(Trial::pathtracer, "deviation of a direction's length from 1", longest, 0., 1e-6);
    trial.within(Trial::pathtracer, "lowest cosine with the normal", lowest, 0x1p-13, 1.);
}

/// One sample can bring no more than next-event estimation gives at each of its surfaces.
void largest_sample(Trial& trial) {
    Scene scene = closed_room(Spectrum(.7f));
    PointLight light;
    light.name = "lamp";
    light.position = {.2f, .3f, 0.f};
    light.falloff = Falloff::None;
    light.white_radiance = Spectrum(1.f);
    scene.lights = {light};
    const auto truth = trial.truth(scene, 0, {.spp = 1});
    double largest = 0.;
    for (const std::span<const float> channel : truth.image.layer("")) {
        largest = std::max(largest, double(*std::ranges::max_element(channel)));
    }
    // Throughput is .7^k at scattering k, 1/4 at most where roulette may end the path, and at
    // each surface the lamp adds at most throughput x .7. Roulette keeps throughput at 1/4 as it
    // falls below, with a survival of .7 a scattering: 100 in a row have probability 3e-16.
    const double sure = .7 * (1. - std::pow(.7, 5)) / .3;
    trial.within(Trial::pathtracer, "largest sample", largest, 0., sure + 100. * .7 / 4.);
}

void a_million_samples(Trial& trial) {
    Scene scene = closed_room(Spectrum(.5f), Spectrum(1.f));
    scene.camera.width = scene.camera.height = 1;
    constexpr int spp = 1 << 20;
    const auto truth = trial.truth(scene, 0, {.spp = spp});
    trial.within(Trial::pathtracer, "samples", double(truth.spp), spp, spp);
    trial.near(Trial::pathtracer, "mean radiance", mean_radiance(truth.image), furnace_radiance,
               5. * mean_error(truth.image));
    // Roulette's spread is below 1 a sample: the error of the mean below 2^-10.
    trial.within(Trial::pathtracer, "standard error", mean_error(truth.image), 1e-7, 0x1p-10);
}

/// A sum of 2^30 like samples, by the renderer's own sums and in plain float.
void long_sums(Trial& trial) {
    constexpr int batches = 1 << 26;
    constexpr int batch = 16;
    const float sample = .1f;
    pathtracer::SampleSums sums;
    float plain = 0.f;
    pathtracer::SampleSums group;
    for (int i = 0; i < batch; ++i) {
        pathtracer::Path path;
        path.add(0, Spectrum(sample));
        group.add(path, {}, {0.f, 0.f, 1.f});
    }
    for (int i = 0; i < batches; ++i) {
        sums.direct += group.direct;
        plain += float(batch) * sample;
    }
    const double exact = double(batches) * batch * double(sample);
    // 2^26 roundings of relatively 2^-53 each, all in one direction at the worst.
    trial.near(Trial::pathtracer, "mean of 2^30 samples over the exact one", sums.direct.x / exact,
               1., 0x1p-27);
    trial.within("plain float", "the same, to show the drift", double(plain) / exact, 0., .5);
}

}  // namespace

void add_statistics_cases(std::vector<HardCase>& cases) {
    cases.push_back({"statistics", "random numbers of exactly 0 and just under 1",
                     "unit directions above the surface", ends_of_the_unit_square});
    cases.push_back({"statistics", "the largest single sample",
                     "next-event estimation bounds it: no fireflies", largest_sample});
    cases.push_back({"statistics", "2^20 samples a pixel",
                     "2 within 5 standard errors of 2^-10 or less", a_million_samples});
    cases.push_back({"statistics", "a sum of 2^30 samples",
                     "in double, to 2^-27; plain float stalls", long_sums});
}

}  // namespace plumbline::reports
