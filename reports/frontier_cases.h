// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ddgi/render.h"
#include "scenes/scene.h"

namespace plumbline::reports {

/// A way to set up the probes, whose picture is measured after some and after all updates.
struct FrontierCase {
    std::string method;   ///< cases of one method are one colour of the chart
    std::string setting;  ///< what sets it apart from the method's others
    std::string options;  ///< of `plumbline ddgi`, to run the same
    ddgi::DdgiOptions ddgi;
};

/// Each model over surfels, spacing and bounces, and the choices of conserving one by one. Fewer if
/// `quick`. Without constants of its own for the thesis's model, a scene takes the Cornell Box's.
std::vector<FrontierCase> frontier_cases(const Scene& scene, bool quick);

}  // namespace plumbline::reports
