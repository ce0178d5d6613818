// SPDX-License-Identifier: Apache-2.0
#include "reports/frontier_cases.h"

#include <fmt/core.h>

#include <algorithm>

#include "ddgi/grid.h"
#include "ddgi/thesis_model.h"

namespace plumbline::reports {

namespace {

const char* const octants_method = "conserving, octants";

/// A case from what it changes of a method's defaults: `flags` as on the command line.
FrontierCase make_case(const std::string& method, const std::string& setting,
                       const std::string& flags, const ddgi::DdgiOptions& options) {
    return {method, setting, "--model " + options.model + (flags.empty() ? "" : " " + flags),
            options};
}

ddgi::DdgiOptions with_model(const std::string& model) {
    ddgi::DdgiOptions options;
    options.model = model;
    return options;
}

std::string surfels_text(int surfels) { return fmt::format("{} surfels", surfels); }

void add_surfels(std::vector<FrontierCase>& cases, const std::string& method,
                 ddgi::DdgiOptions options, const std::vector<int>& counts) {
    for (const int surfels : counts) {
        options.surfels = surfels;
        std::string flags = fmt::format("--surfels {}", surfels);
        if (options.probes.storage == ddgi::Storage::Octants) flags += " --storage octants";
        cases.push_back(make_case(method, surfels_text(surfels), flags, options));
    }
}

void add_spacings(std::vector<FrontierCase>& cases, const std::string& method,
                  ddgi::DdgiOptions options, const Scene& scene,
                  const std::vector<float>& multiples) {
    const float own = probe_grid(scene).spacing;
    for (const float multiple : multiples) {
        options.spacing = own * multiple;
        const ProbeGrid grid = ddgi::with_spacing(probe_grid(scene), *options.spacing);
        if (options.model == "thesis" && ddgi::thesis_obstacle(grid)) continue;
        cases.push_back(make_case(
            method,
            fmt::format("{}, spacing {:.4g}", surfels_text(options.surfels), *options.spacing),
            fmt::format("--spacing {:.6g}", *options.spacing), options));
    }
}

/// The thesis's feedback, at its published strength: more bounces.
void add_bounces(std::vector<FrontierCase>& cases, const Scene& scene) {
    if (!scene.thesis || !(scene.thesis->multiBounceIntensity > 0)) return;
    if (ddgi::thesis_obstacle(probe_grid(scene))) return;
    ddgi::DdgiOptions options = with_model("thesis");
    const double strength = scene.thesis->multiBounceIntensity;
    options.set["multiBounceIntensity"] = strength;
    cases.push_back(make_case("thesis", surfels_text(options.surfels) + ", many bounces",
                              fmt::format("--set multiBounceIntensity={:.6g}", strength), options));
}

/// The choices of conserving that are not a matter of degree.
void add_choices(std::vector<FrontierCase>& cases) {
    const auto add = [&](const char* what, const char* flags, auto change) {
        ddgi::DdgiOptions options = with_model("conserving");
        change(options.probes);
        cases.push_back(
            make_case("conserving", surfels_text(options.surfels) + ", " + what, flags, options));
    };
    add("no weights", "--weights none",
        [](auto& probes) { probes.weights = ddgi::ProbeWeights::None; });
    add("back-face weights", "--weights backface",
        [](auto& probes) { probes.weights = ddgi::ProbeWeights::Backface; });
    add("feedback from rays", "--feedback rays",
        [](auto& probes) { probes.feedback = ddgi::Feedback::Rays; });
}

}  // namespace

std::vector<FrontierCase> frontier_cases(const Scene& scene, bool quick) {
    std::vector<FrontierCase> cases;
    const std::vector<int> thesis_surfels = quick ? std::vector{64} : std::vector{64, 160};
    const std::vector<int> surfels =
        quick ? std::vector{16, 64} : std::vector{16, 32, 64, 128, 256};
    const std::vector<float> multiples = quick ? std::vector{2.f} : std::vector{4.f, 2.f, .625f};
    if (!ddgi::thesis_obstacle(probe_grid(scene)))
        add_surfels(cases, "thesis", with_model("thesis"), thesis_surfels);
    add_spacings(cases, "thesis", with_model("thesis"), scene, multiples);
    add_bounces(cases, scene);
    ddgi::DdgiOptions octants = with_model("conserving");
    octants.probes.storage = ddgi::Storage::Octants;
    add_surfels(cases, octants_method, octants, quick ? std::vector{64} : std::vector{16, 64, 256});
    add_surfels(cases, "irradiance", with_model("irradiance"),
                quick ? std::vector{64} : std::vector{16, 64, 256});
    add_surfels(cases, "conserving", with_model("conserving"), surfels);
    add_spacings(cases, "conserving", with_model("conserving"), scene, multiples);
    if (!quick) add_choices(cases);
    return cases;
}

}  // namespace plumbline::reports
