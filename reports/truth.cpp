// SPDX-License-Identifier: Apache-2.0
#include "reports/truth.h"

#include <fmt/format.h>

#include "pathtracer/render.h"
#include "reports/picture_size.h"
#include "scenes/errors.h"

namespace plumbline::reports {
namespace {

/// Pictures of other programs say nothing of a scene, and are taken at the user's word.
void check_subject(const Image& truth, const std::string& key, const std::string& what,
                   const std::string& expected) {
    const auto found = truth.metadata.find(key);
    if (found == truth.metadata.end() || found->second == expected) return;
    throw UsageError("--reference",
                     fmt::format("{} shows {} '{}'", truth.source, what, found->second),
                     fmt::format("give a picture of {} '{}'", what, expected));
}

Image read_truth(const Scene& scene, int frame, const std::string& file) {
    Image truth = read_image(file);
    check_subject(truth, "plumbline:scene", "scene", scene.name);
    check_subject(truth, "plumbline:frame", "frame", std::to_string(frame));
    return truth;
}

}  // namespace

Image truth_of(Scene& scene, int frame, const TruthSource& source, const CommonOptions& options) {
    if (source.file.empty()) {
        set_default_size(scene.camera, options, source.pixels);
        pathtracer::RenderOptions render;
        render.spp = source.spp;
        return pathtracer::render(scene, frame, render).image;
    }
    Image truth = read_truth(scene, frame, source.file);
    if (options.width && (*options.width != truth.width() || *options.height != truth.height()))
        throw UsageError("--size",
                         fmt::format("is {}x{}, but {} has {}x{} pixels", *options.width,
                                     *options.height, source.file, truth.width(), truth.height()),
                         "leave it out: pictures get the reference's size");
    scene.camera.width = truth.width();
    scene.camera.height = truth.height();
    return truth;
}

}  // namespace plumbline::reports
