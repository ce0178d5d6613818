// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include "compare/comparison.h"
#include "pathtracer/render.h"
#include "reports/frontier_points.h"
#include "reports/layer_statistics.h"

namespace plumbline::reports {

namespace {

const std::string layer = "indirect";

/// Far from the seeds that people give, for a truth of the same seed would share its noise.
constexpr std::uint64_t first_seed = 0x66726f6e74696572;

/// Noise and bias from each two pictures that follow each other, which independent seeds tell apart
/// at any number of samples; the variance layers, which fewer than 32 samples overstate, are not
/// asked. The interval is the mean of the pairs', which share pictures: it errs to the wide side.
void split(FrontierPoint& point, const Image& truth, const std::vector<Image>& pictures,
           double truth_noise) {
    const double pairs = static_cast<double>(pictures.size() - 1);
    for (std::size_t i = 0; i + 1 < pictures.size(); ++i) {
        const compare::LayerPair pair = compare::pair_layers(truth, pictures[i], layer);
        const compare::NoiseSplit found =
            compare::split_by_halves(truth, pictures[i], {nullptr, &pictures[i + 1]}, pair).split;
        point.noise_mse += (found.mse_expected_from_noise - truth_noise * truth_noise) / pairs;
        point.bias_mse += found.bias_mse / pairs;
        for (std::size_t end = 0; end < 2; ++end)
            point.bias_mse_ci95[end] += found.bias_mse_ci95[end] / pairs;
    }
}

}  // namespace

FrontierPoint measure_path_tracer(const Scene& scene, int frame, const Image& truth, int spp,
                                  int repeats) {
    const double truth_noise = layer_noise(truth, layer);
    FrontierPoint point;
    point.method = path_tracer_method;
    point.setting = fmt::format("{} spp", spp);
    point.options = fmt::format("--spp {}", spp);
    std::vector<Image> pictures;
    std::vector<double> seconds, errors;
    for (int repeat = 0; repeat < repeats; ++repeat) {
        pathtracer::RenderOptions options;
        options.spp = spp;
        options.seed = first_seed + static_cast<std::uint64_t>(repeat);
        pathtracer::RenderResult result = pathtracer::render(scene, frame, options);
        const compare::LayerPair pair = compare::pair_layers(truth, result.image, layer);
        const double rmse = compare::pixel_metrics(pair).rmse;
        const double square = rmse * rmse - truth_noise * truth_noise;
        point.mse += rmse * rmse / repeats;
        point.non_finite += pair.non_finite;
        seconds.push_back(result.seconds);
        if (square > 0) errors.push_back(std::sqrt(square));
        pictures.push_back(std::move(result.image));
    }
    split(point, truth, pictures, truth_noise);
    point.seconds = spread_of(seconds);
    point.frame_seconds = point.seconds;
    point.primary_ms = {1e3 * point.seconds.median, 1e3 * point.seconds.least,
                        1e3 * point.seconds.most};
    if (errors.size() == static_cast<std::size_t>(repeats)) point.error = spread_of(errors);
    return point;
}

}  // namespace plumbline::reports
