// SPDX-License-Identifier: Apache-2.0
#include "compare/parts.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "compare/find_layer.h"
#include "compare/row_sums.h"

namespace plumbline::compare {

namespace {

constexpr std::array<double, 11> percents{1, 5, 10, 25, 50, 75, 90, 95, 99, 99.9, 100};

struct ObjectSums {
    ErrorSums errors;
    double flip = 0;
    std::size_t pixels = 0;

    void add(const ObjectSums& other) {
        errors.add(other.errors);
        flip += other.flip;
        pixels += other.pixels;
    }
};

struct SumsByObject {
    std::map<long, ObjectSums> objects;
    void add(const SumsByObject& other) {
        for (const auto& [object, sums] : other.objects) objects[object].add(sums);
    }
};

SumsByObject sum_objects(const LayerPair& pair, std::span<const float> numbers,
                         std::span<const float> flip_map) {
    return merge_rows<SumsByObject>(pair.height, [&](int y) {
        SumsByObject row;
        const std::size_t begin = std::size_t(y) * std::size_t(pair.width);
        for (std::size_t i = begin; i < begin + std::size_t(pair.width); ++i) {
            if (!pair.usable[i] || !std::isfinite(numbers[i])) continue;
            ObjectSums& sums = row.objects[std::lround(numbers[i])];
            for (std::size_t c = 0; c < 3; ++c)
                sums.errors.add(double(pair.reference[c][i]), double(pair.test[c][i]));
            if (!flip_map.empty()) sums.flip += double(flip_map[i]);
            ++sums.pixels;
        }
        return row;
    });
}

}  // namespace

std::vector<ObjectError> errors_by_object(const Image& reference, const Image& test,
                                          const LayerPair& pair, std::span<const float> flip_map) {
    auto layer = find_layer_if_there(reference, "object");
    if (!layer) layer = find_layer_if_there(test, "object");
    if (!layer) return {};
    const auto sums = sum_objects(pair, layer->channels[0], flip_map).objects;
    double squares = 0;
    for (const auto& [object, sum] : sums) squares += sum.errors.square;
    std::vector<ObjectError> errors;
    for (const auto& [object, sum] : sums) {
        errors.push_back({object, sum.pixels, sum.errors.metrics(),
                          squares > 0 ? sum.errors.square / squares : 0});
        if (!flip_map.empty()) errors.back().metrics.flip = sum.flip / double(sum.pixels);
    }
    std::stable_sort(errors.begin(), errors.end(),
                     [](const auto& a, const auto& b) { return a.share > b.share; });
    return errors;
}

std::vector<ErrorPercentile> error_percentiles(const LayerPair& pair) {
    std::vector<float> errors;
    errors.reserve(pair.usable_pixels);
    for (std::size_t i = 0; i < pair.pixels(); ++i) {
        if (!pair.usable[i]) continue;
        double square = 0;  // in single precision errors from 2e19 on would overflow
        for (std::size_t c = 0; c < 3; ++c) {
            const double d = double(pair.test[c][i]) - double(pair.reference[c][i]);
            square += d * d;
        }
        errors.push_back(float(std::sqrt(square / 3)));
    }
    tbb::parallel_sort(errors);
    const auto square_of = [&](std::size_t i) { return double(errors[i]) * double(errors[i]); };
    double all = 0;
    for (std::size_t i = 0; i < errors.size(); ++i) all += square_of(i);
    std::vector<ErrorPercentile> curve;
    double below = 0;
    std::size_t summed = 0;
    for (double percent : percents) {
        // The nearest rank: the least error that at least this percentage does not exceed.
        const double exact_rank = percent / 100 * double(errors.size());
        const auto rank = std::max<std::size_t>(1, std::size_t(std::ceil(exact_rank - 1e-9)));
        for (; summed < rank; ++summed) below += square_of(summed);
        const double share = all > 0 ? std::max(0.0, (all - below) / all) : 0;
        curve.push_back({percent, double(errors[rank - 1]), share});
    }
    return curve;
}

}  // namespace plumbline::compare
