// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "scenes/write_json.h"

namespace plumbline {

/// Extras under Plumbline's own key, apart from those of other programs.
OrderedJson under_plumbline(OrderedJson extras);

/// The colour in [0,1] of light of a strength: their product, taken in double, rounds to the same
/// floats.
OrderedJson colour_of(const Spectrum& light, float strength);

/// A light of KHR_lights_punctual without what its type adds.
OrderedJson gltf_light(const std::string& name, const char* type, const Spectrum& power);
/// The rotation that turns -z, where glTF's lights and cameras point, to `direction`.
glm::quat rotation_towards(const glm::vec3& direction);

OrderedJson gltf_material(const Material& material);
/// How a texture goes on beyond its picture.
OrderedJson gltf_sampler(const Texture& texture);
/// The number that stands for a wrap, by Wrap's order [glTF 2.0, section 5.26].
inline constexpr std::array gltf_wraps{10497, 33648, 33071};

/// The exact shape that a mesh stands for, for the mesh's extras.
OrderedJson shape_extras(const Box& box);
OrderedJson shape_extras(const Quad& quad);
OrderedJson shape_extras(const Sphere& sphere);

/// The camera, and the node that carries it.
OrderedJson gltf_camera(const Camera& camera);
OrderedJson gltf_camera_node(const Camera& camera);

/// What the format cannot say of the scene as a whole, for its extras.
OrderedJson scene_extras(const Scene& scene);

}  // namespace plumbline
