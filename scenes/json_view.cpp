// SPDX-License-Identifier: Apache-2.0
#include "scenes/json_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scenes/errors.h"
#include "scenes/nearest_name.h"
#include "scenes/unit_rotation.h"

namespace plumbline {
namespace {

std::string described(const Json& value) {
    if (value.is_array()) return fmt::format("an array of {}", value.size());
    if (value.is_object()) return "an object";
    if (value.is_string()) return "the text " + in_quotes(value.get_ref<const std::string&>());
    return value.dump();
}

}  // namespace

std::string JsonView::place() const {
    return pointer_.empty() ? *source_ : *source_ + ": " + pointer_;
}

void JsonView::fail(const std::string& problem, const std::string& cure) const {
    throw SceneError(place(), problem, cure);
}

void JsonView::fail_type(const std::string& expected) const {
    fail("is " + described(*value_), "write " + expected);
}

void JsonView::expect_keys(std::span<const std::string> known) const {
    if (!value_->is_object()) fail_type("an object");
    for (const auto& [key, member] : value_->items()) {
        if (std::find(known.begin(), known.end(), key) != known.end()) continue;
        fail("unknown key " + in_quotes(key), did_you_mean(key, known));
    }
}

std::vector<std::string> JsonView::keys() const {
    if (!value_->is_object()) fail_type("an object");
    std::vector<std::string> names;
    for (const auto& [key, member] : value_->items()) names.push_back(key);
    return names;
}

std::optional<JsonView> JsonView::find(const std::string& key) const {
    if (!value_->is_object()) fail_type("an object");
    const auto member = value_->find(key);
    if (member == value_->end()) return std::nullopt;
    return JsonView(*source_, *member, pointer_ + '/' + key);
}

JsonView JsonView::at(const std::string& key) const {
    if (auto member = find(key)) return *std::move(member);
    fail("has no " + in_quotes(key), "add it");
}

std::vector<JsonView> JsonView::items() const {
    if (!value_->is_array()) fail_type("an array");
    std::vector<JsonView> views;
    views.reserve(value_->size());
    for (std::size_t i = 0; i < value_->size(); ++i) {
        views.push_back(JsonView(*source_, (*value_)[i], fmt::format("{}/{}", pointer_, i)));
    }
    return views;
}

std::vector<JsonView> JsonView::items(const std::string& key) const {
    const auto member = find(key);
    return member ? member->items() : std::vector<JsonView>();
}

std::vector<JsonView> JsonView::items(std::size_t count, const std::string& what) const {
    if (!value_->is_array() || value_->size() != count) fail_type(what);
    return items();
}

std::string JsonView::text() const {
    if (!value_->is_string()) fail_type("a text in quotes");
    return value_->get<std::string>();
}

bool JsonView::boolean() const {
    if (!value_->is_boolean()) fail_type("true or false");
    return value_->get<bool>();
}

double JsonView::number() const {
    if (!value_->is_number()) fail_type("a number");
    return value_->get<double>();
}

float JsonView::real() const {
    const double value = number();
    // A conversion out of range is undefined behaviour, so the range is checked in double.
    if (std::abs(value) > double{std::numeric_limits<float>::max()}) {
        fail(fmt::format("{:g} is too large for a 32-bit float", value), "stay below 3.4e38");
    }
    return static_cast<float>(value);
}

int JsonView::integer(int least, int most) const {
    const std::string range = most == std::numeric_limits<int>::max()
                                  ? fmt::format("of at least {}", least)
                                  : fmt::format("from {} to {}", least, most);
    if (!value_->is_number()) fail_type("a whole number " + range);
    const double value = value_->get<double>();
    if (value != std::floor(value) || value < least || value > most) {
        fail_type("a whole number " + range);
    }
    return static_cast<int>(value);
}

int JsonView::index(std::size_t count, const std::string& what) const {
    const int value = integer(0);
    if (static_cast<std::size_t>(value) < count) return value;
    fail(fmt::format("asks for {} {}", what, value),
         count == 0 ? "there are none" : fmt::format("there are 0 to {}", count - 1));
}

std::vector<double> JsonView::numbers(std::size_t count) const {
    std::vector<double> values;
    for (const JsonView& item : items(count, fmt::format("an array of {} numbers", count))) {
        values.push_back(item.number());
    }
    return values;
}

glm::vec3 JsonView::vec3() const {
    const auto parts = items(3, "an array of three numbers");
    return {parts[0].real(), parts[1].real(), parts[2].real()};
}

glm::ivec3 JsonView::ivec3(int least, int most) const {
    const auto parts = items(3, "an array of three whole numbers");
    return {parts[0].integer(least, most), parts[1].integer(least, most),
            parts[2].integer(least, most)};
}

glm::vec3 JsonView::vec3_or_number() const { return is_number() ? glm::vec3(real()) : vec3(); }

glm::quat JsonView::rotation() const {
    if (is_array()) {
        const auto q = items(4, "four numbers x, y, z, w, or {\"axis\", \"degrees\"}");
        const glm::quat written(q[3].real(), q[0].real(), q[1].real(), q[2].real());
        if (const auto unit = unit_rotation(written)) return *unit;
        fail(fmt::format("has length {:g}", glm::length(written)),
             "the quaternion x, y, z, w of a rotation has length 1");
    }
    expect_keys({"axis", "degrees", "radians"});
    const glm::dvec3 axis(at("axis").vec3());
    const double length = glm::length(axis);
    if (length == 0) at("axis").fail("has length zero", "[0, 1, 0] turns about the y axis");
    const auto degrees = find("degrees");
    if (degrees.has_value() == find("radians").has_value()) {
        fail("must say the angle once", "write either \"degrees\" or \"radians\"");
    }
    const double angle = degrees ? glm::radians(degrees->number()) : at("radians").number();
    const glm::dvec3 imaginary = axis * (std::sin(angle / 2) / length);
    return {static_cast<float>(std::cos(angle / 2)), static_cast<float>(imaginary.x),
            static_cast<float>(imaginary.y), static_cast<float>(imaginary.z)};
}

}  // namespace plumbline
