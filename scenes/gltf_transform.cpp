// SPDX-License-Identifier: Apache-2.0
#include "scenes/read_gltf.h"

namespace plumbline {
namespace {

glm::mat4 matrix_of(const JsonView& item) {
    const std::vector<double> numbers = item.numbers(16);
    glm::mat4 matrix;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            matrix[column][row] =
                static_cast<float>(numbers[4 * std::size_t(column) + std::size_t(row)]);
        }
    }
    return matrix;
}

/// Scale, rotation and translation of a matrix, which must be made of these alone.
Transform decomposed(const JsonView& item) {
    const glm::mat4 matrix = matrix_of(item);
    glm::mat3 axes(matrix);
    Transform transform;
    transform.translation = glm::vec3(matrix[3]);
    for (int i = 0; i < 3; ++i) transform.scale[i] = glm::length(axes[i]);
    if (glm::determinant(axes) < 0.f) transform.scale.x = -transform.scale.x;
    if (min_component(glm::abs(transform.scale)) == 0.f) {
        item.fail("has a column of length zero", "give \"scale\", \"rotation\", \"translation\"");
    }
    for (int i = 0; i < 3; ++i) axes[i] /= transform.scale[i];
    transform.rotation = glm::normalize(glm::quat_cast(axes));
    const glm::mat3 rotation = glm::mat3_cast(transform.rotation);
    constexpr float rounding = 1e-4f;
    for (int i = 0; i < 3; ++i) {
        // The negation also refuses NaN.
        if (!(max_component(glm::abs(axes[i] - rotation[i])) <= rounding)) {
            item.fail("shears", "give \"scale\", \"rotation\" and \"translation\" instead");
        }
    }
    return transform;
}

}  // namespace

Transform gltf_transform(const JsonView& node) {
    if (const auto matrix = node.find("matrix")) return decomposed(*matrix);
    Transform transform;
    if (const auto scale = node.find("scale")) transform.scale = scale->vec3();
    if (const auto rotation = node.find("rotation")) transform.rotation = rotation->rotation();
    if (const auto translation = node.find("translation")) {
        transform.translation = translation->vec3();
    }
    return transform;
}

}  // namespace plumbline
