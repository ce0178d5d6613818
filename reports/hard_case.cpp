// SPDX-License-Identifier: Apache-2.0
#include "reports/hard_case.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>

#include "reports/layer_statistics.h"

namespace plumbline::reports {

pathtracer::RenderResult Trial::truth(const Scene& scene, int frame,
                                      const pathtracer::RenderOptions& options) {
    pathtracer::RenderResult result = pathtracer::render(scene, frame, options);
    all_finite(pathtracer, result.image);
    return result;
}

ddgi::DdgiResult Trial::probes(const Scene& scene, const std::string& model, int frame,
                               ddgi::DdgiOptions options) {
    options.model = model;
    ddgi::DdgiResult result = ddgi::render(scene, frame, options);
    all_finite(model, result.image);
    return result;
}

void Trial::near(const std::string& renderer, const std::string& claim, double measured,
                 double expected, double tolerance) {
    within(renderer, claim, measured, expected - tolerance, expected + tolerance);
}

void Trial::within(const std::string& renderer, const std::string& claim, double measured,
                   double lowest, double highest) {
    findings_.push_back({renderer, claim, measured, lowest, highest});
}

void Trial::claim(const std::string& renderer, const std::string& what, bool holds) {
    within(renderer, what, holds ? 1. : 0., 1., 1.);
}

void Trial::all_finite(const std::string& renderer, const Image& image) {
    double bad = 0.;
    for (const std::span<const float> channel : image.layer("")) {
        bad += double(std::ranges::count_if(
            channel, [](float value) { return !std::isfinite(value) || value < 0.f; }));
    }
    within(renderer, "values that are negative or not finite", bad, 0., 0.);
}

std::vector<HardCase> hard_cases() {
    std::vector<HardCase> cases;
    add_scale_cases(cases);
    add_light_cases(cases);
    add_geometry_cases(cases);
    add_energy_cases(cases);
    add_probe_cases(cases);
    add_motion_cases(cases);
    add_statistics_cases(cases);
    return cases;
}

double mean_radiance(const Image& image) { return layer_mean(image, ""); }

double mean_error(const Image& image) {
    // Channels of a pixel share its paths: their errors add up, those of pixels only in square.
    double sum = 0.;
    const auto variance = image.layer("variance");
    for (std::size_t i = 0; i < image.pixels(); ++i) {
        double deviation = 0.;
        for (const std::span<const float> channel : variance) {
            deviation += std::sqrt(double(channel[i])) / 3.;
        }
        sum += deviation * deviation;
    }
    return std::sqrt(sum) / double(image.pixels());
}

double largest_deviation(const Image& image, double expected) {
    double largest = 0.;
    for (const std::span<const float> channel : image.layer("")) {
        for (const float value : channel) {
            const double deviation = std::abs(double(value) - expected);
            if (!(deviation <= largest)) largest = deviation;  // keeps a NaN
        }
    }
    return largest;
}

bool same_pixels(const Image& a, const Image& b) {
    if (a.channel_names() != b.channel_names()) return false;
    return std::ranges::all_of(a.channel_names(), [&](const std::string& name) {
        const std::span<const float> x = a.channel(name);
        const std::span<const float> y = b.channel(name);
        return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size_bytes()) == 0;
    });
}

}  // namespace plumbline::reports
