// SPDX-License-Identifier: Apache-2.0
#include "scenes/gltf_accessors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "scenes/nearest_name.h"

namespace plumbline {
namespace {

struct ElementType {
    const char* name;
    int components;
};
constexpr std::array<ElementType, 7> element_types = {
    {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}}};

/// Component types by their numbers in the file [glTF 2.0, section 3.6.2.2].
enum Component { Byte = 5120, UByte, Short, UShort, UInt = 5125, Float };

std::size_t component_bytes(int component) {
    if (component == Byte || component == UByte) return 1;
    return component == Short || component == UShort ? 2 : 4;
}

template <typename T>
double component_at(const char* bytes, bool normalized) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    if constexpr (std::numeric_limits<T>::is_integer) {
        if (normalized)
            return std::max(-1., value / static_cast<double>(std::numeric_limits<T>::max()));
    }
    return static_cast<double>(value);
}

double component_at(const char* bytes, int component, bool normalized) {
    switch (component) {
        case Byte:
            return component_at<std::int8_t>(bytes, normalized);
        case UByte:
            return component_at<std::uint8_t>(bytes, normalized);
        case Short:
            return component_at<std::int16_t>(bytes, normalized);
        case UShort:
            return component_at<std::uint16_t>(bytes, normalized);
        case UInt:
            return component_at<std::uint32_t>(bytes, normalized);
        default:
            return component_at<float>(bytes, false);
    }
}

std::size_t size_or(const JsonView& object, const std::string& key, std::size_t otherwise) {
    const auto member = object.find(key);
    return member ? static_cast<std::size_t>(member->integer(0)) : otherwise;
}

std::size_t total_bytes(const GltfDocument& document) {
    std::size_t total = 0;
    for (const std::string& buffer : document.buffers) total += buffer.size();
    return total;
}

}  // namespace

struct GltfAccessors::Layout {
    std::string type;
    int components;
    int component;
    bool normalized;
    std::size_t count;
};

GltfAccessors::GltfAccessors(const GltfDocument& document) : document_(document) {
    // Exporters share data between primitives, but not a hundred times over.
    constexpr std::size_t most_sharing = 64;
    constexpr std::size_t always_allowed = 1 << 20;
    budget_ = total_bytes(document) * most_sharing + always_allowed;
    const JsonView root(document.json);
    accessors_ = root.items("accessors");
    views_ = root.items("bufferViews");
}

GltfAccessors::Layout GltfAccessors::layout(const JsonView& accessor) const {
    Layout layout;
    layout.type = accessor.at("type").text();
    const auto* type = std::find_if(element_types.begin(), element_types.end(),
                                    [&](const ElementType& t) { return t.name == layout.type; });
    if (type == element_types.end()) {
        accessor.at("type").fail("there is no type " + in_quotes(layout.type),
                                 "write \"SCALAR\", \"VEC3\" or the like");
    }
    layout.components = type->components;
    layout.component = accessor.at("componentType").integer(Byte, Float);
    if (layout.component == UInt - 1) {
        accessor.at("componentType").fail("is 5124", "signed 32-bit integers are not allowed");
    }
    const auto normalized = accessor.find("normalized");
    layout.normalized = normalized && normalized->boolean();
    layout.count = static_cast<std::size_t>(accessor.at("count").integer(1));
    return layout;
}

const char* GltfAccessors::first_byte(const JsonView& view_reference, std::size_t offset,
                                      std::size_t count, std::size_t element_bytes,
                                      std::size_t& stride) const {
    const JsonView& view = views_[std::size_t(view_reference.index(views_.size(), "bufferView"))];
    const int index = view.at("buffer").index(document_.buffers.size(), "buffer");
    const std::string& buffer = document_.buffers[static_cast<std::size_t>(index)];
    const std::size_t start = size_or(view, "byteOffset", 0);
    const auto length = static_cast<std::size_t>(view.at("byteLength").integer(1));
    if (start > buffer.size() || length > buffer.size() - start) {
        view.fail(fmt::format("ends at byte {} of buffer {}, which has {}", start + length, index,
                              buffer.size()),
                  "the data may have been cut off, or the length is wrong");
    }
    const auto stride_given = view.find("byteStride");
    stride = stride_given ? static_cast<std::size_t>(stride_given->integer(1, 255)) : element_bytes;
    const std::size_t end = offset + (count - 1) * stride + element_bytes;
    if (end > length) {
        view_reference.fail(
            fmt::format("{} elements end at byte {} of a view of {}", count, end, length),
            "lower \"count\", or make the view longer");
    }
    return buffer.data() + start + offset;
}

