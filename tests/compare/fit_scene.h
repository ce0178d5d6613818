// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>
#include <stdexcept>
#include <string>

#include "compare/fit.h"
#include "compare/thesis_picture.h"
#include "scenes/scene_files.h"

namespace plumbline::compare {

inline constexpr int width = 64;
inline constexpr int height = 36;

/// The Cornell Box with an eighth of its probes. They see little of the walls, one cell away at
/// most, so the probe light is turned up to what the full grid gives.
inline Scene small_scene() {
    Scene scene = load_scene("cornell-box");
    scene.camera.width = width;
    scene.camera.height = height;
    scene.probes->spacing *= 2;
    scene.probes->counts = (scene.probes->counts - 1) / 2 + 1;
    scene.thesis->falloffRegulator *= 4;
    scene.thesis->probeBrightness *= 300;
    return scene;
}

inline std::vector<std::uint32_t> every_pixel() {
    std::vector<std::uint32_t> pixels(width * height);
    for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = std::uint32_t(i);
    return pixels;
}

/// What the model itself shows at these constants, with Gaussian noise of a known variance.
inline Image synthetic_truth(const Scene& scene, const Constants<double>& constants, float sigma,
                             unsigned seed) {
    const ThesisPicture picture(scene, 0, width, height);
    const auto radiance = picture.indirect<double>(constants, every_pixel());
    Image truth(width, height);
    const auto indirect = truth.layer("indirect"), variance = truth.layer("variance_indirect");
    std::mt19937 random(seed);
    std::normal_distribution<float> normal;
    for (std::size_t i = 0; i < truth.pixels(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const float s = sigma * (0.5f + float(i % width) / width);
            indirect[c][i] = float(radiance[i * 3 + c]) + s * normal(random);
            variance[c][i] = s * s;
        }
    return truth;
}

inline const FittedConstant& constant(const FitResult& result, const std::string& name) {
    for (const FittedConstant& one : result.constants)
        if (one.name == name) return one;
    throw std::out_of_range(name);
}

}  // namespace plumbline::compare
