// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "compare/flip_filters.h"
#include "compare/layer_pair.h"
#include "compare/tone_mapper.h"

namespace plumbline::compare {

/// Turns linear values of a layer to what a display shows, in [0,1]: the identity or a tone
/// mapper, then a clamp.
struct Display {
    const ToneCurve* curve = nullptr;  ///< none: the identity
    float exposure_scale = 1.f;        ///< 2^stops; with a curve only

    glm::vec3 operator()(const glm::vec3& linear) const;
};

/// A rectangle of the picture.
struct Tile {
    int x, y;  ///< its top left corner
    int width, height;
};

/// Raises each value of `error` (one a pixel of the tile, row by row) to the LDR-FLIP of the
/// displayed pictures, if that is larger.
void raise_to_flip(const LayerPair& pair, const Display& display, const FlipFilters& filters,
                   const Tile& tile, std::span<float> error);

}  // namespace plumbline::compare
