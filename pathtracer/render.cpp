// SPDX-License-Identifier: Apache-2.0
#include "pathtracer/render.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "pathtracer/bounce_limit.h"
#include "pathtracer/checkpoint.h"
#include "pathtracer/passes.h"
#include "pathtracer/picture.h"
#include "pathtracer/provenance.h"
#include "pathtracer/schedule.h"
#include "scenes/errors.h"

namespace plumbline::pathtracer {
namespace {

/// Seconds since its making, and some before that.
class Stopwatch {
 public:
    explicit Stopwatch(double before = 0.) : before_(before) {}
    double seconds() const {
        return before_ + std::chrono::duration<double>(Clock::now() - start_).count();
    }

 private:
    using Clock = std::chrono::steady_clock;
    double before_;
    Clock::time_point start_ = Clock::now();
};

PathOptions path_options(const RenderOptions& options, const BounceLimit& limit) {
    PathOptions path;
    if (limit.max_bounces) path.max_scatterings = *limit.max_bounces + 1;
    if (options.max_bounces) path.roulette = *options.max_bounces > longest_without_roulette;
    return path;
}

/// Keeps a render in its file from time to time.
class Keeper {
 public:
    Keeper(const CheckpointOptions& options, const Provenance& provenance)
        : options_(options), provenance_(provenance) {
        if (options.file.empty() || options.resume || !exists(options.file)) return;
        throw UsageError(options.file.string(), "holds an unfinished render",
                         "continue it with --resume, or delete it");
    }

    /// Puts into `passes` what the file holds, if anything; the seconds spent on it.
    double resume(Passes& passes) const {
        if (!options_.resume || !exists(options_.file)) return 0.;
        Checkpoint checkpoint = read_checkpoint(options_.file, provenance_);
        passes.restore(std::move(checkpoint.gathered));
        return checkpoint.seconds;
    }

    bool interrupted() const { return !options_.file.empty() && options_.interrupted(); }
    bool due() const { return !options_.file.empty() && watch_.seconds() >= next_; }

    /// Throws ImageError if that fails and the render was interrupted: then nothing else is left.
    void keep(const Passes& passes, double seconds) {
        const double start = watch_.seconds();
        try {
            write_checkpoint(options_.file, {passes.gathered(), seconds}, provenance_);
        } catch (const ImageError& error) {
            if (interrupted()) throw;
            options_.not_written(error.what());
        }
        constexpr double most_of_the_time = .05;
        const double end = watch_.seconds();
        next_ = end + std::max(options_.every_seconds, (end - start) / most_of_the_time);
    }

