// SPDX-License-Identifier: Apache-2.0
#include "scenes/effects.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/gtc/constants.hpp>
#include <set>

#include "scenes/enclosure.h"
#include "scenes/world.h"

namespace plumbline {
namespace {

bool dark(const Spectrum& power) { return power == Spectrum(0.f); }

bool dark(const PointLight& light) {
    return dark(light.falloff == Falloff::None ? light.white_radiance : light.intensity);
}

bool dark(const DirectionalLight& light) { return dark(light.irradiance); }

Effect kind_of(const PointLight& light) {
    if (light.cone) return Effect::SpotLights;
    return light.radius > 0.f ? Effect::SphereLights : Effect::PointLights;
}

/// The materials on which a ray can land.
std::set<int> materials_in_use(const Scene& scene) {
    std::set<int> used;
    for (const Object& object : scene.objects) {
        if (const auto* box = std::get_if<Box>(&object.shape)) {
            used.insert(box->face_materials.begin(), box->face_materials.end());
        } else if (const auto* quad = std::get_if<Quad>(&object.shape)) {
            used.insert(quad->material);
        } else if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
            used.insert(sphere->material);
        } else if (const auto* instance = std::get_if<MeshInstance>(&object.shape)) {
            const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance->mesh)];
            used.insert(mesh.triangle_materials.begin(), mesh.triangle_materials.end());
        }
    }
    return used;
}

template <typename Predicate>
std::size_t count_materials(const Scene& scene, const Predicate& predicate) {
    const std::set<int> used = materials_in_use(scene);
    return static_cast<std::size_t>(std::count_if(used.begin(), used.end(), [&](int material) {
        return predicate(scene.materials[static_cast<std::size_t>(material)]);
    }));
}

std::size_t shining_lights(const Scene& scene, Effect kind) {
    if (kind == Effect::DirectionalLights) {
        return static_cast<std::size_t>(std::ranges::count_if(
            scene.directional_lights, [](const DirectionalLight& light) { return !dark(light); }));
    }
    return static_cast<std::size_t>(std::ranges::count_if(
        scene.lights,
        [&](const PointLight& light) { return kind_of(light) == kind && !dark(light); }));
}

std::size_t emitting_materials(const Scene& scene) {
    return count_materials(scene, [](const Material& m) { return !dark(m.emission); });
}

/// "1 light", "2 lights".
std::string counted(std::size_t count, const std::string& what, const std::string& plural = "s") {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : plural);
}

EffectReason lights(const Scene& scene, Effect kind, const std::string& name) {
    const std::size_t shining = shining_lights(scene, kind);
    if (shining > 0) return {name + "s", true, counted(shining, name) + " with power"};
    return {name + "s", false, "no " + name + " with power: no shadow ray is traced to one"};
}

/// Up to so many point, sphere and spot lights, a shadow ray to each brings more than it takes, as
/// measured by the benchmark of lights.
constexpr std::size_t few_lights = 8;

EffectReason light_choice(const Scene& scene) {
    const std::string name = "choosing among lights";
    const std::size_t shining = shining_lights(scene, Effect::PointLights) +
                                shining_lights(scene, Effect::SphereLights) +
                                shining_lights(scene, Effect::SpotLights);
    if (shining == 0) return {name, false, "no point, sphere or spot light with power"};
    const std::string count = counted(shining, "point, sphere or spot light");
    if (shining <= few_lights) return {name, false, count + ": each is sampled at every surface"};
    return {name, true,
            count + ": at every surface a tree chooses one, by what it may bring there"};
}

EffectReason emission(const Scene& scene) {
    const std::size_t emitting = emitting_materials(scene);
    if (emitting == 0) {
        return {"emission", false, "no emitter: every surface only reflects"};
    }
    return {"emission", true, counted(emitting, "emitting material") + " in use"};
}

/// Which part of all surface emits, at frame 0.
double emitting_share(const Scene& scene) {
    const World world = world_at(scene, 0);
    double emitting = 0.;
    double all = 0.;
    const auto add = [&](int material, double area) {
        all += area;
        if (!dark(world.materials[std::size_t(material)].emission)) emitting += area;
    };
    for (const WorldMesh& mesh : world.meshes) {
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            const glm::uvec3& t = mesh.triangles[i];
            const glm::dvec3 a(mesh.positions[t.x]);
            add(mesh.triangle_materials[i],
                glm::length(glm::cross(glm::dvec3(mesh.positions[t.y]) - a,
                                       glm::dvec3(mesh.positions[t.z]) - a)) /
                    2.);
        }
    }
    for (const WorldSphere& sphere : world.spheres) {
        add(sphere.material,
            4. * glm::pi<double>() * double(sphere.radius) * double(sphere.radius));
    }
    return all > 0. ? emitting / all : 0.;
}

/// Paths that run into emitters at least every other time need not be aimed at them.
constexpr double found_anyway = .5;

