// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scenes/geometry.h"
#include "scenes/panorama.h"
#include "scenes/texture.h"
#include "scenes/transform.h"

namespace plumbline {

/// A Lambert surface: f = albedo / pi on the front, and on the back too if two-sided.
///
/// The back of a one-sided surface is black to light, and invisible to camera and surfel rays.
struct Material {
    std::string name;
    Spectrum albedo{0.7f};             ///< in [0,1]
    std::optional<Texture> texture{};  ///< multiplies albedo; then meshes have texture coordinates
    Spectrum emission{0.f};            ///< radiance, W m^-2 sr^-1, from every side that reflects
    bool two_sided = false;
    bool operator==(const Material&) const = default;
};

/// Triangles in object space; counter-clockwise seen from the front.
struct Mesh {
    std::string name;
    std::vector<glm::vec3> positions;
    std::vector<Spectrum> vertex_albedo;  ///< empty, or one a position: multiplies the material's
    std::vector<glm::vec2> texcoords;     ///< empty, or one a position: see Texture::at
    std::vector<glm::uvec3> triangles;    ///< indices into positions
    std::vector<int> triangle_materials;  ///< one a triangle: indices into Scene::materials
    bool operator==(const Mesh&) const = default;
};

/// The faces of a Box, in the order of Box::face_materials.
enum class Face { PlusX, MinusX, PlusY, MinusY, PlusZ, MinusZ };

/// An axis-aligned box in object space; its front is outside.
struct Box {
    glm::vec3 lower;
    glm::vec3 upper;
    std::array<int, 6> face_materials;
    bool operator==(const Box&) const = default;
};

/// The parallelogram corner + s edge_u + t edge_v, s and t in [0,1]; its front is edge_u x edge_v.
struct Quad {
    glm::vec3 corner;
    glm::vec3 edge_u;
    glm::vec3 edge_v;
    int material;
    bool operator==(const Quad&) const = default;
};

/// An exact sphere, not a mesh; its front is outside, or inside if `inward`.
/// The object's world transform must scale it evenly.
struct Sphere {
    glm::vec3 center;
    float radius;
    bool inward;
    int material;
    bool operator==(const Sphere&) const = default;
};

/// An instance of Scene::meshes[mesh].
struct MeshInstance {
    int mesh;
    bool operator==(const MeshInstance&) const = default;
};

/// Something with a place in the world; a Shape of monostate only groups its children.
struct Object {
    std::string name;
    int parent = -1;  ///< index into Scene::objects of an earlier object, or -1
    Transform rest;
    Animation animation;
    std::variant<std::monostate, Box, Quad, Sphere, MeshInstance> shape;
    bool operator==(const Object&) const = default;
};

enum class Falloff {
    InverseSquare,  ///< E = intensity / d^2: physical
    None,           ///< E = pi white_radiance at any distance: the light of [Dellson 2023]
};

/// What makes a point light a spot: whole up to `inner_angle` off the axis, nothing from
/// `outer_angle` on, and between them the square of a ramp in the cosine
/// [glTF KHR_lights_punctual, "Inner and Outer Cone Angles"].
struct SpotCone {
    glm::vec3 direction{0.f, -1.f, 0.f};  ///< of the axis, away from the light; of any length
    float inner_angle = 0.f;              ///< radians; 0 <= inner < outer <= pi / 2
    float outer_angle = 0.785398f;        ///< radians
    bool operator==(const SpotCone&) const = default;
};

/// A light at a point, or an even ball of light around it, that rays pass through: it is not seen
/// and throws no shadow.
///
/// A ball's radiance is such that it lights what faces its centre like the point does:
/// normal_irradiance / (pi sin^2 a), a the angle of its radius. It shines outward only.
struct PointLight {
    std::string name;
    glm::vec3 position{0.f};
    Falloff falloff = Falloff::InverseSquare;
    Spectrum intensity{0.f};         ///< radiant intensity, W sr^-1; with InverseSquare
    Spectrum white_radiance{0.f};    ///< radiance of a white surface that faces it; with None
    float radius = 0.f;              ///< of the ball; 0 for a point
    std::optional<SpotCone> cone{};  ///< none: alike in every direction
    bool operator==(const PointLight&) const = default;
};

/// A light as it would be without size and alike in every direction: fit for loops over points.
struct EvenLight {
    glm::vec3 position;
    Spectrum E_at_1;  ///< irradiance at normal incidence at distance 1, W m^-2
    /// Squared distances are clamped to these before they count: 1 and 1 without falloff.
    float least_d2 = 1.f, most_d2 = 1.f;

