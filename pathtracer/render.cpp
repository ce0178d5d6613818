// SPDX-License-Identifier: Apache-2.0
#include "pathtracer/render.h"

#include <fmt/core.h>

#include <chrono>
#include <cmath>

#include "pathtracer/passes.h"
#include "pathtracer/picture.h"

namespace plumbline::pathtracer {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

PathOptions path_options(const RenderOptions& options) {
    PathOptions path;
    if (options.max_bounces) {
        path.max_scatterings = *options.max_bounces + 1;
        path.roulette = *options.max_bounces > longest_without_roulette;
    }
    return path;
}

/// All samples at once: by batches, or singly if there are fewer than two full batches.
void add_all(Passes& passes, const RenderOptions& options) {
    const int group = options.spp < 2 * Sampler::batch_size ? 1 : Sampler::batch_size;
    Progress progress(fmt::format("{} samples a pixel", options.spp), passes.tiles());
    passes.add({0, options.spp, group}, progress);
}

/// Batch by batch, until time, target or spp ends it.
void add_batches(Passes& passes, const RenderOptions& options, Clock::time_point start) {
    std::string error;
    for (int done = 0;;) {
        const Clock::time_point pass_start = Clock::now();
        const int last = std::min(done + Sampler::batch_size, options.spp);
        Progress progress(fmt::format("{} samples a pixel{}", last, error), passes.tiles());
        passes.add({done, last, done == 0 ? 1 : Sampler::batch_size}, progress);
        done = last;
        if (done == options.spp) return;
        if (options.target_relmse) {
            const double relmse = relmse_estimate(passes.pixels());
            if (relmse <= *options.target_relmse) return;
            error = fmt::format(", relMSE {:.2g}", relmse);
        }
        const double next_end = seconds_since(start) + seconds_since(pass_start);
        if (options.seconds && next_end > *options.seconds) return;
    }
}

/// The variance stands on batches, not on single samples.
bool by_batches(const Passes& passes) {
    const PixelEstimate& pixel = passes.pixels().front();
    return pixel.groups < pixel.sums.samples;
}

std::string options_text(const RenderOptions& options) {
    std::string text = "max_bounces=";
    text += options.max_bounces ? std::to_string(*options.max_bounces) : "unlimited";
    if (options.seconds) text += fmt::format(" time={}", *options.seconds);
    if (options.target_relmse) text += fmt::format(" target_relmse={}", *options.target_relmse);
    return text;
}

std::string effects_text(const Scene& scene) {
    std::string text;
    for (const EffectReason& reason : effect_reasons(scene)) {
        if (!reason.simulated) continue;
        text += text.empty() ? reason.effect : ", " + reason.effect;
    }
    return text;
}

/// How the picture was made, for the header of its file.
std::map<std::string, std::string> metadata(const Scene& scene, int frame,
                                            const RenderOptions& options,
                                            const RenderResult& result, bool by_batches) {
    return {
        {"plumbline:renderer", "pathtracer"},
        {"plumbline:version", PLUMBLINE_VERSION},
        {"plumbline:scene", scene.name},
        {"plumbline:frame", std::to_string(frame)},
        {"plumbline:seed", std::to_string(options.seed)},
        {"plumbline:spp", std::to_string(result.spp)},
        {"plumbline:options", options_text(options)},
        {"plumbline:effects", effects_text(scene)},
        {"plumbline:seconds", fmt::format("{:.3f}", result.seconds)},
        {"plumbline:depth", "distance along the view axis"},
        {"plumbline:variance", by_batches ? "of the mean, from independent batches of 16 samples"
                                          : "of the mean, from single samples (conservative)"},
    };
}

}  // namespace

RenderResult render(const Scene& scene, int frame, const RenderOptions& options) {
    const Clock::time_point start = Clock::now();
    const World world = world_at(scene, frame);
    const RayTracer tracer(world);
    Passes passes(tracer, effects_of(scene), path_options(options), options.seed);
    if (options.seconds || options.target_relmse) {
        add_batches(passes, options, start);
    } else {
        add_all(passes, options);
    }
    RenderResult result{.image = picture(tracer, passes),
                        .spp = static_cast<int>(passes.pixels().front().sums.samples),
                        .seconds = seconds_since(start),
                        .rays = passes.rays() + passes.pixels().size(),
                        .relmse_estimate = relmse_estimate(passes.pixels()),
                        .non_finite = passes.non_finite()};
    result.image.metadata = metadata(scene, frame, options, result, by_batches(passes));
    return result;
}

}  // namespace plumbline::pathtracer
