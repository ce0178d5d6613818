// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "scenes/errors.h"
#include "scenes/nearest_name.h"
#include "scenes/parents_first.h"
#include "scenes/read_json.h"

namespace plumbline {
namespace {

// In the order of Face.
const std::string face_names[] = {"+x", "-x", "+y", "-y", "+z", "-z"};

Box read_box(const JsonView& item, const SceneBeingRead& read) {
    item.expect_keys({"lower", "upper", "material", "faces"});
    constexpr int none = -1;
    Box box{item.at("lower").vec3(), item.at("upper").vec3(), {}};
    const auto material = item.find("material");
    box.face_materials.fill(material ? read.material(*material) : none);
    const auto faces = item.find("faces");
    if (faces) faces->expect_keys(face_names);
    for (std::size_t i = 0; i < box.face_materials.size(); ++i) {
        const auto face = faces ? faces->find(face_names[i]) : std::nullopt;
        if (face) box.face_materials[i] = read.material(*face);
        if (box.face_materials[i] == none) {
            item.fail("its face " + face_names[i] + " has no material",
                      "add \"material\" for all faces that \"faces\" does not name");
        }
    }
    return box;
}

Quad read_quad(const JsonView& item, const SceneBeingRead& read) {
    item.expect_keys({"corner", "edge_u", "edge_v", "material"});
    return {item.at("corner").vec3(), item.at("edge_u").vec3(), item.at("edge_v").vec3(),
            read.material(item.at("material"))};
}

Sphere read_sphere(const JsonView& item, const SceneBeingRead& read) {
    item.expect_keys({"center", "radius", "inward", "material"});
    const auto center = item.find("center");
    const auto inward = item.find("inward");
    return {center ? center->vec3() : glm::vec3(0.f), item.at("radius").real(),
            inward && inward->boolean(), read.material(item.at("material"))};
}

/// Reads the object that stands last in the scene but for its parent.
void read_object(const JsonView& item, SceneBeingRead& into) {
    item.expect_keys({"name", "parent", "box", "quad", "sphere", "mesh", "scale", "rotation",
                      "translation", "animation"});
    Object object;
    const auto name = item.find("name");
    object.name = name ? name->text() : fmt::format("object {}", into.scene.objects.size());
    object.rest = read_transform(item);
    if (const auto animation = item.find("animation")) {
        object.animation = read_animation(*animation);
    }
    const auto box = item.find("box");
    const auto quad = item.find("quad");
    const auto sphere = item.find("sphere");
    const auto mesh = item.find("mesh");
    if (bool(box) + bool(quad) + bool(sphere) + bool(mesh) > 1) {
        item.fail("has several shapes",
                  "keep one of \"box\", \"quad\", \"sphere\" and \"mesh\", and give the others "
                  "objects of their own");
    }
    if (box) object.shape = read_box(*box, into);
    if (quad) object.shape = read_quad(*quad, into);
    if (sphere) object.shape = read_sphere(*sphere, into);
    into.scene.objects.push_back(std::move(object));
    into.object_places.push_back(item.pointer());
    if (mesh) read_object_mesh(*mesh, into);
}

}  // namespace

void read_objects(const JsonView& list, SceneBeingRead& into) {
    struct Child {
        std::size_t object;
        JsonView parent;
    };
    std::vector<Child> children;
    std::map<std::string, int> objects;
    for (const JsonView& item : list.items()) {
        const std::size_t index = into.scene.objects.size();
        read_object(item, into);
        objects.emplace(into.scene.objects[index].name, static_cast<int>(index));
        if (const auto parent = item.find("parent")) children.push_back({index, *parent});
    }
    for (const Child& child : children) {
        into.scene.objects[child.object].parent = find_name(child.parent, objects, "object");
    }
    const ParentsFirst order = put_parents_first(into.scene.objects);
    if (order.in_cycle) {
        const std::size_t object = *order.in_cycle;
        throw SceneError(list.source() + ": " + into.object_places[object] + "/parent",
                         in_quotes(into.scene.objects[object].name) +
                             " is its own ancestor, directly or through others",
                         "leave \"parent\" out of the topmost object");
    }
    std::vector<std::string> places;
    for (const std::size_t written : order.from) places.push_back(into.object_places[written]);
    into.object_places = std::move(places);
}

}  // namespace plumbline