EffectReason emitter_sampling(const Scene& scene) {
    const std::string name = "aiming at emitters";
    if (emitting_materials(scene) == 0) {
        return {name, false, "no emitter: no multiple importance sampling"};
    }
    const double share = emitting_share(scene);
    const std::string of_all = fmt::format("{:.2g} % of all surface emits", 100. * share);
    if (share >= found_anyway) return {name, false, of_all + ": paths find it by themselves"};
    return {name, true, of_all + ": paths aim at it too, by multiple importance sampling"};
}

/// Proven only where it matters: the proof takes time.
Enclosure enclosure_of_environment(const Scene& scene) {
    return dark(scene.environment) ? Enclosure{} : enclosure(scene);
}

EffectReason environment(const Scene& scene, const Enclosure& closed) {
    if (dark(scene.environment)) {
        return {"environment", false, "it is black: rays that leave the scene bring no light"};
    }
    if (closed.proven) return {"environment", false, closed.why};
    return {"environment", true, "it shines on rays that leave the scene; " + closed.why};
}

EffectReason environment_image(const Scene& scene, const Enclosure& closed) {
    const std::string name = "aiming at the environment";
    if (dark(scene.environment)) return {name, false, "it is black"};
    if (!scene.environment_image) {
        return {name, false, "it is alike all around: scattered paths leave in proportion to it"};
    }
    if (closed.proven) return {name, false, "the scene is closed: no ray leaves it"};
    const Panorama& panorama = *scene.environment_image->panorama;
    return {
        name, true,
        fmt::format("a picture of {} x {} pixels: paths aim at the bright ones too, by multiple "
                    "importance sampling",
                    panorama.width, panorama.height)};
}

EffectReason animation(const Scene& scene) {
    const auto moving =
        std::count_if(scene.objects.begin(), scene.objects.end(),
                      [](const Object& object) { return !object.animation.empty(); });
    if (moving == 0) return {"animation", false, "no object has keyframes: all frames are alike"};
    if (scene.frames == 1) return {"animation", false, "the scene has one frame"};
    return {"animation", true,
            counted(static_cast<std::size_t>(moving), "object") + " with keyframes"};
}

EffectReason textures(const Scene& scene) {
    const auto count =
        std::count_if(scene.materials.begin(), scene.materials.end(),
                      [](const Material& material) { return material.texture.has_value(); });
    if (count == 0) return {"textures", false, "no material has one"};
    return {"textures", true,
            fmt::format("{} {} a picture of albedo", count,
                        count == 1 ? "material has" : "materials have")};
}

EffectReason vertex_albedo(const Scene& scene) {
    const auto coloured =
        std::count_if(scene.meshes.begin(), scene.meshes.end(),
                      [](const Mesh& mesh) { return !mesh.vertex_albedo.empty(); });
    if (coloured == 0) return {"vertex colours", false, "no mesh has them"};
    return {"vertex colours", true,
            counted(static_cast<std::size_t>(coloured), "mesh", "es") + " with a colour a vertex"};
}

EffectReason two_sided(const Scene& scene) {
    const std::size_t both = count_materials(scene, [](const Material& m) { return m.two_sided; });
    if (both == 0) {
        return {"two-sided surfaces", false, "every surface is one-sided: backs are black"};
    }
    return {"two-sided surfaces", true, counted(both, "two-sided material") + " in use"};
}

EffectReason interreflection(const Scene& scene) {
    const std::size_t reflecting =
        count_materials(scene, [](const Material& m) { return !dark(m.albedo); });
    if (reflecting == 0) {
        return {"interreflection", false, "no surface reflects: light ends where it falls"};
    }
    return {"interreflection", true, counted(reflecting, "reflecting material") + " in use"};
}

}  // namespace

Effects effects_of(const Scene& scene) {
    const Enclosure closed = enclosure_of_environment(scene);
    Effects effects;
    for (const Effect kind : {Effect::PointLights, Effect::SphereLights, Effect::SpotLights,
                              Effect::DirectionalLights}) {
        if (shining_lights(scene, kind) > 0) effects = effects | kind;
    }
    if (light_choice(scene).simulated) effects = effects | Effect::LightChoice;
    if (emitting_materials(scene) > 0) effects = effects | Effect::Emission;
    if (emitter_sampling(scene).simulated) effects = effects | Effect::EmitterSampling;
    if (environment(scene, closed).simulated) effects = effects | Effect::Environment;
    if (environment_image(scene, closed).simulated) effects = effects | Effect::EnvironmentImage;
    return effects;
}

std::vector<EffectReason> effect_reasons(const Scene& scene) {
    const Enclosure closed = enclosure_of_environment(scene);
    return {lights(scene, Effect::PointLights, "point light"),
            lights(scene, Effect::SphereLights, "sphere light"),
            lights(scene, Effect::SpotLights, "spot light"),
            lights(scene, Effect::DirectionalLights, "directional light"),
            light_choice(scene),
            emission(scene),
            emitter_sampling(scene),
            environment(scene, closed),
            environment_image(scene, closed),
            interreflection(scene),
            two_sided(scene),
            vertex_albedo(scene),
            textures(scene),
            animation(scene)};
}

}  // namespace plumbline
