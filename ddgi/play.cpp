// SPDX-License-Identifier: Apache-2.0
#include "ddgi/play.h"

#include <memory>

#include "ddgi/picture.h"
#include "ddgi/stopwatch.h"

namespace plumbline::ddgi {
namespace {

void play_with_probes(const Scene& scene, std::span<const int> frames, const DdgiOptions& options,
                      const FramePlayed& played) {
    ProbeVolume volume(scene, options);
    for (const int frame : frames) {
        volume.move_to(frame);
        volume.update();
        const Stopwatch watch;
        const Picture picture = take_picture(volume.tracer(), volume.model(), &volume,
                                             picture_options(options, volume.model()));
        FrameFigures figures = volume.figures();
        figures.primary_ms = watch.ms();
        figures.shadow_rays += picture.shadow_rays;
        played(figures, picture.image);
    }
}

void play_without_probes(const Scene& scene, std::span<const int> frames,
                         const DdgiOptions& options, const FramePlayed& played) {
    const ModelSetup setup =
        make_model(options.model, scene, grid_for(scene, options), options.set, options.probes);
    World world;
    std::unique_ptr<RayTracer> tracer;
    for (const int frame : frames) {
        FrameFigures figures;
        const Stopwatch moving;
        World next = world_at(scene, frame);
        if (tracer == nullptr || !motion_between(world, next).none()) {
            world = std::move(next);
            tracer = std::make_unique<RayTracer>(world);
        }
        figures.bvh_ms = moving.ms();
        const Stopwatch watch;
        const Picture picture =
            take_picture(*tracer, *setup.model, nullptr, picture_options(options, *setup.model));
        figures.primary_ms = watch.ms();
        figures.shadow_rays = picture.shadow_rays;
        played(figures, picture.image);
    }
}

}  // namespace

void play(const Scene& scene, std::span<const int> frames, const DdgiOptions& options,
          const FramePlayed& played) {
    if (options.gi) {
        play_with_probes(scene, frames, options, played);
    } else {
        play_without_probes(scene, frames, options, played);
    }
}

}  // namespace plumbline::ddgi