std::string GltfAccessors::view_bytes(const JsonView& reference) const {
    const JsonView& view = views_[std::size_t(reference.index(views_.size(), "bufferView"))];
    const auto length = static_cast<std::size_t>(view.at("byteLength").integer(1));
    std::size_t stride = 1;
    return {first_byte(reference, 0, length, 1, stride), length};
}

void GltfAccessors::spend(const JsonView& reference, std::size_t values) {
    if (values > budget_) {
        reference.fail("the file asks for far more numbers than it holds",
                       "let nodes share a mesh instead of meshes sharing an accessor");
    }
    budget_ -= values;
}

std::vector<double> GltfAccessors::components(const JsonView& reference, Layout& layout) {
    const JsonView& accessor = accessors_[std::size_t(index(reference))];
    layout = this->layout(accessor);
    const auto components = static_cast<std::size_t>(layout.components);
    spend(reference, layout.count * components);
    std::vector<double> values(layout.count * components, 0.);
    if (const auto view = accessor.find("bufferView")) {
        const std::size_t bytes = component_bytes(layout.component);
        std::size_t stride = 0;
        const char* first = first_byte(*view, size_or(accessor, "byteOffset", 0), layout.count,
                                       bytes * components, stride);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const char* at = first + (i / components) * stride + (i % components) * bytes;
            values[i] = component_at(at, layout.component, layout.normalized);
        }
    }
    if (const auto sparse = accessor.find("sparse")) replace_sparse(*sparse, layout, values);
    return values;
}

void GltfAccessors::replace_sparse(const JsonView& sparse, const Layout& layout,
                                   std::vector<double>& values) {
    const auto count = static_cast<std::size_t>(sparse.at("count").integer(1));
    const auto components = static_cast<std::size_t>(layout.components);
    const std::size_t bytes = component_bytes(layout.component);
    const JsonView where = sparse.at("indices");
    const JsonView what = sparse.at("values");
    const int index_type = where.at("componentType").integer(UByte, UInt);
    std::size_t index_stride = 0;
    std::size_t value_stride = 0;
    const char* indices = first_byte(where.at("bufferView"), size_or(where, "byteOffset", 0), count,
                                     component_bytes(index_type), index_stride);
    const char* replacements = first_byte(what.at("bufferView"), size_or(what, "byteOffset", 0),
                                          count, bytes * components, value_stride);
    for (std::size_t i = 0; i < count; ++i) {
        const auto target =
            static_cast<std::size_t>(component_at(indices + i * index_stride, index_type, false));
        if (target >= layout.count) {
            where.fail(fmt::format("entry {} replaces element {}", i, target),
                       fmt::format("there are 0 to {}", layout.count - 1));
        }
        for (std::size_t c = 0; c < components; ++c) {
            values[target * components + c] = component_at(
                replacements + i * value_stride + c * bytes, layout.component, layout.normalized);
        }
    }
}

GltfAccessors::Values GltfAccessors::floats(const JsonView& reference,
                                            const std::vector<std::string>& types) {
    Layout layout;
    const std::vector<double> numbers = components(reference, layout);
    if (std::find(types.begin(), types.end(), layout.type) == types.end()) {
        reference.fail("refers to an accessor of type " + in_quotes(layout.type),
                       did_you_mean("", types));
    }
    Values values{layout.components, {}};
    values.numbers.reserve(numbers.size());
    for (const double number : numbers) values.numbers.push_back(static_cast<float>(number));
    return values;
}

std::vector<std::uint32_t> GltfAccessors::indices(const JsonView& reference) {
    Layout layout;
    const std::vector<double> numbers = components(reference, layout);
    const bool whole =
        layout.component == UByte || layout.component == UShort || layout.component == UInt;
    if (layout.type != "SCALAR" || !whole || layout.normalized) {
        reference.fail("refers to an accessor that does not hold indices",
                       "indices are unsigned SCALARs of 8, 16 or 32 bits");
    }
    std::vector<std::uint32_t> indices;
    indices.reserve(numbers.size());
    for (const double number : numbers) indices.push_back(static_cast<std::uint32_t>(number));
    return indices;
}

glm::vec3 GltfAccessors::Values::vec3(std::size_t i) const {
    const float* first = &numbers[i * static_cast<std::size_t>(components)];
    return {first[0], first[1], first[2]};
}

}  // namespace plumbline
