// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compare/comparison.h"
#include "compare/picture.h"

namespace plumbline::compare {

/// One number a pixel, and how to show it.
struct ErrorMap {
    std::string name;     ///< "signed": also of its PNG
    std::string meaning;  ///< in plain words, with the formula
    int width, height;
    std::vector<float> values;  ///< not finite where a pixel was left out
    ColorMap colors;
    double low, high;  ///< values shown in the first and the last colour
};

/// Every map of a comparison made of these images:
///
/// - absolute: mean over channels of |t - r|
/// - signed: mean over channels of t - r
/// - relative: mean over channels of (t - r) / (|r| + |t| + 0.01), in (-1,1)
/// - flip, if it is defined
/// - z, if noise is known: (t - r) / s of the channel where that is largest
///
/// `limit` is the absolute and signed error shown in the last colour; none: the 99th percentile of
/// the absolute error, rounded up to 1, 2 or 5 times a power of ten. Give one limit for several
/// tests of a reference to make their maps comparable. Larger errors show as the limit.
std::vector<ErrorMap> error_maps(const Image& reference, const Image& test,
                                 const Comparison& comparison,
                                 std::optional<double> limit = std::nullopt);

/// The limit that error_maps() takes by itself.
double error_limit(const LayerPair& pair);

/// The map in false colours, above a scale bar with numbers.
Picture false_color(const ErrorMap& map);

/// Writes each map as NAME.png, and error_maps.exr: the signed and absolute error of each channel
/// as layers `signed` and `absolute`, other maps as channels NAME.Y. Throws ImageError.
void write_error_maps(const std::filesystem::path& folder, const Image& reference,
                      const Image& test, const Comparison& comparison);

}  // namespace plumbline::compare
