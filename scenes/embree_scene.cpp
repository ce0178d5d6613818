// SPDX-License-Identifier: Apache-2.0
#include "scenes/embree_scene.h"

#include <algorithm>
#include <string>

#include "scenes/errors.h"

namespace plumbline {
namespace {

void throw_on_error(RTCDevice device) {
    const RTCError error = rtcGetDeviceError(device);
    if (error == RTC_ERROR_NONE) return;
    throw SceneError("scene", "Embree cannot build it (error " + std::to_string(error) + ")",
                     error == RTC_ERROR_OUT_OF_MEMORY ? "use fewer triangles or more memory"
                                                      : "check the geometry for extreme values");
}

}  // namespace

EmbreeScene::EmbreeScene(const World& world)
    : world_(world), device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
    // Robust: no ray slips through the edge between two triangles.
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
    for (const WorldMesh& mesh : world.meshes) add(mesh);
    for (const WorldSphere& sphere : world.spheres) add(sphere);
    rtcCommitScene(scene_);
    throw_on_error(device_);
}

EmbreeScene::~EmbreeScene() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
}

void EmbreeScene::attach(RTCGeometry geometry, const Geometry& entry) {
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene_, geometry, static_cast<unsigned>(geometries_.size()));
    rtcReleaseGeometry(geometry);
    throw_on_error(device_);
    geometries_.push_back(entry);
}

void EmbreeScene::add(const WorldMesh& mesh) {
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    // Embree copies: a shared buffer would have to be padded to 16 bytes.
    auto* positions = static_cast<glm::vec3*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                sizeof(glm::vec3), mesh.positions.size()));
    auto* triangles = static_cast<glm::uvec3*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                sizeof(glm::uvec3), mesh.triangles.size()));
    throw_on_error(device_);
    std::copy(mesh.positions.begin(), mesh.positions.end(), positions);
    std::copy(mesh.triangles.begin(), mesh.triangles.end(), triangles);
    attach(geometry, {.mesh = &mesh, .plain = is_plain(mesh), .sides = sides_of(mesh)});
}

void EmbreeScene::add(const WorldSphere& sphere) {
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    auto* center_radius = static_cast<glm::vec4*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, sizeof(glm::vec4), 1));
    throw_on_error(device_);
    *center_radius = glm::vec4(sphere.center, sphere.radius);
    const Material& material = world_.materials[static_cast<std::size_t>(sphere.material)];
    attach(geometry, {.sphere = &sphere,
                      .sides = material.two_sided ? Sides::Two : Sides::One,
                      .inward = sphere.inward});
}

bool EmbreeScene::is_plain(const WorldMesh& mesh) const {
    return mesh.vertex_albedo.empty() && std::ranges::none_of(mesh.triangle_materials, [&](int m) {
               return world_.materials[static_cast<std::size_t>(m)].texture.has_value();
           });
}

EmbreeScene::Sides EmbreeScene::sides_of(const WorldMesh& mesh) const {
    const auto two_sided = std::ranges::count_if(mesh.triangle_materials, [&](int material) {
        return world_.materials[static_cast<std::size_t>(material)].two_sided;
    });
    if (two_sided == 0) return Sides::One;
    return two_sided == std::ssize(mesh.triangle_materials) ? Sides::Two : Sides::Mixed;
}

bool EmbreeScene::is_one_sided(const Geometry& geometry, unsigned primitive) const {
    const int material = geometry.mesh->triangle_materials[primitive];
    return !world_.materials[static_cast<std::size_t>(material)].two_sided;
}

}  // namespace plumbline
