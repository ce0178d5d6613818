// SPDX-License-Identifier: Apache-2.0
#include "scenes/ray_tracer.h"

#include <embree3/rtcore.h>

#include <cmath>
#include <limits>
#include <string>

#include "scenes/errors.h"

namespace plumbline {
namespace {

/// Rounding of a point interpolated in a triangle, and of Embree's own distance to the triangle
/// from a point this near, in units of float epsilon times the largest coordinate: gamma_7 of
/// [Pharr et al. 2023, section 6.8.4] for the point, as much again for the distance, and a margin.
constexpr float error_in_epsilons = 32.f;

float position_error(float largest_coordinate) {
    return error_in_epsilons * std::numeric_limits<float>::epsilon() / 2.f * largest_coordinate;
}

float largest_coordinate(const glm::vec3& p) { return max_component(glm::abs(p)); }

/// Per Embree geometry: what the culling filter and the hit need.
struct Geometry {
    const WorldMesh* mesh = nullptr;
    const WorldSphere* sphere = nullptr;
};

struct CullingContext {
    RTCIntersectContext embree;  // first: Embree hands this pointer to the filter
    const World* world;
    const std::vector<Geometry>* geometries;
};

int material_of(const Geometry& geometry, unsigned primitive) {
    return geometry.mesh != nullptr ? geometry.mesh->triangle_materials[primitive]
                                    : geometry.sphere->material;
}

/// Embree's Ng has the winding's orientation: for a sphere it points outward.
bool is_back(const Geometry& geometry, const glm::vec3& ng, const glm::vec3& direction) {
    const bool inward = geometry.sphere != nullptr && geometry.sphere->inward;
    return (glm::dot(ng, direction) > 0.f) != inward;
}

/// Rejects hits on backs of one-sided materials.
void cull_backs(const RTCFilterFunctionNArguments* args) {
    const auto* context = reinterpret_cast<const CullingContext*>(args->context);
    for (unsigned i = 0; i < args->N; ++i) {
        if (args->valid[i] == 0) continue;
        const glm::vec3 ng(RTCHitN_Ng_x(args->hit, args->N, i), RTCHitN_Ng_y(args->hit, args->N, i),
                           RTCHitN_Ng_z(args->hit, args->N, i));
        const glm::vec3 direction(RTCRayN_dir_x(args->ray, args->N, i),
                                  RTCRayN_dir_y(args->ray, args->N, i),
                                  RTCRayN_dir_z(args->ray, args->N, i));
        const Geometry& geometry = (*context->geometries)[RTCHitN_geomID(args->hit, args->N, i)];
        const int material = material_of(geometry, RTCHitN_primID(args->hit, args->N, i));
        const bool one_sided =
            !context->world->materials[static_cast<std::size_t>(material)].two_sided;
        if (one_sided && is_back(geometry, ng, direction)) args->valid[i] = 0;
    }
}

RTCRay embree_ray(const glm::vec3& origin, const glm::vec3& direction, float t_max) {
    RTCRay ray{};
    ray.org_x = origin.x;
    ray.org_y = origin.y;
    ray.org_z = origin.z;
    ray.dir_x = direction.x;
    ray.dir_y = direction.y;
    ray.dir_z = direction.z;
    // Embree counts a surface at tnear as met; a point on a surface is not in front of it.
    ray.tnear = std::numeric_limits<float>::min();
    ray.tfar = t_max;
    ray.mask = ~0u;
    return ray;
}

void throw_on_error(RTCDevice device) {
    const RTCError error = rtcGetDeviceError(device);
    if (error == RTC_ERROR_NONE) return;
    throw SceneError("scene", "Embree cannot build it (error " + std::to_string(error) + ")",
                     error == RTC_ERROR_OUT_OF_MEMORY ? "use fewer triangles or more memory"
                                                      : "check the geometry for extreme values");
}

Hit triangle_hit(const World& world, const WorldMesh& mesh, const RTCRayHit& found) {
    const glm::uvec3& triangle = mesh.triangles[found.hit.primID];
    const glm::vec3& a = mesh.positions[triangle.x];
    const glm::vec3& b = mesh.positions[triangle.y];
    const glm::vec3& c = mesh.positions[triangle.z];
    const float u = found.hit.u;
    const float v = found.hit.v;
    Hit hit;
    hit.object = mesh.object;
    hit.material = mesh.triangle_materials[found.hit.primID];
    // Interpolated, not origin + t direction, whose error grows with the distance.
    hit.position = (1.f - u - v) * a + u * b + v * c;
    hit.position_error = position_error(
        glm::max(largest_coordinate(a), glm::max(largest_coordinate(b), largest_coordinate(c))));
    hit.ng = glm::normalize(glm::vec3(found.hit.Ng_x, found.hit.Ng_y, found.hit.Ng_z));
    hit.albedo = world.materials[static_cast<std::size_t>(hit.material)].albedo;
    if (!mesh.vertex_albedo.empty()) {
        hit.albedo *= (1.f - u - v) * mesh.vertex_albedo[triangle.x] +
                      u * mesh.vertex_albedo[triangle.y] + v * mesh.vertex_albedo[triangle.z];
    }
    return hit;
}

Hit sphere_hit(const World& world, const WorldSphere& sphere, const Ray& ray, float t) {
    Hit hit;
    hit.object = sphere.object;
    hit.material = sphere.material;
    const glm::vec3 outward = glm::normalize(ray.origin + t * ray.direction - sphere.center);
    hit.position = sphere.center + sphere.radius * outward;
    hit.position_error = position_error(largest_coordinate(sphere.center) + sphere.radius);
    hit.ng = sphere.inward ? -outward : outward;
    hit.albedo = world.materials[static_cast<std::size_t>(hit.material)].albedo;
    return hit;
}

}  // namespace

struct RayTracer::Embree {
    RTCDevice device = rtcNewDevice(nullptr);
    RTCScene scene = rtcNewScene(device);
    std::vector<Geometry> geometries;  // by Embree's geomID

