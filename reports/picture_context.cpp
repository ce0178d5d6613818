// SPDX-License-Identifier: Apache-2.0
#include "reports/picture_context.h"

#include <fmt/core.h>

#include <cmath>

#include "reports/error_pictures.h"
#include "reports/pictures.h"
#include "reports/shrink.h"
#include "reports/tables.h"
#include "reports/words.h"

namespace plumbline::reports {

namespace {

using nlohmann::json;

std::string exposure_text(double stops) {
    return fmt::format(
        "{:+.1f} stops (radiance {} shows as white; 99 % of the truth's values are "
        "below or within half a stop of it)",
        stops, number_text(std::exp2(-stops)));
}

json column(const std::string& title, const std::string& color, const Image& image, double stops) {
    const auto uri = [&](const char* layer) {
        return png_uri(image.width(), image.height(), display_bytes(image, layer, stops));
    };
    return {{"title", title},      {"color", color},
            {"radiance", uri("")}, {"indirect", uri("indirect")},
            {"is_truth", false},   {"maps", json::array()}};
}

std::string title_of(const compare::ErrorMap& map) {
    return map.name == "signed" ? "Signed error" : "Absolute error";
}

json maps_of(const std::vector<compare::ErrorMap>& maps, int block) {
    json shown = json::array();
    for (const compare::ErrorMap& map : maps)
        shown.push_back({{"title", title_of(map)},
                         {"uri", png_uri(blocks(map.width, block), blocks(map.height, block),
                                         map_bytes(map, block))}});
    return shown;
}

json scale_bars(const std::vector<compare::ErrorMap>& maps) {
    json bars = json::array();
    for (const compare::ErrorMap& map : maps) {
        const std::vector<unsigned char> colors = color_table(map.colors);
        json ticks = json::array();
        for (const double tick : {map.low, (map.low + map.high) / 2, map.high})
            ticks.push_back(number_text(tick));
        bars.push_back({{"title", title_of(map)},
                        {"uri", png_uri(static_cast<int>(colors.size() / 3), 1, colors)},
                        {"ticks", ticks}});
    }
    return bars;
}

}  // namespace

json picture_context(const SceneReport& report, int block) {
    const double stops = exposure_of(report);
    const Image truth = shrunk(report.truth.image, block);
    json columns = json::array({column("truth", "truth", truth, stops)});
    columns[0]["is_truth"] = true;
    json bars = json::array();
    for (std::size_t i = 0; i < report.models.size(); ++i) {
        const ModelRun& run = report.models[i];
        const Image image = shrunk(run.result.image, block);
        json shown = column(run.title, model_color(i), image, stops);
        const std::vector<compare::ErrorMap> maps = shown_error_maps(report, run);
        shown["maps"] = maps_of(maps, block);
        bars = scale_bars(maps);
        columns.push_back(std::move(shown));
    }
    const std::string note =
        block == 1 ? ""
                   : fmt::format(
                         "To keep this file small, pictures are shown as means of {} x {} "
                         "pixels; the figures are of the whole picture.",
                         block, block);
    return {{"exposure", exposure_text(stops)},
            {"shrunk", note},
            {"pictures", columns},
            {"scale_bars", bars}};
}

}  // namespace plumbline::reports
