// SPDX-License-Identifier: Apache-2.0
#include "compare/energy_audit.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <random>

#include "compare/surface_points.h"
#include "ddgi/direct_light.h"
#include "ddgi/volume.h"

namespace plumbline::compare {

namespace {

/// Rays that gather E at a point.
constexpr int rays_per_point = 64;

/// What a probe model shows bounce by bounce.
struct Generations {
    ddgi::ProbeVolume volume;
    std::vector<std::vector<float>> values;  ///< of the probes: of bounces 1, 2, ...

    Generations(const Scene& scene, int frame, const ddgi::DdgiOptions& options, int bounces)
        : volume(scene, options) {
        volume.move_to(frame);
        std::vector<float> before(volume.values().size(), 0.f);
        for (int k = 0; k < bounces; ++k) {
            if (options.model == "thesis" && k == 0)
                volume.converge();
            else if (options.model != "thesis")
                volume.update();
            std::vector<float> light(volume.values().begin(), volume.values().end());
            for (std::size_t i = 0; i < light.size(); ++i) light[i] -= before[i];
            before.assign(volume.values().begin(), volume.values().end());
            values.push_back(std::move(light));
        }
    }

    /// Radiance that a surface shows of a bounce.
    Spectrum shown(int bounce, const SurfacePoint& point) const {
        const auto receiver = volume.receiver(point.position, point.n, point.albedo);
        if (bounce > 0)
            return volume.model().probe_light(values[std::size_t(bounce - 1)], receiver);
        const auto light = ddgi::direct_light(volume.tracer(), point.position, point.n);
        return point.emission + point.albedo / glm::pi<float>() * light.irradiance;
    }
};

/// Per point, and for bounces 0, 1, ...: irradiance that arrived, and what left, mean over
/// channels.
struct PointEnergy {
    bool sees_surface = false;
    std::vector<double> arriving, absorbed, shown;
};

double channel_mean(const Spectrum& s) { return double(s.r + s.g + s.b) / 3; }

PointEnergy measure(const Generations& model, const SurfacePoint& point, unsigned seed) {
    const RayTracer& tracer = model.volume.tracer();
    const int bounces = int(model.values.size());
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform;
    std::vector<Spectrum> E(std::size_t(bounces) + 1, Spectrum(0.f));
    PointEnergy energy;
    for (int ray = 0; ray < rays_per_point; ++ray) {
        // One coordinate stratified: the rays' noise is not what the audit is about.
        const float u = (float(ray) + uniform(random)) / rays_per_point;
        const glm::vec3 wi = cosine_direction({u, uniform(random)}, point.n);
        const auto hit = tracer.intersect({point.position, wi}, BackFaces::Hit);
        if (!hit) E[1] += environment_radiance(tracer.world(), wi);
        const bool two_sided =
            hit && tracer.world().materials[std::size_t(hit->material)].two_sided;
        if (!hit || (hit->back && !two_sided)) continue;
        energy.sees_surface = true;
        const SurfacePoint from{offset_origin(*hit, hit->n()), hit->n(), hit->albedo,
                                tracer.world().materials[std::size_t(hit->material)].emission};
        for (int k = 1; k <= bounces; ++k) E[std::size_t(k)] += model.shown(k - 1, from);
    }
    for (int k = 0; k <= bounces; ++k) {
        const Spectrum irradiance = glm::pi<float>() / rays_per_point * E[std::size_t(k)];
        energy.arriving.push_back(channel_mean(irradiance));
        energy.absorbed.push_back(channel_mean((1.f - point.albedo) * irradiance));
        energy.shown.push_back(channel_mean(glm::pi<float>() * model.shown(k, point)));
    }
    return energy;
}

BounceEnergy sum_bounce(const std::vector<PointEnergy>& points, std::size_t k, double area) {
    BounceEnergy sum{int(k), 0, 0, 0, 0, 0, 0};
    double squares = 0, n = 0;
    for (const PointEnergy& point : points) {
        if (!point.sees_surface) continue;
        const double reflected = point.arriving[k] - point.absorbed[k];
        const double invented = point.shown[k] - reflected;
        sum.arriving += area * point.arriving[k];
        sum.absorbed += area * point.absorbed[k];
        sum.reflected += area * reflected;
        sum.shown += area * point.shown[k];
        sum.invented += area * invented;
        squares += invented * invented;
        n += 1;
    }
    if (n > 1) {
        const double mean = sum.invented / area / n;
        sum.standard_error =
            area * std::sqrt(std::max(0.0, squares - n * mean * mean) * n / (n - 1));
    }
    return sum;
}

}  // namespace

EnergyAudit energy_audit(const Scene& scene, int frame, const ddgi::DdgiOptions& asked, int bounces,
                         int points) {
    ddgi::DdgiOptions options = asked;
    if (options.model == "thesis") options.set["multiBounceIntensity"] = 0;
    const Generations model(scene, frame, options, bounces);
    const SurfacePoints surface = surface_points(model.volume.tracer(), points);
    std::vector<PointEnergy> energies(surface.points.size());
    tbb::parallel_for(std::size_t(0), energies.size(), [&](std::size_t i) {
        energies[i] = measure(model, surface.points[i], unsigned(i));
    });
    EnergyAudit audit;
    audit.scene = scene.name;
    audit.model = options.model;
    audit.frame = frame;
    audit.unseen_area = surface.covered_area;
    for (std::size_t i = 0; i < energies.size(); ++i) {
        (energies[i].sees_surface ? audit.area : audit.unseen_area) += surface.area;
        if (energies[i].sees_surface)
            audit.ambient +=
                surface.area * channel_mean(glm::pi<float>() *
                                            model.volume.model().ambient(surface.points[i].albedo));
    }
    audit.direct = sum_bounce(energies, 0, surface.area).shown;
    for (int k = 1; k <= bounces; ++k)
        audit.bounces.push_back(sum_bounce(energies, std::size_t(k), surface.area));
    return audit;
}

nlohmann::ordered_json to_json(const EnergyAudit& audit) {
    auto bounces = nlohmann::ordered_json::array();
    for (const BounceEnergy& one : audit.bounces)
        bounces.push_back({{"bounce", one.bounce},
                           {"arriving", one.arriving},
                           {"absorbed", one.absorbed},
                           {"reflected", one.reflected},
                           {"shown", one.shown},
                           {"invented", one.invented},
                           {"standard_error", one.standard_error}});
    return {{"scene", audit.scene},
            {"frame", audit.frame},
            {"model", audit.model},
            {"area", audit.area},
            {"unseen_area", audit.unseen_area},
            {"direct", audit.direct},
            {"ambient", audit.ambient},
            {"bounces", bounces}};
}

std::string to_text(const EnergyAudit& audit) {
    std::string text = fmt::format(
        "{} {}, model {}: flux in W over {:.4g} of surface; {:.3g} that sees none left out\n"
        "direct and emitted {:.5g}, ambient invented {:.5g}\n"
        "{:>6} {:>11} {:>11} {:>11} {:>11} {:>11} {:>9}  {}\n",
        audit.scene, audit.frame, audit.model, audit.area, audit.unseen_area, audit.direct,
        audit.ambient, "bounce", "arriving", "absorbed", "to reflect", "shown", "invented", "+-",
        "of what should be reflected");
    for (const BounceEnergy& one : audit.bounces)
        text += fmt::format(
            "{:>6} {:>11.5g} {:>11.5g} {:>11.5g} {:>11.5g} {:>11.4g} {:>9.2g}  {}\n", one.bounce,
            one.arriving, one.absorbed, one.reflected, one.shown, one.invented, one.standard_error,
            one.reflected > 0 ? fmt::format("{:+.1f} %", 100 * one.invented / one.reflected) : "-");
    return text;
}

}  // namespace plumbline::compare
