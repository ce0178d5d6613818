// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <random>

#include "scenes/ray_tracer.h"

using namespace plumbline;

namespace {

/// Two blocks whose upper faces share the plane y = 1 and overlap, among `others` small ones.
Scene overlapping_blocks(int others, std::mt19937& engine) {
    std::uniform_real_distribution<float> uniform(-3.f, 3.f);
    Scene scene;
    scene.name = "blocks";
    scene.materials = {Material{}};
    const auto add = [&](const glm::vec3& lower, const glm::vec3& upper) {
        Object object;
        object.shape = Box{lower, upper, {0, 0, 0, 0, 0, 0}};
        scene.objects.push_back(object);
    };
    add({-1.f, 0.f, -1.f}, {1.f, 1.f, 1.f});
    add({-2.f, .5f, -.5f}, {2.f, 1.f, .5f});
    for (int i = 0; i < others; ++i) {
        const glm::vec3 corner(uniform(engine), -2.f + .1f * uniform(engine), uniform(engine));
        add(corner, corner + .5f);
    }
    return scene;
}

}  // namespace

TEST_CASE("of surfaces at one distance a ray meets the first whatever else is in the scene",
          "[scenes]") {
    std::mt19937 engine(19);
    std::uniform_real_distribution<float> uniform(-1.f, 1.f);
    for (int others = 0; others < 40; ++others) {
        const Scene scene = overlapping_blocks(others, engine);
        const World world = world_at(scene, 0);
        const RayTracer tracer(world);
        for (int i = 0; i < 50; ++i) {
            const Ray ray{{uniform(engine), 3.f, .4f * uniform(engine)}, {0.f, -1.f, 0.f}};
            const auto hit = tracer.intersect(ray, BackFaces::Cull);
            REQUIRE(hit);
            REQUIRE(hit->t == Approx(2.f));
            REQUIRE(hit->object == 0);
        }
    }
}
