// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ddgi/render.h"

namespace plumbline::compare {

/// Where the flux of one indirect bounce goes: watts over all surfaces that see another, means over
/// the channels.
struct BounceEnergy {
    int bounce;
    double arriving;   ///< integral of E: what light of the bounce before brings, by ray casting
    double absorbed;   ///< integral of (1 - albedo) E
    double reflected;  ///< integral of albedo E: what should leave
    double shown;      ///< integral of pi L, L the radiance that the model shows of this bounce
    double invented;   ///< shown - reflected; negative: lost
    double standard_error;  ///< of invented, from the spread over points
};

struct EnergyAudit {
    std::string scene, model;
    int frame = 0;
    double area = 0;         ///< of the surfaces that are audited
    double unseen_area = 0;  ///< of those that see no surface, left out
    double direct = 0;       ///< flux that leaves before any bounce: emission and direct light
    double ambient = 0;      ///< flux that the model adds everywhere, whatever the light
    std::vector<BounceEnergy> bounces;
};

/// Audits the light of a model bounce by bounce.
///
/// At points even in area, E_k is gathered by cosine-distributed rays from what surfaces show of
/// bounce k - 1: of bounce 0 emission and direct light, of later ones what the model itself shows.
/// So each row is the model's own doing: reflected is what it should have shown of the light that
/// it had. A linear model's light of bounce k is the difference that its k-th update makes.
/// `thesis` has one bounce, taken at convergence and without feedback: all later light is lost.
/// Throws UsageError as ddgi::render() does.
EnergyAudit energy_audit(const Scene& scene, int frame, const ddgi::DdgiOptions& options,
                         int bounces, int points);

nlohmann::ordered_json to_json(const EnergyAudit& audit);
std::string to_text(const EnergyAudit& audit);

}  // namespace plumbline::compare
