// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scenes/write_json.h"

namespace plumbline {

/// Collects the typed arrays of a glTF file that is written: one buffer, a view an accessor.
class GltfBuffer {
 public:
    /// Appends an array and returns the index of its accessor.
    int add_vertices(const std::vector<glm::vec3>& values);
    int add_vertices(const std::vector<glm::vec2>& values);
    int add_times(const std::vector<float>& values);
    int add_vectors(const std::vector<glm::vec3>& values);
    int add_rotations(const std::vector<glm::quat>& values);
    int add_indices(const std::vector<glm::uvec3>& triangles, std::size_t first, std::size_t count);

    const std::string& bytes() const { return bytes_; }
    const OrderedJson& accessors() const { return accessors_; }
    const OrderedJson& views() const { return views_; }

 private:
    /// `target` is 0 for keyframes, else what the bytes are for [glTF 2.0, section 5.11.5].
    int add(const void* data, std::size_t bytes, std::size_t count, const char* type, int component,
            int target);

    std::string bytes_;
    OrderedJson accessors_ = OrderedJson::array();
    OrderedJson views_ = OrderedJson::array();
};

}  // namespace plumbline
