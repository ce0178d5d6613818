// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "ddgi/seen_probes.h"

namespace plumbline::ddgi {

/// What a probe of the model conserving keeps of the light that its rays bring.
enum class Storage {
    Rays,        ///< every ray's radiance
    Octants,     ///< the mean radiance of each octant
    Equal32,     ///< the mean radiance of 32 cells of equal solid angle
    Equal128,    ///< the same of 128
    Sh2,         ///< spherical harmonics of radiance, of order 2
    Sh3,         ///< the same of order 3
    Octahedral,  ///< irradiance on 64 directions of an octahedral map
};

/// What surfels gather the probes' light from. Storage::Rays only.
enum class Feedback {
    Maps,  ///< irradiances that each probe makes of its rays once an update
    Rays,  ///< all rays, as pixels do: nearer the truth, and many times the work
};

/// What users call them.
inline const std::map<std::string, Feedback> feedback_names = {{"maps", Feedback::Maps},
                                                               {"rays", Feedback::Rays}};
inline const std::map<std::string, Storage> storage_names = {{"rays", Storage::Rays},
                                                             {"octants", Storage::Octants},
                                                             {"equal32", Storage::Equal32},
                                                             {"equal128", Storage::Equal128},
                                                             {"sh2", Storage::Sh2},
                                                             {"sh3", Storage::Sh3},
                                                             {"octahedral", Storage::Octahedral}};
inline const std::map<std::string, ProbeWeights> weights_names = {
    {"none", ProbeWeights::None},
    {"backface", ProbeWeights::Backface},
    {"visibility", ProbeWeights::Visibility},
    {"moments", ProbeWeights::Moments}};

/// The choices of the model conserving; the defaults are the best measured. The other models have
/// no such choices.
struct ProbeOptions {
    Storage storage = Storage::Rays;
    ProbeWeights weights = ProbeWeights::Visibility;
    /// Each probe has its own shift of the ray pattern. Storage::Octants has none: its rays keep to
    /// their octants.
    bool shifted = true;
    /// Pixels see a ray's end from where they are, not from where the probe is. Storage::Rays only.
    bool parallax = true;
    Feedback feedback = Feedback::Maps;
    /// A point takes the trilinear weights, and with ProbeWeights::Moments the visibility, of one
    /// so far off it along its normal; in spacings.
    float normal_bias = 0.f;
    /// Probes that stand in something do not count, see ProbeDistances::inside().
    bool skip_inside = false;
    bool operator==(const ProbeOptions&) const = default;
};

}  // namespace plumbline::ddgi
