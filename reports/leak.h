// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "reports/ablation_cases.h"
#include "scenes/scene.h"

namespace plumbline::reports {

/// Indirect light on both sides of a wall that lets none through: mean radiance of the pixels of
/// each room, W m^-2 sr^-1.
struct Leak {
    double cells;  ///< thickness of the wall, in spacings of the probes
    double lit;
    double dark;

    /// What reaches the dark room, as a share of the lit room's; all of it leaked.
    double share() const { return dark / lit; }
};

/// How much one way to light probes leaks, against the wall's thickness.
struct LeakCurve {
    AblationCase subject;
    std::vector<Leak> leaks;  ///< in the order of LeakOptions::cells
};

struct LeakOptions {
    /// 0 is a wall without thickness, opaque and lit on both sides.
    std::vector<double> cells{0., .02, .05, .1, .2, .3, .5, .75, 1.};
    int width = 240, height = 135;
};

/// The built-in scene two-rooms with its door shut and a wall of `cells` spacings between the
/// rooms, centred between two layers of probes.
Scene rooms_with_wall(double cells);

/// Means of a picture's indirect layer over the pixels of each room of rooms_with_wall(cells).
/// The edge of the wall itself, which the camera sees between the rooms, counts for neither.
Leak leak_in(const Image& picture, const Scene& rooms, double cells);

/// Stills of every case at every thickness. Throws UsageError for a thickness that is negative,
/// not finite or above one cell.
std::vector<LeakCurve> measure_leak(const std::vector<AblationCase>& cases,
                                    const LeakOptions& options);

}  // namespace plumbline::reports
