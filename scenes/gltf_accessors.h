// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scenes/gltf_document.h"

namespace plumbline {

/// Reads the typed arrays of a glTF document, which must outlive it [glTF 2.0, section 3.6.2].
///
/// Every function takes the place that refers to the accessor, and throws SceneError if anything
/// on the way to its bytes does not exist, has another type, or lies past the end of a buffer.
class GltfAccessors {
 public:
    explicit GltfAccessors(const GltfDocument& document);

    /// Components as numbers, row by row: normalised integers become [0,1] or [-1,1].
    struct Values {
        int components;  ///< of one element
        std::vector<float> numbers;

        std::size_t count() const { return numbers.size() / static_cast<std::size_t>(components); }
        glm::vec3 vec3(std::size_t i) const;
    };
    /// `types` lists those that may stand there, such as "VEC3".
    Values floats(const JsonView& reference, const std::vector<std::string>& types);
    /// Unsigned integers of 8, 16 or 32 bits.
    std::vector<std::uint32_t> indices(const JsonView& reference);

    /// All bytes of the view that a place refers to.
    std::string view_bytes(const JsonView& reference) const;

    /// Which accessor a place refers to.
    int index(const JsonView& reference) const {
        return reference.index(accessors_.size(), "accessor");
    }

 private:
    struct Layout;

    Layout layout(const JsonView& accessor) const;
    /// Where element 0 is, after checking that the last one ends within its view and buffer.
    const char* first_byte(const JsonView& view_reference, std::size_t offset, std::size_t count,
                           std::size_t element_bytes, std::size_t& stride) const;
    std::vector<double> components(const JsonView& reference, Layout& layout);
    void replace_sparse(const JsonView& sparse, const Layout& layout, std::vector<double>& values);
    /// Refuses small files that ask for the same bytes so often that memory runs out.
    void spend(const JsonView& reference, std::size_t values);

    const GltfDocument& document_;
    std::vector<JsonView> accessors_;
    std::vector<JsonView> views_;
    std::size_t budget_;
};

}  // namespace plumbline
