// SPDX-License-Identifier: Apache-2.0
#include "scenes/parents_first.h"

#include <algorithm>

namespace plumbline {
namespace {

constexpr int unplaced = -1;
constexpr int on_chain = -2;

/// Those of an object and its ancestors that have no place yet, the topmost last; empty if they
/// form a cycle.
std::vector<std::size_t> unplaced_chain(const std::vector<Object>& objects, std::size_t object,
                                        std::vector<int>& place) {
    std::vector<std::size_t> chain;
    for (int i = static_cast<int>(object); i != -1;) {
        const auto index = static_cast<std::size_t>(i);
        if (place[index] == on_chain) return {};
        if (place[index] != unplaced) break;
        place[index] = on_chain;
        chain.push_back(index);
        i = objects[index].parent;
    }
    return chain;
}

}  // namespace

ParentsFirst put_parents_first(std::vector<Object>& objects) {
    ParentsFirst order;
    std::vector<int> place(objects.size(), unplaced);
    for (std::size_t i = 0; i < objects.size(); ++i) {
        if (place[i] != unplaced) continue;
        std::vector<std::size_t> chain = unplaced_chain(objects, i, place);
        if (chain.empty()) return {{}, i};
        std::reverse(chain.begin(), chain.end());
        for (const std::size_t object : chain) {
            place[object] = static_cast<int>(order.from.size());
            order.from.push_back(object);
        }
    }
    std::vector<Object> moved;
    moved.reserve(objects.size());
    for (const std::size_t from : order.from) {
        Object& object = moved.emplace_back(std::move(objects[from]));
        if (object.parent != -1) object.parent = place[static_cast<std::size_t>(object.parent)];
    }
    objects = std::move(moved);
    return order;
}

}  // namespace plumbline
