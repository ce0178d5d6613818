// SPDX-License-Identifier: Apache-2.0
// Energy: throughput of zero, albedo 0 and 1, a thousand bounces, feedback at its limit.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "reports/hard_case.h"
#include "reports/hard_scenes.h"

namespace plumbline::reports {
namespace {

/// Green light on blue walls: throughput is exactly zero after the first surface.
void nothing_left(Trial& trial) {
    Scene scene = closed_room({0.f, 0.f, 1.f});
    add_point_light(scene, {.2f, .3f, 0.f}, {0.f, 1.f, 0.f});
    const auto truth = trial.truth(scene, 0, {.spp = 64});
    trial.within(Trial::pathtracer, "mean radiance", mean_radiance(truth.image), 0., 0.);
    for (const std::string& model : ddgi::model_names()) {
        ddgi::DdgiOptions options;
        if (model == "thesis") options.set["ambient"] = 0.;
        trial.within(model, "mean radiance",
                     mean_radiance(trial.probes(scene, model, 0, options).image), 0., 0.);
    }
}

void black_walls(Trial& trial) {
    Scene scene = lit_room();
    for (Material& material : scene.materials) material.albedo = Spectrum(0.f);
    const auto truth = trial.truth(scene, 0, {.spp = 16});
    trial.within(Trial::pathtracer, "mean radiance", mean_radiance(truth.image), 0., 0.);
    for (const std::string& model : ddgi::model_names()) {
        if (model == "thesis") {
            trial.probes(scene, model);  // it adds probe light whatever the receiver's albedo
            continue;
        }
        trial.within(model, "mean radiance", mean_radiance(trial.probes(scene, model).image), 0.,
                     0.);
    }
}

/// Walls that absorb nothing, lit by their own glow: seen, lighting directly, and k bounces.
void white_walls(Trial& trial, int bounces) {
    const Scene scene = closed_room(Spectrum(1.f), Spectrum(1.f));
    const auto truth = trial.truth(scene, 0, {.spp = 64, .max_bounces = bounces});
    const double expected = bounces + 2.;
    trial.near(Trial::pathtracer, fmt::format("mean radiance after {} bounces", bounces),
               mean_radiance(truth.image), expected,
               5. * mean_error(truth.image) + 1e-5 * expected);
}

/// The series of a thousand bounces, where roulette ends all but a few paths long before.
void a_thousand_bounces(Trial& trial) {
    const Scene scene = closed_room(Spectrum(.9f), Spectrum(1.f));
    const auto truth = trial.truth(scene, 0, {.spp = 64, .max_bounces = 1000});
    const double expected = (1. - std::pow(.9, 1002)) / (1. - .9);
    trial.near(Trial::pathtracer, "mean radiance after 1000 bounces", mean_radiance(truth.image),
               expected, 5. * mean_error(truth.image));
}

/// Without a bound on bounces roulette must end each path, though nothing absorbs.
void endless_light(Trial& trial, float albedo) {
    const Scene scene = closed_room(Spectrum(albedo), Spectrum(1.f));
    const auto truth = trial.truth(scene, 0, {.spp = 16});
    const double paths = double(truth.spp) * double(truth.image.pixels());
    // Five sure scatterings and 1 / (1 - .95) more in the mean: 25 rays; 40 leaves room for chance.
    trial.within(Trial::pathtracer, "rays a path", double(truth.rays) / paths, 1., 40.);
    for (const std::string& model : ddgi::model_names()) {
        if (model == "thesis") continue;  // its feedback has a constant of its own
        const auto probes = trial.probes(scene, model);
        const double limit = albedo < 1.f ? 1. / (1. - double(albedo)) : 1e30;
        // Each update adds at most 1: a thousand of them are far from the limit, and must say so.
        trial.claim(model, "says that it did not converge", !probes.figures.converged);
        trial.within(model, "mean radiance after all its updates", mean_radiance(probes.image), 1.,
                     std::min(limit, 2. + double(probes.figures.updates)));
    }
}

/// The limit emission / (1 - albedo), where each update closes only a hundredth of what is left.
void slow_convergence(Trial& trial) {
    constexpr double albedo = .99;
    const Scene scene = closed_room(Spectrum(float(albedo)), Spectrum(1.f));
    const double expected = 1. / (1. - albedo);
    const auto truth = trial.truth(scene, 0, {.spp = 256});
    trial.near(Trial::pathtracer, "mean radiance", mean_radiance(truth.image), expected,
               5. * mean_error(truth.image));
    for (const std::string& model : ddgi::model_names()) {
        if (model == "thesis") continue;
        const auto probes = trial.probes(scene, model);
        trial.claim(model, "converges", probes.figures.converged);
        // Changes of 1e-4 a step leave albedo / (1 - albedo) times as much to come.
        trial.near(model, "mean radiance", mean_radiance(probes.image), expected,
                   expected * 1.1e-4 * albedo / (1. - albedo));
    }
}

/// The spectral radius of the thesis's feedback, with this multiBounceIntensity.
ddgi::DdgiResult feedback(Trial& trial, double intensity) {
    ddgi::DdgiOptions options;
    options.set["multiBounceIntensity"] = intensity;
    options.updates = 400;
    options.spectral_radius = true;
    return trial.probes(lit_room(), "thesis", 0, options);
}

void weak_feedback(Trial& trial) {
    const auto probes = feedback(trial, .1);
    trial.within("thesis", "spectral radius", probes.spectral_radius.value(), 0., 1.);
    trial.claim("thesis", "converges", probes.figures.converged);
}

/// A thousandth to either side of the constant where the probes feed each other what they lose.
void feedback_at_its_limit(Trial& trial) {
    const double critical = feedback(trial, 1e4).critical_multi_bounce.value();
    const auto below = feedback(trial, .999 * critical);
    trial.within("thesis", "spectral radius a thousandth below", below.spectral_radius.value(), .99,
                 1.);
    trial.claim("thesis", "no warning a thousandth below", !below.critical_multi_bounce);
    const auto above = feedback(trial, 1.001 * critical);
    trial.within("thesis", "spectral radius a thousandth above", above.spectral_radius.value(), 1.,
                 1.01);
    trial.claim("thesis", "a warning a thousandth above", above.critical_multi_bounce.has_value());
}

}  // namespace

void add_energy_cases(std::vector<HardCase>& cases) {
    cases.push_back({"energy", "green light on blue walls", "black to the bit", nothing_left});
    cases.push_back({"energy", "albedo 0", "black to the bit", black_walls});
    cases.push_back({"energy", "albedo 1, 16 bounces",
                     "k bounces of a glow of 1 bring k + 2, within 5 standard errors",
                     [](Trial& t) { white_walls(t, 16); }});
    cases.push_back(
        {"energy", "a thousand bounces", "the geometric series of albedo 0.9", a_thousand_bounces});
    for (const float albedo : {1.f - 1e-7f, 1.f}) {
        cases.push_back({"energy", fmt::format("albedo {:.8g}, bounces without end", albedo),
                         "paths end in 25 rays or so; probes grow by 1 an update and say so",
                         [=](Trial& t) { endless_light(t, albedo); }});
    }
    cases.push_back({"energy", "albedo 0.99", "emission / (1 - albedo) = 100", slow_convergence});
    cases.push_back({"energy", "the thesis's feedback, weak", "converges", weak_feedback});
    cases.push_back({"energy", "the thesis's feedback, at its limit",
                     "spectral radius below 1 a thousandth below, above 1 a thousandth above",
                     feedback_at_its_limit});
}

}  // namespace plumbline::reports
