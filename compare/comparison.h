// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "compare/flip.h"
#include "compare/halves.h"
#include "compare/metrics.h"
#include "compare/noise.h"
#include "compare/parts.h"
#include "compare/scales.h"
#include "scenes/image.h"

namespace plumbline::compare {

/// Which FLIP a comparison used, and at which exposures.
enum class FlipVariant {
    Ldr,  ///< both files were 8- or 16-bit integers
    Hdr,  ///< at least one is float
};

/// Everything that is known about the difference of one layer of two images.
struct Comparison {
    std::string layer;
    Metrics metrics;
    std::vector<std::string> channels;     ///< names of the reference's: three, or one
    std::vector<Metrics> channel_metrics;  ///< of each, without ssim and flip
    std::vector<ObjectError> objects;
    std::vector<ErrorPercentile> percentiles;
    std::optional<NoiseSplit> noise;                    ///< none if nothing tells the noise
    std::string noise_unknown;                          ///< then the reason, in words
    std::array<std::vector<float>, 3> halves_variance;  ///< see HalvesSplit; empty without halves
    std::vector<ScaleError> scales;
    FlipVariant flip_variant = FlipVariant::Hdr;
    double pixels_per_degree = 0;
    ToneMapper tone_mapper = ToneMapper::Aces;  ///< of HDR-FLIP
    std::optional<FlipResult> flip;             ///< with its map; none as Metrics::flip
    std::size_t non_finite = 0;  ///< values that are not finite in either; their pixels are
                                 ///< left out of everything above
    std::optional<PixelPosition> first_non_finite;
    std::size_t pixels = 0;          ///< of the picture
    std::size_t counted_pixels = 0;  ///< of them, finite and inside the mask
};

/// How two images are compared.
struct ComparisonOptions {
    FlipOptions flip;
    const Image* mask = nullptr;  ///< see pair_layers(); figures are of its inside, maps of all
    Halves halves;                ///< if any, noise comes from them instead of variance layers
};

/// Compares a layer ("" is radiance) of two images of the same size.
/// Throws ImageError if sizes differ, a layer is missing, or no pixel is finite in both.
Comparison compare_images(const Image& reference, const Image& test, const std::string& layer,
                          const ComparisonOptions& options = {});

}  // namespace plumbline::compare
