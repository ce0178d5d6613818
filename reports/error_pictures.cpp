// SPDX-License-Identifier: Apache-2.0
#include "reports/error_pictures.h"

#include <algorithm>
#include <cmath>

#include "compare/layer_pair.h"
#include "reports/shrink.h"

namespace plumbline::reports {

namespace {

void append(std::vector<unsigned char>& rgb, const compare::Rgb8& color) {
    rgb.insert(rgb.end(), {color.r, color.g, color.b});
}

}  // namespace

double error_range(const SceneReport& report, const std::string& layer) {
    double range = 0;
    for (const ModelRun& run : report.models)
        range = std::max(range, compare::error_limit(compare::pair_layers(
                                    report.truth.image, run.result.image, layer)));
    return range;
}

std::vector<compare::ErrorMap> shown_error_maps(const SceneReport& report, const ModelRun& run) {
    std::vector<compare::ErrorMap> maps =
        compare::error_maps(report.truth.image, run.result.image, run.errors.indirect.comparison,
                            error_range(report, map_layer));
    std::erase_if(maps, [](const compare::ErrorMap& map) {
        return map.name != "signed" && map.name != "absolute";
    });
    return maps;
}

std::vector<unsigned char> map_bytes(const compare::ErrorMap& map, int block) {
    std::vector<unsigned char> rgb;
    for (const float value : block_means(map.values, map.width, map.height, block)) {
        const double t = (value - map.low) / (map.high - map.low);
        append(rgb, std::isfinite(t) ? compare::map_color(map.colors, t) : compare::no_value_color);
    }
    return rgb;
}

std::vector<unsigned char> color_table(compare::ColorMap colors) {
    constexpr int entries = 256;
    std::vector<unsigned char> rgb;
    for (int i = 0; i < entries; ++i) append(rgb, compare::map_color(colors, i / (entries - 1.)));
    return rgb;
}

}  // namespace plumbline::reports
