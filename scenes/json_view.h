// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scenes/geometry.h"
#include "scenes/json_text.h"

namespace plumbline {

/// A value in a JsonDocument, which must outlive it, that knows its place.
///
/// Every reading function throws SceneError with file, JSON pointer, what is wrong and what would
/// be right.
class JsonView {
 public:
    explicit JsonView(const JsonDocument& document)
        : JsonView(document.source, document.root, "") {}

    [[noreturn]] void fail(const std::string& problem, const std::string& cure) const;
    const std::string& source() const { return *source_; }
    const std::string& pointer() const { return pointer_; }
    /// "file: /json/pointer", or the file alone at the top.
    std::string place() const;

    bool is_array() const { return value_->is_array(); }
    bool is_number() const { return value_->is_number(); }
    bool is_object() const { return value_->is_object(); }
    bool is_string() const { return value_->is_string(); }

    /// Refuses this unless it is an object with no other keys than these.
    void expect_keys(std::span<const std::string> known) const;
    void expect_keys(std::initializer_list<std::string> known) const {
        expect_keys(std::span(known.begin(), known.size()));
    }
    /// The keys of this object.
    std::vector<std::string> keys() const;
    /// The member of this name, if any.
    std::optional<JsonView> find(const std::string& key) const;
    /// The member of this name, which must exist.
    JsonView at(const std::string& key) const;
    /// The elements of this array.
    std::vector<JsonView> items() const;
    /// The elements of the array of this name, none if there is no such member.
    std::vector<JsonView> items(const std::string& key) const;

    std::string text() const;
    bool boolean() const;
    double number() const;
    /// A number that is finite as a 32-bit float.
    float real() const;
    int integer(int least, int most = std::numeric_limits<int>::max()) const;
    /// A whole number that counts from 0 in a list of `count` things called `what`.
    int index(std::size_t count, const std::string& what) const;
    /// Exactly `count` numbers.
    std::vector<double> numbers(std::size_t count) const;
    glm::vec3 vec3() const;
    glm::ivec3 ivec3(int least, int most) const;
    /// Three numbers, or one that stands for three equal ones.
    glm::vec3 vec3_or_number() const;
    /// Four numbers x, y, z, w of unit length, or {"axis", "degrees"} or {"axis", "radians"}.
    glm::quat rotation() const;

 private:
    JsonView(const std::string& source, const Json& value, std::string pointer)
        : source_(&source), value_(&value), pointer_(std::move(pointer)) {}
    std::vector<JsonView> items(std::size_t count, const std::string& what) const;
    [[noreturn]] void fail_type(const std::string& expected) const;

    const std::string* source_;
    const Json* value_;
    std::string pointer_;
};

}  // namespace plumbline
