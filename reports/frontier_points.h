// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reports/frontier.h"

namespace plumbline::reports {

/// The path tracer at `spp`: one picture a repeat, each with a seed of its own.
FrontierPoint measure_path_tracer(const Scene& scene, int frame, const Image& truth, int spp,
                                  int repeats);

/// The probes of a case after 1, 4 and 16 updates, where these are fewer than all, and after all.
std::vector<FrontierPoint> measure_probes(const Scene& scene, int frame, const Image& truth,
                                          const FrontierCase& subject, int repeats);

}  // namespace plumbline::reports
