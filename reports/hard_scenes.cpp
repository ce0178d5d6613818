// SPDX-License-Identifier: Apache-2.0
#include "reports/hard_scenes.h"

#include <cmath>

namespace plumbline::reports {

int add_material(Scene& scene, const Spectrum& albedo, const Spectrum& emission) {
    Material material;
    material.name = "material " + std::to_string(scene.materials.size());
    material.albedo = albedo;
    material.emission = emission;
    scene.materials.push_back(material);
    return int(scene.materials.size()) - 1;
}

void add_object(Scene& scene, const std::string& name, const decltype(Object::shape)& shape) {
    Object object;
    object.name = name;
    object.shape = shape;
    scene.objects.push_back(object);
}

void add_mesh(Scene& scene, const std::string& name, std::vector<glm::vec3> positions,
              std::vector<glm::uvec3> triangles, int material) {
    Mesh mesh;
    mesh.name = name;
    mesh.positions = std::move(positions);
    mesh.triangles = std::move(triangles);
    mesh.triangle_materials.assign(mesh.triangles.size(), material);
    scene.meshes.push_back(std::move(mesh));
    add_object(scene, name, MeshInstance{int(scene.meshes.size()) - 1});
}

void add_point_light(Scene& scene, const glm::vec3& position, const Spectrum& intensity) {
    PointLight light;
    light.name = "light " + std::to_string(scene.lights.size());
    light.position = position;
    light.intensity = intensity;
    scene.lights.push_back(light);
}

Quad wall(int axis, float facing, const glm::vec3& center, const glm::vec3& half, int material) {
    const int next = (axis + 1) % 3;
    const int last = (axis + 2) % 3;
    glm::vec3 u(0.f);
    glm::vec3 v(0.f);
    u[next] = 2.f * half[next];
    v[last] = 2.f * half[last];
    const glm::vec3 corner = center - u / 2.f - v / 2.f;
    if (facing < 0.f) std::swap(u, v);
    return {corner, u, v, material};
}

Scene closed_room(const Spectrum& albedo, const Spectrum& emission) {
    Scene scene;
    scene.name = "hard case";
    const int material = add_material(scene, albedo, emission);
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.f, 1.f}) {
            glm::vec3 center(0.f);
            center[axis] = side;
            add_object(scene, "wall " + std::to_string(scene.objects.size()),
                       wall(axis, -side, center, glm::vec3(1.f), material));
        }
    }
    scene.camera.eye = {-.7f, .2f, -.8f};
    scene.camera.target = {.3f, -.1f, .5f};
    scene.camera.vertical_fov = 1.2f;
    scene.camera.width = hard_width;
    scene.camera.height = hard_height;
    scene.probes = ProbeGrid{glm::vec3(-.9f), .6f, {4, 4, 4}};
    scene.thesis = ThesisConstants{.153f, .105f, 26.2f, 0.f, .07f, 1.f};
    return scene;
}

Scene furnace() { return closed_room(Spectrum(.5f), Spectrum(1.f)); }

double furnace_series(int bounces) { return furnace_radiance - std::exp2(-bounces - 1); }

Scene lit_room() {
    Scene scene = closed_room({.7f, .6f, .5f});
    const int red = add_material(scene, {.8f, .2f, .1f});
    add_object(scene, "block", Box{{-.2f, -1.f, .1f}, {.5f, -.3f, .7f}, {0, red, 0, 0, 0, red}});
    add_point_light(scene, {.2f, .7f, -.1f}, Spectrum(1.f));
    return scene;
}

Scene scaled_and_moved(Scene scene, float scale, const glm::vec3& shift) {
    Object root;
    root.name = "scaled and moved";
    root.rest.scale = glm::vec3(scale);
    root.rest.translation = shift;
    for (Object& object : scene.objects) ++object.parent;  // by one place; none becomes the root
    scene.objects.insert(scene.objects.begin(), root);
    scene.camera.eye = scene.camera.eye * scale + shift;
    scene.camera.target = scene.camera.target * scale + shift;
    for (PointLight& light : scene.lights) {
        light.position = light.position * scale + shift;
        light.intensity *= scale * scale;
        light.radius *= scale;
    }
    if (scene.probes) {
        scene.probes->origin = scene.probes->origin * scale + shift;
        scene.probes->spacing *= scale;
    }
    if (scene.thesis) scene.thesis->falloffRegulator *= scale * scale;  // a squared length
    return scene;
}

}  // namespace plumbline::reports
