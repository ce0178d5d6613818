// SPDX-License-Identifier: Apache-2.0
#include "scenes/gltf_buffer.h"

#include <bit>

namespace plumbline {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF stores little-endian numbers");
static_assert(sizeof(glm::vec3) == 3 * sizeof(float) && sizeof(glm::uvec3) == 12);

constexpr int component_float = 5126;
constexpr int component_uint = 5125;
constexpr int vertices = 34962;
constexpr int indices = 34963;
constexpr int keyframes = 0;

}  // namespace

int GltfBuffer::add(const void* data, std::size_t bytes, std::size_t count, const char* type,
                    int component, int target) {
    OrderedJson view = {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes}};
    if (target != 0) view["target"] = target;
    accessors_.push_back({{"bufferView", views_.size()},
                          {"componentType", component},
                          {"count", count},
                          {"type", type}});
    views_.push_back(std::move(view));
    bytes_.append(static_cast<const char*>(data), bytes);
    return static_cast<int>(accessors_.size()) - 1;
}

int GltfBuffer::add_vertices(const std::vector<glm::vec3>& values) {
    const int accessor = add(values.data(), values.size() * sizeof(glm::vec3), values.size(),
                             "VEC3", component_float, vertices);
    Bounds bounds;
    for (const glm::vec3& value : values) bounds.extend(value);
    accessors_.back()["min"] = {bounds.lower.x, bounds.lower.y, bounds.lower.z};
    accessors_.back()["max"] = {bounds.upper.x, bounds.upper.y, bounds.upper.z};
    return accessor;
}

int GltfBuffer::add_vertices(const std::vector<glm::vec2>& values) {
    return add(values.data(), values.size() * sizeof(glm::vec2), values.size(), "VEC2",
               component_float, vertices);
}

int GltfBuffer::add_times(const std::vector<float>& values) {
    const int accessor = add(values.data(), values.size() * sizeof(float), values.size(), "SCALAR",
                             component_float, keyframes);
    // Times must tell their range; they rise.
    accessors_.back()["min"] = OrderedJson::array({values.front()});
    accessors_.back()["max"] = OrderedJson::array({values.back()});
    return accessor;
}

int GltfBuffer::add_vectors(const std::vector<glm::vec3>& values) {
    return add(values.data(), values.size() * sizeof(glm::vec3), values.size(), "VEC3",
               component_float, keyframes);
}

int GltfBuffer::add_rotations(const std::vector<glm::quat>& values) {
    std::vector<float> numbers;
    for (const glm::quat& q : values) numbers.insert(numbers.end(), {q.x, q.y, q.z, q.w});
    return add(numbers.data(), numbers.size() * sizeof(float), values.size(), "VEC4",
               component_float, keyframes);
}

int GltfBuffer::add_indices(const std::vector<glm::uvec3>& triangles, std::size_t first,
                            std::size_t count) {
    return add(&triangles[first], count * sizeof(glm::uvec3), count * 3, "SCALAR", component_uint,
               indices);
}

}  // namespace plumbline
