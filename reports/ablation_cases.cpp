// SPDX-License-Identifier: Apache-2.0
#include "reports/ablation_cases.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "scenes/errors.h"
#include "scenes/nearest_name.h"

namespace plumbline::reports {

namespace {

/// A step of the model `steps`, in the order in which the road takes them.
struct Step {
    const char* constant;
    const char* name;
    const char* title;
};

constexpr std::array<Step, 6> steps{
    {{"receiverAlbedo", "receiver-albedo", "receiver albedo"},
     {"solidAngle", "solid-angle", "solid angle instead of cosine over squared distance"},
     {"octantLookUp", "octant-look-up", "octants integrated at the look-up, no constants"},
     {"evenRays", "even-rays", "rays of equal solid angle"},
     {"firstSurface", "first-surface", "rays to the first surface"},
     {"multiBounce", "multi-bounce", "multiple bounces"}}};

template <typename Choice>
const std::string& name_of(const std::map<std::string, Choice>& names, Choice choice) {
    return std::ranges::find(names, choice, [](const auto& named) { return named.second; })->first;
}

/// What `plumbline ddgi` is told for the choices of conserving that are not the default.
std::string choices_text(const ddgi::DdgiOptions& options) {
    const ddgi::ProbeOptions& chosen = options.probes;
    const ddgi::ProbeOptions usual;
    std::string text;
    if (chosen.storage != usual.storage)
        text += " --storage " + name_of(ddgi::storage_names, chosen.storage);
    if (chosen.weights != usual.weights)
        text += " --weights " + name_of(ddgi::weights_names, chosen.weights);
    if (chosen.feedback != usual.feedback)
        text += " --feedback " + name_of(ddgi::feedback_names, chosen.feedback);
    if (!chosen.shifted) text += " --no-shift";
    if (!chosen.parallax) text += " --no-parallax";
    if (chosen.normal_bias != usual.normal_bias)
        text += fmt::format(" --normal-bias {}", chosen.normal_bias);
    if (chosen.skip_inside) text += " --skip-inside";
    if (options.edge_samples) text += fmt::format(" --edge-samples {}", *options.edge_samples);
    return text;
}

AblationCase make_case(const std::string& group, const std::string& name, const std::string& title,
                       const ddgi::DdgiOptions& options) {
    std::string text = "--model " + options.model;
    if (options.surfels != ddgi::DdgiOptions{}.surfels)
        text += fmt::format(" --surfels {}", options.surfels);
    for (const auto& [constant, value] : options.set)
        text += fmt::format(" --set {}={}", constant, value);
    return {group, name, title, text + choices_text(options), options};
}

ddgi::DdgiOptions with_model(const std::string& model) {
    ddgi::DdgiOptions options;
    options.model = model;
    return options;
}

/// Each step on top of those before it.
void add_road(std::vector<AblationCase>& cases) {
    const std::string group = "From the thesis to conserving, a step at a time";
    cases.push_back(make_case(group, "thesis", "thesis as published", with_model("thesis")));
    ddgi::DdgiOptions options = with_model("steps");
    for (const Step& step : steps) {
        options.set[step.constant] = 1;
        cases.push_back(make_case(group, std::string("road-") + step.name,
                                  std::string("+ ") + step.title, options));
    }
}

void add_single_steps(std::vector<AblationCase>& cases) {
    for (const Step& step : steps) {
        ddgi::DdgiOptions options = with_model("steps");
        options.set[step.constant] = 1;
        cases.push_back(make_case("One step alone from the thesis",
                                  std::string("only-") + step.name,
                                  std::string("thesis, ") + step.title, options));
    }
}

/// All other steps taken, what a ray brings that meets nothing within a cell.
void add_propagation(std::vector<AblationCase>& cases) {
    const std::string group = "Where rays of one cell look that meet nothing";
    ddgi::DdgiOptions options = with_model("steps");
    for (const Step& step : steps)
        if (std::string(step.constant) != "firstSurface") options.set[step.constant] = 1;
    cases.push_back(
        make_case(group, "pass-thesis", "a share of the neighbour, inward at borders", options));
    const auto add = [&](const char* constant, const char* name, const char* title) {
        ddgi::DdgiOptions other = options;
        other.set[constant] = 1;
        cases.push_back(make_case(group, name, title, other));
    };
    add("diagonalNeighbour", "pass-diagonal", "the neighbour on the diagonal, whole");
    add("gridAtEnd", "pass-grid", "the grid where the ray ends");
}

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

/// As published, but for rays that turn: a still has no need of memory, without which they need
/// not.
const std::map<std::string, double> published_at_rest{
    {"published", 1}, {"turnedRays", 0}, {"hysteresis", 0}};

/// Something that the published probes of irradiance do and the model leaves out, or the reverse.
struct Departure {
    const char* name;
    const char* title;
    std::map<std::string, double> set;
};

const std::vector<Departure>& departures() {
    static const std::vector<Departure> all{
        {"wrap", "probes behind the surface fade", {{"wrapShading", 1}}},
        {"contrast", "visibility cubed", {{"visibilityPower", 3}}},
        {"crush", "small weights crushed", {{"crushThreshold", .2}}},
        {"bias", "biased along normal and view", {{"normalBias", .045}, {"viewBias", .18}}},
        {"gamma", "roots of irradiance blended", {{"perceptualGamma", 5}}},
        {"energy", "surfels take in 95 %", {{"energyPreservation", .95}}},
        {"backs", "backs are black", {{"blackBacks", 1}}},
        {"inside", "probes in something skipped", {{"skipInside", 1}}},
        {"published", "all of these", published_at_rest},
        {"blind", "no visibility", {{"chebyshev", 0}}},
        {"blurred", "blurred distances", {{"depthSharpness", 1}}}};
    return all;
}

/// The peer, without a bias and with each of its own.
void add_irradiance(std::vector<AblationCase>& cases) {
    const std::string group = "Irradiance maps with moments of distance";
    ddgi::DdgiOptions options = with_model("irradiance");
    cases.push_back(make_case(group, "irradiance", "irradiance", options));
    for (const Departure& departure : departures()) {
        options.set = departure.set;
        cases.push_back(make_case(group, std::string("irradiance-") + departure.name,
                                  std::string("irradiance, ") + departure.title, options));
    }
}

}  // namespace

std::vector<AblationCase> ablation_cases() {
    std::vector<AblationCase> cases;
    add_road(cases);
    add_single_steps(cases);
    add_propagation(cases);
    add_surfels(cases);
    add_choices(cases);
    add_irradiance(cases);
    return cases;
}

std::vector<AblationCase> ablation_cases(const std::vector<std::string>& names) {
    std::vector<AblationCase> cases = ablation_cases();
    std::vector<std::string> known;
    for (const AblationCase& one : cases) known.push_back(one.name);
    for (const std::string& name : names) {
        if (std::ranges::find(known, name) != known.end()) continue;
        throw UsageError("--only", fmt::format("there is no case '{}'", name),
                         did_you_mean(name, known));
    }
    std::erase_if(cases, [&](const AblationCase& one) {
        return std::ranges::find(names, one.name) == names.end();
    });
    return cases;
}

std::vector<AblationCase> leak_cases() {
    const std::string group = "Leak";
    std::vector<AblationCase> cases{
        make_case(group, "thesis", "thesis as published", with_model("thesis"))};
    ddgi::DdgiOptions irradiance = with_model("irradiance");
    cases.push_back(make_case(group, "irradiance", "irradiance", irradiance));
    irradiance.set = published_at_rest;
    cases.push_back(
        make_case(group, "irradiance-published", "irradiance as published", irradiance));
    const auto add = [&](ddgi::Storage storage, ddgi::ProbeWeights weights) {
        ddgi::DdgiOptions options = with_model("conserving");
        options.probes.storage = storage;
        options.probes.weights = weights;
        const std::string& keeps = name_of(ddgi::storage_names, storage);
        const std::string& counts = name_of(ddgi::weights_names, weights);
        cases.push_back(make_case(group, fmt::format("{}-{}", keeps, counts),
                                  fmt::format("conserving, {}, weights: {}", keeps, counts),
                                  options));
    };
    for (const auto& [storage_name, storage] : ddgi::storage_names) {
        // How light is kept by direction hardly matters for what passes a wall.
        if (storage != ddgi::Storage::Rays && storage != ddgi::Storage::Octants) {
            add(storage, ddgi::ProbeOptions{}.weights);
            continue;
        }
        for (const auto& [weights_name, weights] : ddgi::weights_names) add(storage, weights);
    }
    return cases;
}

}  // namespace plumbline::reports
