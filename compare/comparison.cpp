// SPDX-License-Identifier: Apache-2.0
#include "compare/comparison.h"

#include "compare/ssim.h"

namespace plumbline::compare {

namespace {

/// Integer files hold what a display shows; read_image says which it decoded.
bool was_integer(const Image& image) { return image.metadata.contains("plumbline:decoded"); }

void measure_channels(const LayerPair& pair, Comparison& comparison) {
    const auto sums = channel_errors(pair);
    const bool single = pair.names[0] == pair.names[1];
    for (std::size_t c = 0; c < (single ? 1 : 3); ++c) {
        comparison.channels.push_back(pair.names[c]);
        comparison.channel_metrics.push_back(sums[c].metrics());
    }
}

}  // namespace

Comparison compare_images(const Image& reference, const Image& test, const std::string& layer,
                          const ComparisonOptions& options) {
    const LayerPair pair = pair_layers(reference, test, layer, options.mask);
    const FlipOptions& flip = options.flip;
    Comparison comparison;
    comparison.layer = layer;
    comparison.metrics = pixel_metrics(pair);
    comparison.metrics.ssim = ssim(pair);
    comparison.pixels_per_degree = flip.pixels_per_degree;
    comparison.tone_mapper = flip.tone_mapper;
    if (was_integer(reference) && was_integer(test)) {
        comparison.flip_variant = FlipVariant::Ldr;
        comparison.flip = ldr_flip(pair, flip);
    } else {
        comparison.flip = hdr_flip(pair, flip);
    }
    if (comparison.flip) comparison.metrics.flip = comparison.flip->mean;
    measure_channels(pair, comparison);
    comparison.objects = errors_by_object(
        reference, test, pair, comparison.flip ? comparison.flip->map : std::vector<float>());
    comparison.percentiles = error_percentiles(pair);
    if (options.halves.any()) {
        HalvesSplit halves = split_by_halves(reference, test, options.halves, pair);
        comparison.noise = halves.split;
        comparison.halves_variance = std::move(halves.variance);
    } else {
        comparison.noise = split_noise(reference, test, pair);
        if (!comparison.noise)
            comparison.noise_unknown = "no variance layer in either image, and no --half";
    }
    comparison.scales = error_by_scale(pair);
    comparison.non_finite = pair.non_finite;
    comparison.first_non_finite = pair.first_non_finite;
    comparison.pixels = pair.pixels();
    comparison.counted_pixels = pair.usable_pixels;
    return comparison;
}

}  // namespace plumbline::compare
