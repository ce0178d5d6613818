// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace plumbline::reports {

/// A configuration's published mean times, milliseconds a frame, on an RTX 2070 Super at 1920x1080
/// [Dellson 2023, section 5.3].
struct PublishedTiming {
    std::string scene;
    int probes;
    std::string configuration;  ///< full_gi, no_surfels or gi_off
    int per_probe;
    int runs;
    double probe_update_static_ms, probe_update_animated_ms;
    double primary_static_ms, primary_animated_ms;
};

/// The twelve of both scenes.
const std::vector<PublishedTiming>& published_timings();

/// Null if the scene is not one of the two.
const PublishedTiming* published_timing(const std::string& scene, const std::string& configuration,
                                        int per_probe);

/// By how many percent surfels lower the published probe update while animated, at 64 rays a probe.
std::optional<double> published_saving_percent(const std::string& scene);

}  // namespace plumbline::reports