    explicit EvenLight(const PointLight& light) : position(light.position) {
        if (light.falloff == Falloff::InverseSquare) {
            E_at_1 = light.intensity;
            least_d2 = 0.f;
            most_d2 = std::numeric_limits<float>::infinity();
        } else {
            E_at_1 = std::numbers::pi_v<float> * light.white_radiance;
        }
    }

    /// Irradiance at normal incidence, W m^-2, at the squared distance `d2`.
    Spectrum normal_irradiance(float d2) const {
        return E_at_1 / glm::clamp(d2, least_d2, most_d2);
    }
};

/// The share of a spot's light that goes to a point from which `to_light` leads to it. The cone's
/// direction must have unit length, as world_at() gives it.
float spot_attenuation(const SpotCone& cone, const glm::vec3& to_light);

/// Irradiance at normal incidence, W m^-2, of a point from which `to_light` leads to the centre of
/// the light. A cone's direction must have unit length, as world_at() gives it.
Spectrum normal_irradiance(const PointLight& light, const glm::vec3& to_light);

/// A light so far away that it comes from one direction, alike everywhere.
struct DirectionalLight {
    std::string name;
    glm::vec3 direction{0.f, -1.f, 0.f};  ///< in which the light travels; of any length
    Spectrum irradiance{0.f};             ///< at normal incidence, W m^-2
    bool operator==(const DirectionalLight&) const = default;
};

/// A picture of the environment, turned about the vertical.
struct EnvironmentImage {
    std::shared_ptr<const Panorama> panorama;  ///< never null
    float rotation = 0.f;                      ///< radians about +y, from +z towards +x
    bool operator==(const EnvironmentImage& other) const;

    /// `direction`, turned by `angle` like the picture.
    static glm::vec3 turned(const glm::vec3& direction, float angle);
};

/// A pinhole camera; `up` need not be perpendicular to the view.
struct Camera {
    glm::vec3 eye{0.f, 0.f, 5.f};
    glm::vec3 target{0.f};
    glm::vec3 up{0.f, 1.f, 0.f};
    float vertical_fov = 0.785398f;  ///< radians
    int width = 1920;                ///< of the finished picture, pixels
    int height = 1080;
    bool operator==(const Camera&) const = default;
};

/// A regular grid of counts.x * counts.y * counts.z probes, the first at `origin`.
struct ProbeGrid {
    glm::vec3 origin{0.f};
    float spacing = 1.f;
    glm::ivec3 counts{2};
    bool operator==(const ProbeGrid&) const = default;
};

/// The constants that [Dellson 2023] sets by hand for each scene, under their published names.
struct ThesisConstants {
    float falloffRegulator = 0.f;      ///< a miss brings the neighbour's times this / (2 spacing^2)
    float bounceAttenuation = 0.f;     ///< scales every lit surfel
    float probeBrightness = 0.f;       ///< scales the probe light looked up by a pixel
    float multiBounceIntensity = 0.f;  ///< scales the feedback from probes to surfels; 0: none
    float ambient = 0.f;               ///< radiance added per unit of albedo
    float imageBrightness = 1.f;       ///< scales the displayed picture only
    bool operator==(const ThesisConstants&) const = default;
};

/// A scene as its author wrote it, through all its frames.
struct Scene {
    std::string name;
    std::string description;
    std::string length_unit;  ///< its name only, such as "m"; may be empty
    std::vector<Material> materials;
    std::vector<Mesh> meshes;
    std::vector<Object> objects;
    std::vector<PointLight> lights;
    std::vector<DirectionalLight> directional_lights;
    /// Radiance of rays that leave the scene, W m^-2 sr^-1; if there is a picture, its multiple.
    Spectrum environment{0.f};
    std::optional<EnvironmentImage> environment_image;
    Camera camera;
    int report_frame = 0;  ///< the frame that shows what the scene is about; in [0, frames)
    int frames = 1;
    float frames_per_second = 60.f;
    std::optional<ProbeGrid> probes;         ///< none: see probe_grid()
    std::optional<ThesisConstants> thesis;   ///< as the file has them
    std::vector<std::string> not_simulated;  ///< what the file asks for beyond this: one line each
    bool operator==(const Scene&) const = default;
};

}  // namespace plumbline
