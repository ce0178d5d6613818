// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "scenes/nearest_name.h"
#include "scenes/parents_first.h"
#include "scenes/read_gltf.h"

namespace plumbline {
namespace {

std::vector<int> children_of(const JsonView& parent, const std::string& key, std::size_t nodes) {
    std::vector<int> children;
    for (const JsonView& child : parent.items(key)) children.push_back(child.index(nodes, "node"));
    return children;
}

/// The nodes at the top: those of the scene shown, or if there are no scenes those without parents.
std::vector<int> top_nodes(const GltfBeingRead& gltf) {
    const auto scenes = gltf.root.items("scenes");
    if (!scenes.empty()) {
        const auto chosen = gltf.root.find("scene");
        const auto shown =
            static_cast<std::size_t>(chosen ? chosen->index(scenes.size(), "scene") : 0);
        return children_of(scenes[shown], "nodes", gltf.nodes.size());
    }
    std::vector<bool> is_child(gltf.nodes.size(), false);
    for (const JsonView& node : gltf.nodes) {
        for (const int child : children_of(node, "children", gltf.nodes.size())) {
            is_child[static_cast<std::size_t>(child)] = true;
        }
    }
    std::vector<int> top;
    for (std::size_t i = 0; i < is_child.size(); ++i) {
        if (!is_child[i]) top.push_back(static_cast<int>(i));
    }
    if (top.empty() && !gltf.nodes.empty()) {
        gltf.root.at("nodes").fail("every node is the child of another", "one must be at the top");
    }
    return top;
}

/// For each node its parent, -1 at the top; none for nodes that are not shown.
std::vector<std::optional<int>> parents_of(const GltfBeingRead& gltf) {
    std::vector<std::optional<int>> parents(gltf.nodes.size());
    // A stack instead of recursion: nodes may be nested as deep as there are nodes.
    std::vector<int> waiting;
    const auto add = [&](int node, int parent) {
        std::optional<int>& known = parents[static_cast<std::size_t>(node)];
        if (known) {
            gltf.nodes[static_cast<std::size_t>(node)].fail(
                "stands in the hierarchy twice, or is its own ancestor", "a node has one parent");
        }
        known = parent;
        waiting.push_back(node);
    };
    for (const int node : top_nodes(gltf)) add(node, -1);
    while (!waiting.empty()) {
        const int node = waiting.back();
        waiting.pop_back();
        const JsonView& item = gltf.nodes[static_cast<std::size_t>(node)];
        for (const int child : children_of(item, "children", gltf.nodes.size())) add(child, node);
    }
    return parents;
}

/// Whether a node is there only for the light or the camera that it carries.
bool only_carries(const JsonView& node) {
    return (node.find("camera") || gltf_light_of(node)) && !node.find("mesh") &&
           node.items("children").empty();
}

void add_object(const JsonView& node, std::size_t index, GltfBeingRead& gltf) {
    Object object;
    object.name = gltf.object_names(node, "node", index);
    object.rest = gltf_transform(node);
    if (const auto mesh = node.find("mesh")) {
        const int shape = mesh->index(gltf.mesh_shapes.size(), "mesh");
        object.shape = gltf.mesh_shapes[static_cast<std::size_t>(shape)];
    }
    if (node.find("skin")) gltf.note("node " + in_quotes(object.name) + ": skinning");
    gltf.node_objects[index] = static_cast<int>(gltf.scene.objects.size());
    gltf.scene.objects.push_back(std::move(object));
    gltf.object_places.push_back(node.pointer());
}

}  // namespace

void read_gltf_nodes(GltfBeingRead& gltf) {
    gltf.parents = parents_of(gltf);
    for (std::size_t i = 0; i < gltf.nodes.size(); ++i) {
        if (gltf.parents[i] && !only_carries(gltf.nodes[i])) add_object(gltf.nodes[i], i, gltf);
    }
    for (std::size_t i = 0; i < gltf.nodes.size(); ++i) {
        if (gltf.node_objects[i] == -1 || *gltf.parents[i] == -1) continue;
        Object& object = gltf.scene.objects[static_cast<std::size_t>(gltf.node_objects[i])];
        object.parent = gltf.node_objects[static_cast<std::size_t>(*gltf.parents[i])];
    }
    const ParentsFirst order = put_parents_first(gltf.scene.objects);
    std::vector<int> place(order.from.size());
    std::vector<std::string> pointers;
    for (std::size_t i = 0; i < order.from.size(); ++i) {
        place[order.from[i]] = static_cast<int>(i);
        pointers.push_back(gltf.object_places[order.from[i]]);
    }
    gltf.object_places = std::move(pointers);
    for (int& object : gltf.node_objects) {
        if (object != -1) object = place[static_cast<std::size_t>(object)];
    }
}

}  // namespace plumbline
