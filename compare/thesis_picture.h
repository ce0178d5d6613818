// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tbb/parallel_for.h>

#include <array>
#include <span>
#include <vector>

#include "compare/convergence.h"
#include "ddgi/thesis_setup.h"

namespace plumbline::compare {

/// The constants that a fit may choose, in the order of Constants.
inline constexpr std::array<const char*, 4> constant_names{
    "falloffRegulator", "bounceAttenuation", "probeBrightness", "multiBounceIntensity"};

/// Values of constant_names; T is double or a dual number.
template <typename T>
using Constants = std::array<T, constant_names.size()>;

/// The `indirect` layer of the thesis's model for one scene, frame and size, as a function of its
/// constants: surfels and camera rays are traced once, then only the renderer's formulas run.
class ThesisPicture {
 public:
    /// `scene` is needed during construction only.
    ThesisPicture(const Scene& scene, int frame, int width, int height);

    /// The constants as published for the scene.
    const Constants<double>& published() const { return published_; }
    /// The falloffRegulator at which a missed ray brings all of the neighbour's light.
    double lossless_falloff() const;
    int width() const { return width_; }
    int height() const { return height_; }

    /// Radiance of the pixels (row by row from the top left; ascending), three channels each, with
    /// all probes converged. Throws FitError if they do not converge. Light fed back is followed if
    /// multiBounceIntensity is not 0, or if `fits_feedback`, for its derivative at 0.
    template <typename T>
    std::vector<T> indirect(const Constants<T>& constants, std::span<const std::uint32_t> pixels,
                            bool fits_feedback = false) const;

 private:
    template <typename T>
    std::vector<T> converged_probes(const Constants<T>& constants, bool feedback) const;

    ddgi::ThesisSetup setup_;
    Constants<double> published_;
    int width_, height_;
    std::vector<std::size_t> first_look_up_;  ///< of each pixel, and one past the last
};

template <typename T>
std::vector<T> ThesisPicture::converged_probes(const Constants<T>& constants, bool feedback) const {
    const auto& [falloff, attenuation, brightness, multi_bounce] = constants;
    const ddgi::ThesisParameters<T> parameters{falloff, attenuation, brightness, multi_bounce};
    const ddgi::ThesisField field = setup_.field();
    const std::size_t size = std::size_t(ddgi::probe_count(field.grid)) * 3 * ddgi::octant_count;
    std::vector<T> lit(size), values(size, T(0)), next(size);
    ddgi::thesis_lit<T>(field, parameters, {}, lit);
    const T propagation = ddgi::thesis_propagation(falloff, field.grid.spacing);
    Convergence convergence;
    do {
        if (feedback) ddgi::thesis_lit<T>(field, parameters, values, lit);
        ddgi::thesis_propagate<T>(field.grid, setup_.miss_shares, propagation, lit, values, next);
        values.swap(next);
    } while (!convergence.reached<T>(next, values));
    return values;
}

template <typename T>
std::vector<T> ThesisPicture::indirect(const Constants<T>& constants,
                                       std::span<const std::uint32_t> pixels,
                                       bool fits_feedback) const {
    const std::vector<T> probes =
        converged_probes(constants, fits_feedback || constants[3] != T(0));
    const T scale = constants[2] / double(setup_.samples_per_pixel);
    std::vector<T> result(pixels.size() * 3, T(0));
    tbb::parallel_for(std::size_t(0), pixels.size(), [&](std::size_t i) {
        for (std::size_t k = first_look_up_[pixels[i]]; k < first_look_up_[pixels[i] + 1]; ++k) {
            const ddgi::PixelLookUp& at = setup_.look_ups[k];
            const auto light =
                ddgi::thesis_look_up<T>(setup_.cache.grid(), probes, at.position, at.n);
            for (std::size_t c = 0; c < 3; ++c) result[i * 3 + c] += scale * light[c];
        }
    });
    return result;
}

}  // namespace plumbline::compare
