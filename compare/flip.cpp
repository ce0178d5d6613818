// SPDX-License-Identifier: Apache-2.0
#include "compare/flip.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/flip_color.h"
#include "compare/flip_tile.h"
#include "compare/row_sums.h"
#include "scenes/errors.h"

namespace plumbline::compare {

namespace {

/// Tiles are small enough that their planes stay in the cache, and fixed: the result cannot
/// depend on the number of threads.
constexpr int tile_width = 256;
constexpr int tile_height = 64;
/// The display value to which the start and stop exposure bring the brightest and the median
/// luminance [Andersson et al. 2021, section 3.2].
constexpr double exposed_value = 0.85;

std::vector<Tile> tiles_of(const LayerPair& pair) {
    std::vector<Tile> tiles;
    for (int y = 0; y < pair.height; y += tile_height)
        for (int x = 0; x < pair.width; x += tile_width)
            tiles.push_back({x, y, std::min(tile_width, pair.width - x),
                             std::min(tile_height, pair.height - y)});
    return tiles;
}

FlipResult largest_flip(const LayerPair& pair, const std::vector<Display>& displays,
                        const FlipOptions& options) {
    const FlipFilters filters = make_flip_filters(options.pixels_per_degree);
    const std::vector<Tile> tiles = tiles_of(pair);
    FlipResult result;
    result.map.assign(pair.pixels(), 0.f);
    tbb::parallel_for(std::size_t(0), tiles.size(), [&](std::size_t k) {
        const Tile& tile = tiles[k];
        std::vector<float> error(std::size_t(tile.width) * std::size_t(tile.height), 0.f);
        for (const Display& display : displays) raise_to_flip(pair, display, filters, tile, error);
        for (int y = 0; y < tile.height; ++y) {
            const auto from = error.begin() + std::ptrdiff_t(y) * tile.width;
            std::copy_n(from, tile.width,
                        result.map.begin() + std::ptrdiff_t(tile.y + y) * pair.width + tile.x);
        }
    });
    const auto sum = sum_over_rows<1>(pair.height, [&](int y) {
        std::array<double, 1> row{};
        const std::size_t begin = std::size_t(y) * std::size_t(pair.width);
        for (std::size_t i = begin; i < begin + std::size_t(pair.width); ++i) {
            if (!pair.finite[i]) result.map[i] = 0.f;
            if (pair.usable[i]) row[0] += double(result.map[i]);
        }
        return row;
    });
    result.mean = sum[0] / double(pair.usable_pixels);
    result.exposures = int(displays.size());
    return result;
}

/// The mean of the two middle values, as the authors take it: of an odd number, the middle one
/// and the one below.
float median_of(std::vector<float>& values) {
    if (values.size() == 1) return values[0];
    const auto upper = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), upper, values.end());
    return 0.5f * (*upper + *std::max_element(values.begin(), upper));
}

/// The brightest and the median luminance of the reference.
struct LuminanceRange {
    float largest = 0.f;
    float median = 0.f;
};

LuminanceRange luminance_range(const LayerPair& pair) {
    std::vector<float> luminances;
    luminances.reserve(pair.pixels());
    const auto& [r, g, b] = pair.reference;
    for (std::size_t i = 0; i < pair.pixels(); ++i)
        if (pair.finite[i]) luminances.push_back(glm::dot(luminance_weights, {r[i], g[i], b[i]}));
    LuminanceRange range;
    range.largest = *std::max_element(luminances.begin(), luminances.end());
    if (range.largest <= 0.f) return range;
    range.median = median_of(luminances);
    if (range.median > 0.f) return range;
    std::erase_if(luminances, [](float luminance) { return luminance <= 0.f; });
    range.median = median_of(luminances);
    return range;
}

}  // namespace

FlipResult ldr_flip(const LayerPair& pair, const FlipOptions& options) {
    return largest_flip(pair, {Display{}}, options);
}

std::optional<FlipResult> hdr_flip(const LayerPair& pair, const FlipOptions& options) {
    const LuminanceRange range = luminance_range(pair);
    if (range.largest <= 0.f) return std::nullopt;
    const ToneCurve& curve = tone_curve(options.tone_mapper);
    const double exposed = curve.inverse(exposed_value);
    const double start =
        options.start_exposure.value_or(std::log2(exposed / double(range.largest)));
    const double stop = options.stop_exposure.value_or(std::log2(exposed / double(range.median)));
    if (!(start <= stop) || !std::isfinite(start) || !std::isfinite(stop))
        throw UsageError("--start-exposure, --stop-exposure",
                         fmt::format("no exposure lies from {:.4g} to {:.4g} stops", start, stop),
                         "start below the stop");
    const int count = std::max(2, int(std::ceil(stop - start)));
    std::vector<Display> displays;
    for (int i = 0; i < count; ++i)
        displays.push_back({&curve, float(std::exp2(start + (stop - start) * i / (count - 1)))});
    FlipResult result = largest_flip(pair, displays, options);
    result.start_exposure = start;
    result.stop_exposure = stop;
    return result;
}

}  // namespace plumbline::compare
