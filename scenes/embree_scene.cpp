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
    attach(geometry, {&mesh, nullptr, is_plain(mesh)});
}

void EmbreeScene::add(const WorldSphere& sphere) {
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    auto* center_radius = static_cast<glm::vec4*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, sizeof(glm::vec4), 1));
    throw_on_error(device_);
    *center_radius = glm::vec4(sphere.center, sphere.radius);
    attach(geometry, {nullptr, &sphere});
}

bool EmbreeScene::is_plain(const WorldMesh& mesh) const {
    return mesh.vertex_albedo.empty() && std::ranges::none_of(mesh.triangle_materials, [&](int m) {
               return world_.materials[static_cast<std::size_t>(m)].texture.has_value();
           });
}

bool EmbreeScene::is_culled(const glm::vec3& direction, const Found& found) const {
    const Geometry& geometry = geometries_[found.geometry];
    const bool inward = geometry.sphere != nullptr && geometry.sphere->inward;
    const bool back = (glm::dot(found.ng, direction) > 0.f) != inward;
    if (!back) return false;
    const int material = geometry.sphere != nullptr
                             ? geometry.sphere->material
                             : geometry.mesh->triangle_materials[found.primitive];
    return !world_.materials[static_cast<std::size_t>(material)].two_sided;
}

}  // namespace plumbline
