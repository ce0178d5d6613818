// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <array>

#include "reports/ablation_groups.h"

namespace plumbline::reports {

namespace {

void add_surfels(std::vector<AblationCase>& cases) {
    for (const int surfels : {64, 128, 256}) {
        ddgi::DdgiOptions options = with_model("conserving");
        options.surfels = surfels;
        cases.push_back(make_case("Conserving, the default", fmt::format("conserving-{}", surfels),
                                  fmt::format("conserving, {} surfels a probe", surfels), options));
    }
}

/// A choice of conserving other than the default's.
struct Choice {
    const char* name;
    const char* title;
    void (*make)(ddgi::DdgiOptions& options);
};

template <ddgi::Storage storage>
void keep_as(ddgi::DdgiOptions& options) {
    options.probes.storage = storage;
}

constexpr std::array<Choice, 15> choices{
    {{"octants", "means of octants in place of all rays", keep_as<ddgi::Storage::Octants>},
     {"equal32", "means of 32 equal solid angles", keep_as<ddgi::Storage::Equal32>},
     {"equal128", "means of 128 equal solid angles", keep_as<ddgi::Storage::Equal128>},
     {"sh2", "spherical harmonics of order 2", keep_as<ddgi::Storage::Sh2>},
     {"sh3", "spherical harmonics of order 3", keep_as<ddgi::Storage::Sh3>},
     {"octahedral", "octahedral maps of irradiance", keep_as<ddgi::Storage::Octahedral>},
     {"weights-none", "trilinear weights alone",
      [](ddgi::DdgiOptions& options) { options.probes.weights = ddgi::ProbeWeights::None; }},
     {"weights-backface", "probes behind the surface fade, unseen ones count",
      [](ddgi::DdgiOptions& options) { options.probes.weights = ddgi::ProbeWeights::Backface; }},
     {"weights-moments", "visibility by moments of distance",
      [](ddgi::DdgiOptions& options) { options.probes.weights = ddgi::ProbeWeights::Moments; }},
     {"normal-bias", "biased a tenth of a spacing along the normal",
      [](ddgi::DdgiOptions& options) { options.probes.normal_bias = .1f; }},
     {"skip-inside", "probes in something skipped",
      [](ddgi::DdgiOptions& options) { options.probes.skip_inside = true; }},
     {"no-parallax", "no parallax",
      [](ddgi::DdgiOptions& options) { options.probes.parallax = false; }},
     {"no-shift", "the same rays at every probe",
      [](ddgi::DdgiOptions& options) { options.probes.shifted = false; }},
     {"feedback-rays", "surfels gather from all rays",
      [](ddgi::DdgiOptions& options) { options.probes.feedback = ddgi::Feedback::Rays; }},
     {"edges-4", "four samples on edges",
      [](ddgi::DdgiOptions& options) { options.edge_samples = 4; }}}};

void add_choices(std::vector<AblationCase>& cases) {
    for (const Choice& choice : choices) {
        ddgi::DdgiOptions options = with_model("conserving");
        choice.make(options);
        cases.push_back(make_case("Conserving, one choice changed", choice.name,
                                  std::string("conserving, ") + choice.title, options));
    }
}

/// Widths of cells, in spacings, in which surfels share light.
constexpr std::array<double, 4> shares{.125, .25, .5, 1.};

void add_shares(std::vector<AblationCase>& cases) {
    for (const double share : shares) {
        ddgi::DdgiOptions options = with_model("conserving");
        options.share = share;
        cases.push_back(make_case(
            "Conserving, surfels that share their light", fmt::format("share-{}", 1000. * share),
            fmt::format("conserving, light shared in cells {} spacings wide", share), options));
    }
}

}  // namespace

std::vector<AblationCase> conserving_cases() {
    std::vector<AblationCase> cases;
    add_surfels(cases);
    add_choices(cases);
    add_shares(cases);
    return cases;
}

}  // namespace plumbline::reports
