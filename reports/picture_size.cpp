// SPDX-License-Identifier: Apache-2.0
#include "reports/picture_size.h"

#include <algorithm>
#include <cmath>

namespace plumbline::reports {

void set_default_size(Camera& camera, const CommonOptions& options, double pixels) {
    if (options.width) return;
    const double aspect = double(camera.width) / double(camera.height);
    camera.width = std::max(1, static_cast<int>(std::lround(std::sqrt(pixels * aspect))));
    camera.height = std::max(1, static_cast<int>(std::lround(std::sqrt(pixels / aspect))));
}

}  // namespace plumbline::reports
