// SPDX-License-Identifier: Apache-2.0
#include "ddgi/render.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ddgi/picture.h"
#include "ddgi/spectral_radius.h"
#include "ddgi/stopwatch.h"
#include "scenes/errors.h"
#include "scenes/progress.h"

namespace plumbline::ddgi {
namespace {

constexpr float most_normal_bias = 1.f;  // a cell away no weight means anything

void check(const DdgiOptions& options) {
    if (options.shadow_rays < 1) {
        throw UsageError("--shadow-rays", fmt::format("{} rays", options.shadow_rays),
                         "give 1 or more");
    }
    if (options.edge_samples && *options.edge_samples != samples_per_pixel &&
        *options.edge_samples != samples_on_edges) {
        throw UsageError("--edge-samples", fmt::format("{} samples", *options.edge_samples),
                         fmt::format("give {} or {}", samples_per_pixel, samples_on_edges));
    }
    if (!(std::abs(options.probes.normal_bias) <= most_normal_bias)) {
        throw UsageError("--normal-bias", fmt::format("{} spacings", options.probes.normal_bias),
                         fmt::format("give a number from -{0} to {0}", most_normal_bias));
    }
    if (options.updates && *options.updates < 0) {
        throw UsageError("--updates", fmt::format("{} updates", *options.updates),
                         "give 0 or more");
    }
    if (options.budget && *options.budget < 1) {
        throw UsageError("--budget", fmt::format("{} surfels", *options.budget), "give 1 or more");
    }
    // Smaller cells than any two surfels' distance would overflow the number of a cell.
    constexpr double least_share = 1e-9;
    if (!(options.share == 0. || (options.share >= least_share &&
                                  options.share < std::numeric_limits<double>::infinity()))) {
        throw UsageError(
            "--share", fmt::format("cells {} spacings wide", options.share),
            fmt::format("give 0, no sharing, or a width of {} or more, such as 0.25", least_share));
    }
    if (options.budget && !options.cache) {
        throw UsageError("--budget", "without the cache every surfel is placed at every frame",
                         "leave --no-cache out, or --budget");
    }
}

/// Plays the frames before `frame` with one update each, then updates there as asked.
void play(ProbeVolume& volume, int frame, const DdgiOptions& options) {
    Progress progress("Probes", static_cast<std::uint64_t>(frame) + 1);
    for (int f = 0; f < frame; ++f) {
        volume.move_to(f);
        volume.update();
        progress.advance();
    }
    volume.move_to(frame);
    if (!options.updates) {
        volume.converge();
        return;
    }
    for (int i = 0; i < *options.updates; ++i) volume.update();
}

/// Counts values that are not finite, and notes where the first is.
std::uint64_t count_non_finite(const Image& image, std::vector<std::string>& notes) {
    std::uint64_t count = 0;
    for (const std::string& name : image.channel_names()) {
        const std::span<const float> channel = image.channel(name);
        const auto finite = [](float value) { return std::isfinite(value); };
        const auto first = std::ranges::find_if_not(channel, finite);
        if (first == channel.end()) continue;
        const auto bad = channel.end() - first - std::count_if(first, channel.end(), finite);
        const auto pixel = first - channel.begin();
        notes.push_back(fmt::format("{} values of {} are not finite, the first at pixel ({}, {})",
                                    bad, name, pixel % image.width(), pixel / image.width()));
        count += static_cast<std::uint64_t>(bad);
    }
    return count;
}

void describe(Image& image, const Scene& scene, int frame, const DdgiOptions& options,
              const DdgiResult& result) {
    image.metadata["plumbline:version"] = PLUMBLINE_VERSION;
    image.metadata["plumbline:renderer"] = "ddgi";
    image.metadata["plumbline:scene"] = scene.name;
    image.metadata["plumbline:frame"] = std::to_string(frame);
    image.metadata["plumbline:model"] = options.model;
    image.metadata["plumbline:gi"] = options.gi ? "on" : "off";
    image.metadata["plumbline:cache"] = options.cache ? "on" : "off";
    image.metadata["plumbline:surfels"] = std::to_string(options.surfels);
    image.metadata["plumbline:shadow_rays"] = std::to_string(options.shadow_rays);
    image.metadata["plumbline:samples"] = std::to_string(samples_per_pixel);
    image.metadata["plumbline:updates"] = std::to_string(result.figures.updates);
    image.metadata["plumbline:converged"] = result.figures.converged ? "yes" : "no";
    image.metadata["plumbline:seconds"] = fmt::format("{:.3f}", result.seconds);
    for (const auto& [name, value] : result.constants) {
        image.metadata["plumbline:" + name] = fmt::format("{}", value);
    }
    if (options.spacing) image.metadata["plumbline:spacing"] = fmt::format("{}", *options.spacing);
    if (options.share > 0.) image.metadata["plumbline:share"] = fmt::format("{}", options.share);
    if (options.budget) image.metadata["plumbline:budget"] = std::to_string(*options.budget);
}

/// Says how the probes feed themselves, and warns where that cannot end well.
void measure_feedback(const Scene& scene, const ProbeVolume& volume, const DdgiOptions& options,
                      DdgiResult& result) {
    if (!volume.model().is_linear()) {
        result.notes.emplace_back(
            "the probe update is not linear in what the probes hold: it has no spectral radius");
        return;
    }
    std::vector<float> mode;
    const Stopwatch watch;
    const SpectralRadius radius = spectral_radius(
        volume.model(), probe_count(volume.cache().grid()), volume.values().size(), mode);
    result.spectral_radius = radius.value;
    if (radius.value >= 1.)
        result.critical_multi_bounce = critical_multi_bounce(scene, volume, options);
    result.radius_seconds = watch.ms() / 1e3;
    if (radius.value < 1.) return;
    result.notes.push_back(fmt::format(
        "the spectral radius of the probe update is {:.4f}: at 1 or more the probes feed each "
        "other more light than they lose, and end in light that the scene does not have; {}",
        radius.value,
        result.critical_multi_bounce
            ? fmt::format("keep multiBounceIntensity below {:.4g}", *result.critical_multi_bounce)
            : "missed rays alone bring that much: lower falloffRegulator"));
}

DdgiResult render_with_probes(const Scene& scene, int frame, const DdgiOptions& options) {
    ProbeVolume volume(scene, options);
    play(volume, frame, options);
    const Stopwatch watch;
    Picture picture = take_picture(volume.tracer(), volume.model(), &volume,
                                   picture_options(options, volume.model()));
    DdgiResult result{std::move(picture.image), volume.figures(), 0., volume.model().constants(),
                      volume.notes()};
    result.figures.primary_ms = watch.ms();
    result.figures.shadow_rays += picture.shadow_rays;
    if (!options.updates && !result.figures.converged) {
        result.notes.push_back(
            fmt::format("the probes did not converge: after {} updates they still change by {:.2g}",
                        result.figures.updates, result.figures.relative_change));
        if (result.figures.surfels_waiting > 0) {
            result.notes.back() +=
                fmt::format(", and {} surfels wait for their turn", result.figures.surfels_waiting);
        }
    }
    if (options.spectral_radius) measure_feedback(scene, volume, options, result);
    return result;
}

DdgiResult render_without_probes(const Scene& scene, int frame, const DdgiOptions& options) {
    const ModelSetup setup =
        make_model(options.model, scene, grid_for(scene, options), options.set, options.probes);
    const Stopwatch building;
    const World world = world_at(scene, frame);
    const RayTracer tracer(world);
    const double bvh_ms = building.ms();
    const Stopwatch watch;
    Picture picture =
        take_picture(tracer, *setup.model, nullptr, picture_options(options, *setup.model));
    DdgiResult result{std::move(picture.image), {}, 0., setup.model->constants(), setup.notes};
    result.figures.bvh_ms = bvh_ms;
    result.figures.primary_ms = watch.ms();
    result.figures.shadow_rays = picture.shadow_rays;
    return result;
}

}  // namespace

DdgiResult render(const Scene& scene, int frame, const DdgiOptions& options) {
    check(options);
    const Stopwatch watch;
    DdgiResult result = options.gi ? render_with_probes(scene, frame, options)
                                   : render_without_probes(scene, frame, options);
    result.seconds = watch.ms() / 1e3 - result.radius_seconds;
    result.figures.non_finite = count_non_finite(result.image, result.notes);
    describe(result.image, scene, frame, options, result);
    return result;
}

}  // namespace plumbline::ddgi
