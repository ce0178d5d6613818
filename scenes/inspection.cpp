// SPDX-License-Identifier: Apache-2.0
#include "scenes/inspection.h"

#include <map>

#include "scenes/effects.h"
#include "scenes/world.h"

namespace plumbline {
namespace {

struct KindOf {
    std::string operator()(std::monostate) const { return "group"; }
    std::string operator()(const Box&) const { return "box"; }
    std::string operator()(const Quad&) const { return "quad"; }
    std::string operator()(const Sphere&) const { return "sphere"; }
    std::string operator()(const MeshInstance&) const { return "mesh"; }
};

OrderedJson bounds_json(const Bounds& bounds) {
    if (bounds.empty()) return nullptr;
    return {{"lower", shortest(bounds.lower)}, {"upper", shortest(bounds.upper)}};
}

OrderedJson objects_json(const Scene& scene, const World& world) {
    std::map<int, std::size_t> triangles;
    for (const WorldMesh& mesh : world.meshes) triangles[mesh.object] = mesh.triangles.size();
    OrderedJson list = OrderedJson::array();
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        list.push_back({{"name", object.name},
                        {"kind", std::visit(KindOf(), object.shape)},
                        {"triangles", triangles[static_cast<int>(i)]},
                        {"bounds", bounds_json(world.objects[i].bounds)},
                        {"animated", !object.animation.empty()}});
    }
    return list;
}

OrderedJson probes_json(const Scene& scene) {
    const ProbeGrid grid = probe_grid(scene);
    return {{"origin", shortest(grid.origin)},
            {"spacing", shortest(grid.spacing)},
            {"counts", {grid.counts.x, grid.counts.y, grid.counts.z}},
            {"total",
             std::size_t(grid.counts.x) * std::size_t(grid.counts.y) * std::size_t(grid.counts.z)},
            {"from", scene.probes ? "the scene" : "its bounds: the scene has no grid"}};
}

OrderedJson materials_json(const Scene& scene) {
    OrderedJson list = OrderedJson::array();
    for (const Material& material : scene.materials) {
        list.push_back({{"name", material.name},
                        {"albedo", shortest(material.albedo)},
                        {"emission", shortest(material.emission)},
                        {"two_sided", material.two_sided}});
    }
    return list;
}

}  // namespace

OrderedJson effects_json(const Scene& scene, bool simulated) {
    OrderedJson list = OrderedJson::array();
    for (const EffectReason& reason : effect_reasons(scene)) {
        if (reason.simulated != simulated) continue;
        list.push_back({{"effect", reason.effect}, {"why", reason.why}});
    }
    if (simulated) return list;
    for (const std::string& line : scene.not_simulated) {
        list.push_back(
            {{"effect", line}, {"why", "the file asks for it, but it is not supported"}});
    }
    return list;
}

OrderedJson inspection(const Scene& scene, int frame) {
    const World world = world_at(scene, frame);
    const OrderedJson settings = settings_json(scene);
    return {{"name", scene.name},
            {"description", scene.description},
            {"units", scene.length_unit},
            {"frame", frame},
            {"frames", scene.frames},
            {"frames_per_second", shortest(scene.frames_per_second)},
            {"triangles", world.triangle_count()},
            {"spheres", world.spheres.size()},
            {"bounds", bounds_json(world.bounds())},
            {"objects", objects_json(scene, world)},
            {"materials", materials_json(scene)},
            {"lights", settings.at("lights")},
            {"environment", settings.at("environment")},
            {"camera", settings.at("camera")},
            {"probes", probes_json(scene)},
            {"thesis", scene.thesis ? settings.at("thesis") : OrderedJson(nullptr)},
            {"effects", effects_json(scene, true)},
            {"skipped", effects_json(scene, false)},
            {"warnings", scene_warnings(scene, world)}};
}

}  // namespace plumbline
