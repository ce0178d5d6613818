// SPDX-License-Identifier: Apache-2.0
#include "compare/error_maps.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace plumbline::compare {

namespace {

constexpr double limit_percentile = 0.99;
/// |z| shown in the last colour.
constexpr double z_limit = 5;
constexpr float no_value = std::numeric_limits<float>::quiet_NaN();

using PixelValue = std::function<float(std::size_t)>;

ErrorMap make_map(const LayerPair& pair, std::string name, std::string meaning, ColorMap colors,
                  double low, double high, const PixelValue& value) {
    ErrorMap map{std::move(name),
                 std::move(meaning),
                 pair.width,
                 pair.height,
                 std::vector<float>(pair.pixels(), no_value),
                 colors,
                 low,
                 high};
    tbb::parallel_for(0, pair.height, [&](int y) {
        const std::size_t begin = std::size_t(y) * std::size_t(pair.width);
        for (std::size_t i = begin; i < begin + std::size_t(pair.width); ++i)
            if (pair.finite[i]) map.values[i] = value(i);
    });
    return map;
}

/// The mean over channels of `error(r, t)`.
PixelValue channel_mean(const LayerPair& pair, float (*error)(float, float)) {
    return [&pair, error](std::size_t i) {
        float sum = 0.f;
        for (std::size_t c = 0; c < 3; ++c) sum += error(pair.reference[c][i], pair.test[c][i]);
        return sum / 3.f;
    };
}

float absolute_error(float r, float t) { return std::abs(t - r); }
float signed_error(float r, float t) { return t - r; }
float relative_error(float r, float t) {
    return (t - r) / (std::abs(r) + std::abs(t) + float(smape_epsilon));
}

/// z of the channel where |z| is largest.
PixelValue largest_z(const Image& reference, const Image& test, const Comparison& comparison,
                     const LayerPair& pair) {
    std::vector<std::array<std::span<const float>, 3>> variances;
    const auto& [r, g, b] = comparison.halves_variance;
    if (!r.empty()) variances.push_back({r, g, b});
    for (const Image* image : {&reference, &test})
        if (const auto layer = variances_of(*image, pair.layer); layer && r.empty())
            variances.push_back(*layer);
    return [&pair, variances](std::size_t i) {
        float largest = 0.f;
        for (std::size_t c = 0; c < 3; ++c) {
            const float d = pair.test[c][i] - pair.reference[c][i];
            float variance = 0.f;
            for (const auto& v : variances) variance += v[c][i];
            // Zero over zero would be nothing known; no error is no deviation.
            const float z = d == 0.f ? 0.f : d / std::sqrt(variance);
            if (!(std::abs(z) <= std::abs(largest))) largest = z;
        }
        return largest;
    };
}

/// The next of 1, 2, 5 times a power of ten.
double rounded_up(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (double step : {1.0, 2.0, 5.0})
        if (value <= step * power) return step * power;
    return 10.0 * power;
}

}  // namespace

double error_limit(const LayerPair& pair) {
    const PixelValue absolute = channel_mean(pair, absolute_error);
    std::vector<float> errors;
    errors.reserve(pair.usable_pixels);
    for (std::size_t i = 0; i < pair.pixels(); ++i)
        if (pair.usable[i]) errors.push_back(absolute(i));
    const auto place = std::ptrdiff_t(limit_percentile * double(errors.size() - 1));
    std::nth_element(errors.begin(), errors.begin() + place, errors.end());
    double limit = double(errors[std::size_t(place)]);
    if (limit <= 0) limit = double(*std::max_element(errors.begin(), errors.end()));
    return limit > 0 ? rounded_up(limit) : 1.0;
}

std::vector<ErrorMap> error_maps(const Image& reference, const Image& test,
                                 const Comparison& comparison, std::optional<double> limit) {
    const LayerPair pair = pair_layers(reference, test, comparison.layer);
    const double high = limit.value_or(error_limit(pair));
    std::vector<ErrorMap> maps;
    maps.push_back(make_map(pair, "absolute", "mean over channels of |t - r|", ColorMap::Viridis, 0,
                            high, channel_mean(pair, absolute_error)));
    maps.push_back(make_map(pair, "signed", "mean over channels of t - r; red: too bright",
                            ColorMap::BlueWhiteRed, -high, high, channel_mean(pair, signed_error)));
    maps.push_back(make_map(pair, "relative", "mean over channels of (t - r) / (|r| + |t| + 0.01)",
                            ColorMap::BlueWhiteRed, -1, 1, channel_mean(pair, relative_error)));
    if (comparison.flip)
        maps.push_back(make_map(pair, "flip", "FLIP: how visible the difference is, 0 to 1",
                                ColorMap::Viridis, 0, 1,
                                [&](std::size_t i) { return comparison.flip->map[i]; }));
    if (comparison.noise)
        maps.push_back(make_map(pair, "z", "(t - r) / s of the channel where it is largest",
                                ColorMap::BlueWhiteRed, -z_limit, z_limit,
                                largest_z(reference, test, comparison, pair)));
    return maps;
}

void write_error_maps(const std::filesystem::path& folder, const Image& reference,
                      const Image& test, const Comparison& comparison) {
    const LayerPair pair = pair_layers(reference, test, comparison.layer);
    Image image(pair.width, pair.height);
    image.metadata = {{"plumbline:reference", reference.source},
                      {"plumbline:test", test.source},
                      {"plumbline:layer", comparison.layer}};
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < pair.pixels(); ++i) {
            const float d = pair.test[c][i] - pair.reference[c][i];
            image.layer("signed")[c][i] = d;
            image.layer("absolute")[c][i] = std::abs(d);
        }
    for (const ErrorMap& map : error_maps(reference, test, comparison)) {
        const Picture picture = false_color(map);
        write_png(folder / (map.name + ".png"), picture.width, picture.height, picture.rgb);
        if (map.name != "signed" && map.name != "absolute")
            std::copy(map.values.begin(), map.values.end(), image.channel(map.name + ".Y").begin());
    }
    write_exr(folder / "error_maps.exr", image);
}

}  // namespace plumbline::compare
