// SPDX-License-Identifier: Apache-2.0
#include "ddgi/model.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "ddgi/conserving_model.h"
#include "ddgi/irradiance_model.h"
#include "ddgi/rays_model.h"
#include "ddgi/steps_model.h"
#include "ddgi/thesis_model.h"
#include "scenes/errors.h"
#include "scenes/nearest_name.h"

namespace plumbline::ddgi {
namespace {

void refuse_constants(const std::string& model, const std::map<std::string, double>& set) {
    if (set.empty()) return;
    throw UsageError("--set " + set.begin()->first,
                     fmt::format("the model {} has no constants to set", model),
                     "leave --set out, or give --model thesis or --model irradiance");
}

ModelSetup make_thesis(const Scene& scene, const ProbeGrid& grid,
                       const std::map<std::string, double>& set) {
    ModelSetup setup;
    const ThesisConstants constants = thesis_constants(scene, grid, set, setup.notes);
    setup.model = std::make_unique<ThesisModel>(constants, grid);
    const bool emits = std::ranges::any_of(scene.materials, [](const Material& material) {
        return material.emission != Spectrum(0.f);
    });
    if (emits || scene.environment != Spectrum(0.f)) {
        setup.notes.emplace_back(
            "the model thesis takes light from point lights only; emission and environment are "
            "seen, but light nothing");
    }
    return setup;
}

std::unique_ptr<ProbeModel> make_conserving(const ProbeGrid& grid, const ProbeOptions& options) {
    if (options.storage == Storage::Rays) return std::make_unique<RaysModel>(grid, options);
    return std::make_unique<ConservingModel>(grid, options);
}

}  // namespace

Spectrum ProbeModel::emitted_light(const ReceiverPoint&) const { return Spectrum(0.f); }

Spectrum ProbeModel::ambient(const Spectrum&) const { return Spectrum(0.f); }

std::map<std::string, double> ProbeModel::constants() const { return {}; }

RayPattern ProbeModel::turned_pattern(int surfels, int) const { return pattern(surfels); }

void ProbeModel::take_world(const RayTracer&, const SurfelCache&, const Motion*) {}

std::vector<std::string> model_names() { return {"conserving", "irradiance", "thesis"}; }

ModelSetup make_model(const std::string& name, const Scene& scene, const ProbeGrid& grid,
                      const std::map<std::string, double>& set, const ProbeOptions& options) {
    if (name == "thesis") return make_thesis(scene, grid, set);
    if (name == "steps") return make_steps(scene, grid, set);
    if (name == "irradiance") {
        return {std::make_unique<IrradianceModel>(grid, irradiance_settings(set), options.shifted),
                {}};
    }
    if (name == "conserving") {
        refuse_constants(name, set);
        return {make_conserving(grid, options), {}};
    }
    std::vector<std::string> names = model_names();
    names.emplace_back("steps");
    throw UsageError("--model",
                     fmt::format("there is no model '{}' among {}", name, fmt::join(names, ", ")),
                     did_you_mean(name, names));
}

}  // namespace plumbline::ddgi
