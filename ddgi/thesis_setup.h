// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ddgi/render.h"
#include "ddgi/surfel_cache.h"
#include "ddgi/thesis_formulas.h"

namespace plumbline::ddgi {

/// One look-up of a picture's probe light: the surface point that one of its samples sees.
struct PixelLookUp {
    std::uint32_t pixel;  ///< row by row from the top left
    glm::vec3 position;   ///< world space
    glm::vec3 n;          ///< unit normal
};

/// All that the probe light of the thesis's model depends on at one frame, besides its constants:
/// enough to compute a picture's `indirect` layer for other constants without tracing a ray.
///
/// With parameters of type ThesisParameters<T>, T a dual number or double:
///
///     const ThesisField field = setup.field();
///     const std::size_t size = probe_count(field.grid) * 3 * octant_count;
///     std::vector<T> lit(size), values(size, T(0)), next(size);
///     thesis_lit<T>(field, parameters, {}, lit);              // once: no feedback
///     const T propagation = thesis_propagation(parameters.falloffRegulator, field.grid.spacing);
///     for (;;) {                                              // until converged
///         thesis_propagate<T>(field.grid, setup.miss_shares, propagation, lit, values, next);
///         values.swap(next);
///     }
///     for (const PixelLookUp& at : setup.look_ups) {
///         indirect[at.pixel] += parameters.probeBrightness / setup.samples_per_pixel *
///                               thesis_look_up<T>(field.grid, values, at.position, at.n);
///     }
///
/// With feedback, pass `values` to thesis_lit at every update instead of {}.
struct ThesisSetup {
    SurfelCache cache;
    std::vector<float> miss_shares;     ///< see thesis_miss_shares
    std::vector<PixelLookUp> look_ups;  ///< samples that meet nothing are left out
    int samples_per_pixel;
    ThesisConstants constants;  ///< as the renderer would use them

    ThesisField field() const { return {cache.grid(), cache.pattern(), cache.surfels()}; }
};

/// Throws UsageError in the name of the scene if thesis_obstacle() says why its grid will not do.
void check_thesis_grid(const std::string& scene, const ProbeGrid& grid);

/// Places and lights the surfels of one frame and finds what the camera sees. Of `options`,
/// surfels, spacing and set count. Throws UsageError as render() and check_thesis_grid() do.
ThesisSetup thesis_setup(const Scene& scene, int frame, const DdgiOptions& options);

}  // namespace plumbline::ddgi
