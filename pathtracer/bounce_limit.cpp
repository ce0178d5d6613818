// SPDX-License-Identifier: Apache-2.0
#include "pathtracer/bounce_limit.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "pathtracer/lights.h"
#include "scenes/nearest_point.h"

namespace plumbline::pathtracer {
namespace {

/// The largest albedo and emission of any surface, by channel.
struct Surfaces {
    glm::dvec3 albedo{0.};
    glm::dvec3 emission{0.};

    void add(const Material& material) {
        // Textures and vertex colours multiply it by 1 at most.
        albedo = glm::max(albedo, glm::dvec3(material.albedo));
        emission = glm::max(emission, glm::dvec3(material.emission));
    }
};

Surfaces surfaces_of(const World& world) {
    Surfaces surfaces;
    for (const WorldMesh& mesh : world.meshes) {
        for (const int material : mesh.triangle_materials) {
            surfaces.add(world.materials[std::size_t(material)]);
        }
    }
    for (const WorldSphere& sphere : world.spheres) {
        surfaces.add(world.materials[std::size_t(sphere.material)]);
    }
    return surfaces;
}

/// Irradiance, at most, that all lights together bring anywhere; infinite if one touches a surface.
glm::dvec3 largest_irradiance(const World& world) {
    glm::dvec3 E(0.);
    for (const PointLight& light : world.lights) {
        if (light.falloff == Falloff::None) {
            E += glm::pi<double>() * glm::dvec3(light.white_radiance);
        } else if (light.intensity != Spectrum(0.f)) {
            // Nothing is lit inside a ball.
            const double d = std::max(distance_to_surfaces(world, light.position),
                                      static_cast<double>(light.radius));
            E += glm::dvec3(light.intensity) / (d * d);
        }
    }
    for (const DirectionalLight& light : world.directional_lights) {
        E += glm::dvec3(light.irradiance);
    }
    return E;
}

/// Radiance, at most, that a ray from the scene finds in the environment.
glm::dvec3 largest_environment(const World& world, Effects effects) {
    if (!has(effects, Effect::Environment)) return glm::dvec3(0.);
    glm::dvec3 L(world.environment);
    if (!world.environment_image) return L;
    glm::dvec3 brightest(0.);
    for (const Spectrum& pixel : world.environment_image->panorama->radiance) {
        brightest = glm::max(brightest, glm::dvec3(pixel));
    }
    return L * brightest;
}

/// Scatterings past which the bound on what is left is below `relmse`; none if there is no bound.
std::optional<double> scatterings_to(double relmse, const glm::dvec3& rho, const glm::dvec3& R1) {
    constexpr double epsilon = .01;  // of relMSE's definition
    // The mean over channels is below it if each channel is.
    const double R = std::sqrt(relmse * epsilon);
    double most = 1.;
    for (int c = 0; c < 3; ++c) {
        if (R1[c] == 0.) continue;
        if (!(rho[c] < 1. && std::isfinite(R1[c]))) return std::nullopt;
        most = std::max(most, std::ceil(std::log(R * (1. - rho[c]) / R1[c]) / std::log(rho[c])));
    }
    return most;
}

}  // namespace

BounceLimit bounce_limit(const World& world, Effects effects, const RenderOptions& options) {
    if (options.max_bounces) return {options.max_bounces, "asked for"};
    if (!options.target_relmse) {
        return {std::nullopt,
                "Russian roulette ends paths: without --target-relmse no light is too "
                "little to count"};
    }
    constexpr std::size_t most_distances = 20'000'000;
    if (world.lights.size() * world.triangle_count() > most_distances) {
        return {std::nullopt,
                "Russian roulette ends paths: too many lights and triangles to bound "
                "what is left"};
    }
    const Surfaces surfaces = surfaces_of(world);
    const glm::dvec3 rho = surfaces.albedo;
    const glm::dvec3 arriving = glm::max(surfaces.emission, largest_environment(world, effects));
    const glm::dvec3 R1 = rho * (largest_irradiance(world) / glm::pi<double>() + arriving);
    constexpr double share = .01;  // of the relMSE: a tenth of the RMSE
    const auto scatterings = scatterings_to(share * *options.target_relmse, rho, R1);
    const double lightest = std::max({rho.x, rho.y, rho.z});
    if (!scatterings) {
        return {std::nullopt,
                fmt::format("Russian roulette ends paths: albedo of up to {:.3g}, or a light on a "
                            "surface, leaves no bound",
                            lightest)};
    }
    const double bounces = *scatterings - 1.;
    if (bounces > longest_without_roulette) {
        return {std::nullopt,
                fmt::format("Russian roulette ends paths: with albedo of up to {:.3g} "
                            "only {} bounces are sure to be enough",
                            lightest, bounces)};
    }
    return {static_cast<int>(bounces),
            fmt::format("with albedo of up to {:.3g} all that is left adds a tenth of the "
                        "requested error at most",
                        lightest)};
}

}  // namespace plumbline::pathtracer
