// SPDX-License-Identifier: Apache-2.0
#include "compare/comparison.h"

#include "compare/ssim.h"

namespace plumbline::compare {

namespace {

/// Integer files hold what a display shows; read_image says which it decoded.
bool was_integer(const Image& image) { return image.metadata.contains("plumbline:decoded"); }

}  // namespace

Comparison compare_images(const Image& reference, const Image& test, const std::string& layer,
                          const FlipOptions& flip) {
    const LayerPair pair = pair_layers(reference, test, layer);
    Comparison comparison;
    comparison.layer = layer;
    comparison.pixels_per_degree = flip.pixels_per_degree;
    comparison.metrics = pixel_metrics(pair);
    comparison.metrics.ssim = ssim(pair);
    if (was_integer(reference) && was_integer(test)) {
        comparison.flip_variant = FlipVariant::Ldr;
        comparison.flip = ldr_flip(pair, flip);
    } else {
        comparison.flip = hdr_flip(pair, flip);
    }
    if (comparison.flip) comparison.metrics.flip = comparison.flip->mean;
    comparison.noise = split_noise(reference, test, pair);
    comparison.scales = error_by_scale(pair);
    comparison.non_finite = pair.non_finite;
    comparison.first_non_finite = pair.first_non_finite;
    comparison.pixels = pair.pixels();
    return comparison;
}

}  // namespace plumbline::compare
