// SPDX-License-Identifier: Apache-2.0
#include "compare/thesis_picture.h"

namespace plumbline::compare {

namespace {

ddgi::ThesisSetup setup_for(Scene scene, int frame, int width, int height) {
    scene.camera.width = width;
    scene.camera.height = height;
    return ddgi::thesis_setup(scene, frame, {});
}

}  // namespace

ThesisPicture::ThesisPicture(const Scene& scene, int frame, int width, int height)
    : setup_(setup_for(scene, frame, width, height)),
      published_{
          double(setup_.constants.falloffRegulator), double(setup_.constants.bounceAttenuation),
          double(setup_.constants.probeBrightness), double(setup_.constants.multiBounceIntensity)},
      width_(width),
      height_(height),
      first_look_up_(std::size_t(width) * std::size_t(height) + 1, 0) {
    for (const ddgi::PixelLookUp& at : setup_.look_ups) ++first_look_up_[at.pixel + 1];
    for (std::size_t i = 1; i < first_look_up_.size(); ++i)
        first_look_up_[i] += first_look_up_[i - 1];
}

double ThesisPicture::lossless_falloff() const {
    const double spacing = double(setup_.cache.grid().spacing);
    return 2 * spacing * spacing;
}

}  // namespace plumbline::compare
