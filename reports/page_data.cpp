// SPDX-License-Identifier: Apache-2.0
#include "reports/page_data.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "compare/noise.h"
#include "reports/embedded_layers.h"
#include "reports/error_pictures.h"
#include "reports/layer_statistics.h"
#include "reports/pictures.h"
#include "reports/shrink.h"
#include "reports/tables.h"
#include "reports/verdict.h"

namespace plumbline::reports {

namespace {

using nlohmann::json;

/// A layer of images as the page names it: ids are part of element ids, so without a dot.
struct ShownLayer {
    const char* id;
    const char* layer;
    const char* title;
};
constexpr std::array shown_layers{ShownLayer{"radiance", "", "Picture (radiance)"},
                                  ShownLayer{"indirect", "indirect", "Indirect light"}};

/// Packs layers into HTML elements and remembers their text.
class LayerPacker {
 public:
    json pack(const std::string& id, std::span<const std::span<const float>> planes, int width) {
        const PackedPlanes packed = pack_planes(planes, width);
        elements +=
            fmt::format("<script type=\"text/plain\" id=\"{}\">{}</script>\n", id, packed.base64);
        return {{"id", id}, {"width", width}, {"exponent", packed.exponent}};
    }

    std::string elements;
};

json picture_json(LayerPacker& packer, std::size_t scene, const std::string& id,
                  const std::string& title, const Image& image) {
    json layers = json::object();
    for (const ShownLayer& shown : shown_layers)
        layers[shown.id] = packer.pack(fmt::format("layer-{}-{}-{}", scene, id, shown.id),
                                       image.layer(shown.layer), image.width());
    return {{"id", id}, {"title", title}, {"layers", layers}};
}

/// The standard errors of the truth's layers.
json noise_json(LayerPacker& packer, std::size_t scene, const Image& truth) {
    json noise = json::object();
    for (const ShownLayer& shown : shown_layers) {
        std::array<std::vector<float>, 3> errors;
        const auto variances = truth.layer(compare::variance_layer(shown.layer));
        for (std::size_t c = 0; c < 3; ++c)
            for (const float variance : variances[c]) errors[c].push_back(std::sqrt(variance));
        const std::array<std::span<const float>, 3> planes{errors[0], errors[1], errors[2]};
        noise[shown.id] =
            packer.pack(fmt::format("noise-{}-{}", scene, shown.id), planes, truth.width());
    }
    return noise;
}

json point(double seconds, const LayerError& error, const std::string& note, bool hollow) {
    return {
        {"x", seconds}, {"y", error.comparison.metrics.rmse}, {"note", note}, {"hollow", hollow}};
}

json frontier_json(const SceneReport& report) {
    json path_tracer = json::array();
    for (const PathTracerRun& run : report.path_tracer)
        path_tracer.push_back(
            point(run.seconds, run.errors.indirect, fmt::format("{} spp", run.spp), false));
    json models = json::array();
    for (std::size_t i = 0; i < report.models.size(); ++i) {
        const ModelRun& run = report.models[i];
        const LayerError& error = run.errors.indirect;
        models.push_back(
            {{"title", run.title},
             {"color", model_color(i)},
             {"points",
              json::array({point(run.frame_ms / 1e3, error, "one frame in motion", true),
                           point(run.result.seconds, error, "from empty probes", false)})}});
    }
    return {{"path_tracer", path_tracer},
            {"models", models},
            {"noise_floor", layer_noise(report.truth.image, "indirect")}};
}

/// A bar of the chart of noise and bias; nothing where the variances are unknown.
void add_split(json& bars, const std::string& title, const LayerError& error) {
    const std::optional<compare::NoiseSplit>& noise = error.comparison.noise;
    if (!noise) return;
    // A negative estimate of a square means none that can be seen; roots need that said as 0.
    const auto root = [](double square) { return std::sqrt(std::max(0., square)); };
    bars.push_back({{"title", title},
                    {"bias", root(noise->bias_mse)},
                    {"interval", {root(noise->bias_mse_ci95[0]), root(noise->bias_mse_ci95[1])}},
                    {"noise", root(noise->mse_expected_from_noise)}});
}

json scene_json(LayerPacker& packer, const SceneReport& report, std::size_t index, int block) {
    const Image truth = shrunk(report.truth.image, block);
    json pictures = json::array({picture_json(packer, index, "truth", "truth", truth)});
    json split = json::array();
    for (const ModelRun& run : report.models) {
        pictures.push_back(
            picture_json(packer, index, run.id, run.title, shrunk(run.result.image, block)));
        add_split(split, run.title, run.errors.indirect);
    }
    for (const PathTracerRun& run : report.path_tracer)
        add_split(split, fmt::format("path tracer, {} spp", run.spp), run.errors.indirect);
    json layers = json::array();
    json ranges = json::object();
    for (const ShownLayer& shown : shown_layers) {
        layers.push_back({{"id", shown.id}, {"title", shown.title}});
        ranges[shown.id] = error_range(report, shown.layer);
    }
    const ModelRun* best = verdict_of(report).best;
    return {{"name", report.name},
            {"width", truth.width()},
            {"height", truth.height()},
            {"exposure", exposure_of(report)},
            {"best", best != nullptr ? best->id : "truth"},
            {"layers", layers},
            {"pictures", pictures},
            {"noise", noise_json(packer, index, truth)},
            {"error_range", ranges},
            {"frontier", frontier_json(report)},
            {"split", split}};
}

std::string table_text(compare::ColorMap colors) { return base64(color_table(colors)); }

}  // namespace

PageData page_data(const Report& report, int block) {
    LayerPacker packer;
    json scenes = json::array();
    for (std::size_t i = 0; i < report.scenes.size(); ++i)
        scenes.push_back(scene_json(packer, report.scenes[i], i, block));
    return {{{"color_maps",
              {{"signed", table_text(compare::ColorMap::BlueWhiteRed)},
               {"absolute", table_text(compare::ColorMap::Viridis)}}},
             {"scenes", scenes}},
            packer.elements};
}

std::string script_json(const json& value) {
    // Non-ASCII, and "<", with which "</script" and "<!--" begin, go in as \u escapes.
    std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
    for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at))
        text.replace(at, 1, "\\u003c");
    return text;
}

}  // namespace plumbline::reports
