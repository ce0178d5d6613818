// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>

#include "ddgi/model.h"
#include "ddgi/render.h"
#include "reports/commands.h"
#include "reports/output_folder.h"
#include "reports/picture_size.h"
#include "reports/pictures.h"
#include "reports/study_page.h"
#include "reports/words.h"
#include "scenes/command_line.h"
#include "scenes/errors.h"
#include "scenes/output_path.h"
#include "scenes/scene_checks.h"

namespace plumbline {

namespace {

/// Of a picture without --size, at 16:9.
constexpr double default_pixels = 480. * 270.;
/// Probe light is brightened by this where it is shown alone: probeBrightness 101 in place of 26.2
/// [Dellson 2023, figures 5.3 and 5.9].
constexpr double brightened = 101. / 26.2;

struct Options {
    CommonOptions common;
    std::vector<std::string> scenes{"cornell-box", "room-with-door"};
    std::filesystem::path folder;
    std::string model = "thesis";
    int shadow_rays = 1000;
    float light_radius = 10.f;
};

/// Shadows of lights without size, or of lights given one.
struct Shadows {
    const char* name;
    const char* title;
    bool soft;
};
constexpr Shadows hard{"hard", "one shadow ray", false};
constexpr Shadows soft{"soft", "soft shadows", true};

/// Of the published figures that show the same, the one without probes; the next two follow it.
/// The thesis has no soft shadows of the room.
int first_figure(const std::string& scene, const Shadows& shadows) {
    if (scene == "cornell-box") return shadows.soft ? 7 : 1;
    return scene == "room-with-door" && !shadows.soft ? 4 : 0;
}

void check(const Options& options) {
    check_output_folder(options.folder);
    if (options.shadow_rays < 1)
        throw UsageError("--shadow-rays", fmt::format("{} rays", options.shadow_rays),
                         "give 1 or more");
    if (options.light_radius != 0.f &&
        !(options.light_radius >= smallest_size && options.light_radius <= farthest_place))
        throw UsageError("--light-radius", fmt::format("{}", options.light_radius),
                         fmt::format("give 0, or a length from {:g} to {:g} in the scene's unit",
                                     smallest_size, farthest_place));
}

/// The layers that a picture without probes shows: direct light, and ambient where there is some.
Image without_probes(const Image& picture) {
    Image image(picture.width(), picture.height());
    const auto shown = image.layer("");
    for (const char* layer : {"direct", "ambient"}) {
        if (!picture.has_layer(layer)) continue;
        const auto part = picture.layer(layer);
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t i = 0; i < image.pixels(); ++i) shown[c][i] += part[c][i];
    }
    return image;
}

/// The three pictures of a scene under one kind of shadows, from one rendering.
void add_pictures(const Options& options, Scene scene, const Shadows& shadows,
                  reports::StudySection& section) {
    ddgi::DdgiOptions ddgi;
    ddgi.model = options.model;
    if (shadows.soft) {
        ddgi.shadow_rays = options.shadow_rays;
        for (PointLight& light : scene.lights) light.radius = options.light_radius;
    }
    const int frame = options.common.frame ? frame_of(scene, options.common) : scene.report_frame;
    const Image picture = ddgi::render(scene, frame, ddgi).image;
    const Image direct = without_probes(picture);
    const double stops = scene.thesis ? std::log2(double(scene.thesis->imageBrightness)) : 0.;
    int figure = first_figure(scene.name, shadows);
    const auto add = [&](const char* title, const Image& image, const char* layer, double gain) {
        const std::string number = figure > 0 ? fmt::format("Figure 5.{}: ", figure++) : "";
        section.pictures.push_back(
            {reports::png_uri(image.width(), image.height(),
                              reports::display_bytes(image, layer, stops + std::log2(gain))),
             fmt::format("{}{}, {}", number, title, shadows.title)});
    };
    add("without probes", direct, "", 1.);
    add("with probes", picture, "", 1.);
    add("probe light alone, brightened", picture, "indirect", brightened);
}

std::string command_of(const Options& options) {
    std::string command = "plumbline pictures";
    for (const std::string& scene : options.scenes) command += " " + reports::shell_word(scene);
    if (options.common.width)
        command += fmt::format(" --size {}x{}", *options.common.width, *options.common.height);
    return command + fmt::format(" --model {} --shadow-rays {} --light-radius {} -o {}",
                                 options.model, options.shadow_rays, options.light_radius,
                                 reports::shell_word(options.folder.string()));
}

void run(const Options& options) {
    const auto threads = options.common.apply();
    check(options);
    reports::StudyPage page;
    page.title = "With probes and without";
    page.command = command_of(options);
    page.lead = {fmt::format(
        "Model {}. Soft shadows take {} rays a sample to lights given a radius of {}; the thesis "
        "does not say its own. Probe light alone is shown {:.2f} times as bright.",
        options.model, options.shadow_rays, options.light_radius, brightened)};
    for (const std::string& name : options.scenes) {
        Scene scene = load_scene_for(name, options.common);
        reports::set_default_size(scene.camera, options.common, default_pixels);
        reports::StudySection section{scene.name, {}, {}, {}, {}};
        for (const Shadows& shadows : {hard, soft}) add_pictures(options, scene, shadows, section);
        page.sections.push_back(section);
    }
    reports::write_folder(options.folder, {{"index.html", reports::study_html(page)}});
}

}  // namespace

void add_pictures_command(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "pictures", "Shows scenes with probes, without, and the probes' light alone");
    const auto options = std::make_shared<Options>();
    command.add_option("scenes", options->scenes,
                       "Built-in names or scene files (default: cornell-box room-with-door)");
    command.add_option("-o,--output", options->folder, "Folder for index.html")->required();
    add_common_options(command, options->common);
    command.add_option("--model", options->model,
                       fmt::format("{} (default: thesis)", fmt::join(ddgi::model_names(), ", ")));
    command.add_option("--shadow-rays", options->shadow_rays,
                       "Shadow rays a sample of the soft shadows (default: 1000)");
    command.add_option("--light-radius", options->light_radius,
                       "Radius of the lights that throw them (default: 10)");
    command.callback([options] { run(*options); });
}

}  // namespace plumbline
