// SPDX-License-Identifier: Apache-2.0
#include "ddgi/thesis_setup.h"

#include <tbb/parallel_for.h>

#include "ddgi/picture.h"
#include "ddgi/thesis_model.h"
#include "ddgi/volume.h"
#include "scenes/camera_rays.h"
#include "scenes/errors.h"

namespace plumbline::ddgi {
namespace {

std::vector<PixelLookUp> row_look_ups(const RayTracer& tracer, const CameraRays& rays, int y) {
    std::vector<PixelLookUp> row;
    const int width = tracer.world().camera.width;
    for (int x = 0; x < width; ++x) {
        for (const glm::vec2& at : pixel_samples(x, y)) {
            const auto hit = tracer.intersect(rays.through(at.x, at.y), BackFaces::Cull);
            if (!hit) continue;
            row.push_back({static_cast<std::uint32_t>(y * width + x), offset_origin(*hit, hit->n()),
                           hit->n()});
        }
    }
    return row;
}

std::vector<PixelLookUp> camera_look_ups(const RayTracer& tracer) {
    const Camera& camera = tracer.world().camera;
    const CameraRays rays(camera);
    std::vector<std::vector<PixelLookUp>> rows(static_cast<std::size_t>(camera.height));
    tbb::parallel_for(0, camera.height, [&](int y) {
        rows[static_cast<std::size_t>(y)] = row_look_ups(tracer, rays, y);
    });
    std::vector<PixelLookUp> all;
    for (const auto& row : rows) all.insert(all.end(), row.begin(), row.end());
    return all;
}

}  // namespace

void check_thesis_grid(const std::string& scene, const ProbeGrid& grid) {
    if (const auto obstacle = thesis_obstacle(grid))
        throw UsageError(scene, *obstacle, "give its grid three probes or more along each axis");
}

ThesisSetup thesis_setup(const Scene& scene, int frame, const DdgiOptions& options) {
    std::vector<std::string> notes;
    const ProbeGrid grid = grid_for(scene, options);
    check_thesis_grid(scene.name, grid);
    const World world = world_at(scene, frame);
    const RayTracer tracer(world);
    ThesisSetup setup{SurfelCache(grid, thesis_pattern(options.surfels), Reach::OneCell),
                      {},
                      camera_look_ups(tracer),
                      samples_per_pixel,
                      thesis_constants(scene, grid, options.set, notes)};
    setup.cache.rebuild(tracer);
    setup.miss_shares = thesis_miss_shares(setup.field());
    return setup;
}

}  // namespace plumbline::ddgi