 private:
    const CheckpointOptions& options_;
    const Provenance& provenance_;
    Stopwatch watch_;
    double next_ = options_.every_seconds;
};

/// The camera rays that fill the layer object.
std::uint64_t object_rays(const std::vector<PixelEstimate>& pixels) {
    return static_cast<std::uint64_t>(std::count_if(
        pixels.begin(), pixels.end(), [](const PixelEstimate& p) { return p.sums.samples > 0; }));
}

void check_shard(const Scene& scene, const RenderOptions& options) {
    const Shard& shard = options.shard;
    if (shard.count == 1) return;
    if (options.adaptive || options.seconds || options.target_relmse) {
        throw UsageError("--shard", "shards of one picture need equal samples a pixel",
                         options.adaptive ? "leave out --adaptive"
                                          : "give --spp in place of --time or --target-relmse");
    }
    const int tiles = Tiles(scene.camera.width, scene.camera.height).count();
    if (shard.count > tiles) {
        throw UsageError("--shard", fmt::format("{} shards of {} tiles", shard.count, tiles),
                         fmt::format("this picture can be cut into 1 to {}", tiles));
    }
}

void check_adaptive(const RenderOptions& options) {
    if (!options.adaptive || options.spp >= fewest_to_allocate) return;
    throw UsageError("--adaptive",
                     fmt::format("{} samples a pixel leave none to share out", options.spp),
                     fmt::format("give --spp {} or more", fewest_to_allocate));
}

SampleCounts counts_of(const std::vector<PixelEstimate>& pixels) {
    SampleCounts counts{.fewest = std::numeric_limits<std::uint32_t>::max()};
    double pixels_with_any = 0.;
    for (const PixelEstimate& pixel : pixels) {
        const std::uint32_t samples = pixel.sums.samples;
        if (samples == 0) continue;  // of another shard
        counts.mean += samples;
        counts.fewest = std::min(counts.fewest, samples);
        counts.most = std::max(counts.most, samples);
        ++pixels_with_any;
    }
    counts.mean /= pixels_with_any;
    return counts;
}

std::string adaptive_text(int pilot, const SampleCounts& counts) {
    return fmt::format(
        "{} to {} samples a pixel; each half-tile's share by the root of relMSE over rays of the "
        "other's first {} samples a pixel",
        counts.fewest, counts.most, pilot);
}

/// Adds passes until the schedule ends, or false if interrupted.
bool add_all(Passes& passes, const RenderOptions& options, Keeper& keeper, const Stopwatch& watch) {
    Schedule schedule(options);
    Progress progress("", 1, passes.steps(passes.samples()));
    while (const std::optional<Pass> pass = schedule.next(passes, watch.seconds())) {
        if (schedule.pilot_ends(passes)) passes.share_out();
        progress.revise(schedule.label(), passes.steps(schedule.samples_expected()));
        while (!passes.add(*pass, progress, [&] { return keeper.interrupted() || keeper.due(); })) {
            keeper.keep(passes, watch.seconds());
            if (keeper.interrupted()) return false;
        }
    }
    return true;
}

}  // namespace

std::optional<RenderResult> render(const Scene& scene, int frame, const RenderOptions& options,
                                   const CheckpointOptions& checkpoints) {
    check_shard(scene, options);
    check_adaptive(options);
    const Stopwatch setting_up;
    const Provenance provenance = provenance_of(scene, frame, options);
    Keeper keeper(checkpoints, provenance);
    const World world = world_at(scene, frame);
    const RayTracer tracer(world);
    const Effects effects = effects_of(scene);
    const BounceLimit limit = bounce_limit(world, effects, options);
    Passes passes(tracer, effects, path_options(options, limit), options.seed, options.shard,
                  options.adaptive ? Sampling::Adaptive : Sampling::Even);
    const Stopwatch watch(keeper.resume(passes) + setting_up.seconds());
    if (!add_all(passes, options, keeper, watch)) return std::nullopt;

    RenderResult result{.image = picture(tracer, passes),
                        .spp = passes.samples(),
                        .seconds = watch.seconds(),
                        .rays = passes.rays() + object_rays(passes.pixels()),
                        .relmse_estimate = relmse_estimate(passes.pixels()),
                        .non_finite = passes.non_finite(),
                        .counts = counts_of(passes.pixels())};
    const bool by_batches = passes.first_pixel().groups < passes.first_pixel().sums.samples;
    auto& metadata = result.image.metadata;
    metadata = provenance;
    metadata["plumbline:spp"] = std::to_string(result.spp);
    if (const Allocation& allocation = passes.gathered().allocation; !allocation.shares.empty()) {
        metadata["plumbline:adaptive"] = adaptive_text(allocation.pilot, result.counts);
    }
    metadata["plumbline:bounces"] =
        limit.max_bounces ? fmt::format("{}: {}", *limit.max_bounces, limit.why) : limit.why;
    metadata["plumbline:seconds"] = fmt::format("{:.3f}", result.seconds);
    metadata["plumbline:depth"] = "distance along the view axis";
    metadata["plumbline:variance"] = by_batches
                                         ? "of the mean, from independent batches of 16 samples"
                                         : "of the mean, from single samples (conservative)";
    return result;
}

RenderResult render(const Scene& scene, int frame, const RenderOptions& options) {
    return *render(scene, frame, options, CheckpointOptions{});
}

}  // namespace plumbline::pathtracer