    Embree() = default;
    Embree(const Embree&) = delete;
    Embree& operator=(const Embree&) = delete;
    ~Embree() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }

    void attach(RTCGeometry geometry, const Geometry& entry) {
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(scene, geometry, static_cast<unsigned>(geometries.size()));
        rtcReleaseGeometry(geometry);
        throw_on_error(device);
        geometries.push_back(entry);
    }

    void add(const WorldMesh& mesh) {
        const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        // Embree copies: a shared buffer would have to be padded to 16 bytes.
        auto* positions = static_cast<glm::vec3*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                    sizeof(glm::vec3), mesh.positions.size()));
        auto* triangles = static_cast<glm::uvec3*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    sizeof(glm::uvec3), mesh.triangles.size()));
        throw_on_error(device);
        std::copy(mesh.positions.begin(), mesh.positions.end(), positions);
        std::copy(mesh.triangles.begin(), mesh.triangles.end(), triangles);
        attach(geometry, {&mesh, nullptr});
    }

    void add(const WorldSphere& sphere) {
        const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
        auto* center_radius = static_cast<glm::vec4*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, sizeof(glm::vec4), 1));
        throw_on_error(device);
        *center_radius = glm::vec4(sphere.center, sphere.radius);
        attach(geometry, {nullptr, &sphere});
    }
};

glm::vec3 offset_origin(const Hit& hit, const glm::vec3& n) {
    // The error box seen along n: beyond it the point is on the side of n for sure.
    const glm::vec3 size = glm::abs(n);
    return hit.position + n * (hit.position_error * (size.x + size.y + size.z));
}

RayTracer::RayTracer(const World& world) : world_(world), embree_(std::make_unique<Embree>()) {
    // Robust: no ray slips through the edge between two triangles.
    rtcSetSceneFlags(embree_->scene,
                     RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
    for (const WorldMesh& mesh : world.meshes) embree_->add(mesh);
    for (const WorldSphere& sphere : world.spheres) embree_->add(sphere);
    rtcCommitScene(embree_->scene);
    throw_on_error(embree_->device);
}

RayTracer::~RayTracer() = default;

std::optional<Hit> RayTracer::intersect(const Ray& ray, BackFaces back_faces) const {
    CullingContext context;
    rtcInitIntersectContext(&context.embree);
    context.world = &world_;
    context.geometries = &embree_->geometries;
    if (back_faces == BackFaces::Cull) context.embree.filter = cull_backs;
    RTCRayHit found;
    found.ray = embree_ray(ray.origin, ray.direction, ray.t_max);
    found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(embree_->scene, &context.embree, &found);
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

    const Geometry& geometry = embree_->geometries[found.hit.geomID];
    Hit hit = geometry.mesh != nullptr ? triangle_hit(world_, *geometry.mesh, found)
                                       : sphere_hit(world_, *geometry.sphere, ray, found.ray.tfar);
    hit.t = found.ray.tfar;
    hit.back = glm::dot(hit.ng, ray.direction) > 0.f;
    return hit;
}

bool RayTracer::occluded(const glm::vec3& a, const glm::vec3& b) const {
    // A surface that `b` lies on is not between: its distance is known to within this much.
    const glm::vec3 way = b - a;
    const float error = position_error(glm::max(largest_coordinate(a), largest_coordinate(b)));
    const float t_max = 1.f - 2.f * error / glm::length(way);
    if (!(t_max > 0.f)) return false;  // nearer than floats can tell apart, or the same point

    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay ray = embree_ray(a, way, t_max);
    rtcOccluded1(embree_->scene, &context, &ray);
    return ray.tfar < 0.f;
}

}  // namespace plumbline
