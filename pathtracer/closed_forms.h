// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenes/scene.h"

namespace plumbline::pathtracer {

/// A scene in which the radiance along a ray is known.
struct ClosedForm {
    std::string name;
    std::string formula;
    std::string source;
    Scene scene;
    Ray ray;
    std::optional<int> max_bounces;  ///< none: until roulette ends the paths
    double expected;                 ///< radiance in every channel, W m^-2 sr^-1
};

/// Furnaces, integrating spheres, and floors under every kind of light.
std::vector<ClosedForm> closed_forms();

}  // namespace plumbline::pathtracer
