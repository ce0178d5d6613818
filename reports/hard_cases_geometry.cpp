// SPDX-License-Identifier: Apache-2.0
// Geometry that ray tracers trip over, most of it in a furnace: whatever stands there, radiance
// is 2.
#include <cmath>

#include "reports/hard_case.h"
#include "reports/hard_scenes.h"

namespace plumbline::reports {
namespace {

constexpr int glowing = 0;  // the furnace's material

/// All samples bring the same series if no ray slips through or meets the surface it left.
void glows_evenly(Trial& trial, const Scene& scene, double tolerance = 1e-5) {
    const auto truth = trial.truth(scene, 0, {.spp = 64, .max_bounces = 6});
    trial.within(Trial::pathtracer, "largest deviation from the series",
                 largest_deviation(truth.image, furnace_series(6)), 0., tolerance);
    for (const std::string& model : ddgi::model_names()) trial.probes(scene, model);
}

/// The same for scenes where probes see no back: the energy-conserving models must show it too.
void glows_for_probes(Trial& trial, const Scene& scene, double tolerance = 1e-5) {
    glows_evenly(trial, scene, tolerance);
    for (const std::string& model : ddgi::model_names()) {
        if (model == "thesis") continue;  // it does not conserve energy
        trial.within(model, "largest deviation from 2",
                     largest_deviation(trial.probes(scene, model).image, furnace_radiance), 0.,
                     furnace_radiance * 2e-4);
    }
}

Box block(const glm::vec3& lower, const glm::vec3& upper) {
    return {lower, upper, {glowing, glowing, glowing, glowing, glowing, glowing}};
}

Scene furnace_with_block(const glm::vec3& lower, const glm::vec3& upper) {
    Scene scene = furnace();
    add_object(scene, "block", block(lower, upper));
    return scene;
}

/// Triangles that face +x in place of the furnace's first object, the wall at x = -1.
Scene furnace_with_wall(std::vector<glm::vec3> positions, std::vector<glm::uvec3> triangles) {
    Scene scene = furnace();
    scene.objects.erase(scene.objects.begin());
    add_mesh(scene, "wall of triangles", std::move(positions), std::move(triangles), glowing);
    return scene;
}

Scene needles() {
    // A fan of 2000 triangles from one corner: the thinnest are a thousand times as long as wide.
    std::vector<glm::vec3> positions{{-1.f, -1.f, -1.f}, {-1.f, -1.f, 1.f}};
    std::vector<glm::uvec3> triangles;
    constexpr int count = 2000;
    for (int i = 1; i <= count; ++i) {
        positions.emplace_back(-1.f, -1.f + 2.f * float(i) / count, 1.f);
        triangles.emplace_back(0u, unsigned(i + 1), unsigned(i));
    }
    positions.emplace_back(-1.f, 1.f, -1.f);
    triangles.emplace_back(0u, unsigned(count + 2), unsigned(count + 1));
    return furnace_with_wall(std::move(positions), std::move(triangles));
}

Scene t_junctions() {
    // Along z = 1/3 one long edge meets two short ones, with a vertex that the long one lacks.
    const float z = 1.f / 3.f;
    const float y = .123456789f;
    return furnace_with_wall(
        {{-1, -1, -1}, {-1, -1, z}, {-1, 1, z}, {-1, 1, -1}, {-1, y, z}, {-1, -1, 1}, {-1, 1, 1}},
        {{0, 2, 1}, {0, 3, 2}, {1, 4, 5}, {4, 6, 5}, {4, 2, 6}});
}

Scene degenerate() {
    Scene scene = furnace();
    add_mesh(scene, "no area", {{0, 0, 0}, {.5f, .5f, .5f}, {.25f, .25f, .25f}, {.1f, 0, 0}},
             {{0, 1, 2}, {3, 3, 3}, {0, 0, 1}}, glowing);
    return scene;
}

Scene doubled() {
    Scene scene = furnace();
    const glm::vec3 a(-1.f, -1.f, -1.f), b(-1.f, -1.f, 1.f), c(-1.f, 1.f, 1.f), d(-1.f, 1.f, -1.f);
    add_mesh(scene, "the wall at -x once more", {a, b, c, d, a, c}, {{0, 2, 1}, {4, 3, 5}},
             glowing);
    add_mesh(scene, "and cut along its other diagonal", {a, b, c, d}, {{1, 0, 3}, {1, 3, 2}},
             glowing);
    return scene;
}

Scene a_million_in_one_point() {
    Scene scene = furnace();
    std::vector<glm::uvec3> triangles(1'000'000, glm::uvec3(0, 1, 2));
    const glm::vec3 p(.3f, -.2f, .1f);
    add_mesh(scene, "a million triangles in a point", {p, p, p}, std::move(triangles), glowing);
    return scene;
}

/// The wall at +x, a gap off its neighbours: the furnace loses what leaves through the gap.
void gap(Trial& trial, float width) {
    Scene scene = furnace();
    scene.objects[1].rest.translation.x = width;
    const auto truth = trial.truth(scene, 0, {.spp = 64, .max_bounces = 6});
    // Four slits of 2 x width beside 24 of wall, six bounces long, each hit by few paths or none.
    trial.near(
        Trial::pathtracer, "mean radiance", mean_radiance(truth.image), furnace_series(6),
        furnace_radiance * 6. * 8. * double(width) / 24. + 5. * mean_error(truth.image) + 1e-5);
    for (const std::string& model : ddgi::model_names()) trial.probes(scene, model);
}

/// A lit half and a dark one, between them a wall thinner than the step by which rays leave it.
void thin_wall(Trial& trial) {
    Scene scene = closed_room(Spectrum(.7f));
    const float thickness = 1e-7f;
    add_object(scene, "wall",
               Box{{-thickness, -2.f, -2.f}, {thickness, 2.f, 2.f}, {0, 0, 0, 0, 0, 0}});
    add_point_light(scene, {-.5f, 0.f, 0.f}, Spectrum(1.f));
    scene.camera.eye = {.9f, 0.f, 0.f};
    scene.camera.target = {0.f, 0.f, 0.f};
    const auto truth = trial.truth(scene, 0, {.spp = 256});
    trial.within(Trial::pathtracer, "mean radiance of the dark half", mean_radiance(truth.image),
                 0., 0.);
    for (const std::string& model : ddgi::model_names()) trial.probes(scene, model);
}

/// A camera that looks along the floor at 89.999 degrees from its normal.
void grazing(Trial& trial) {
    Scene scene = furnace();
    const float height = .9f * std::tan(.001f * 3.14159265f / 180.f);
    scene.camera.eye = {-.9f, -1.f + height, 0.f};
    scene.camera.target = {0.f, -1.f, 0.f};
    scene.camera.vertical_fov = .002f;
    // It looks into the far corner of the floor, so closely that a few hits lie nearer to the edge
    // than a float's rounding, and may leave through it: one of 64 samples, of radiance 2 at most.
    glows_for_probes(trial, scene, furnace_radiance / 64.);
}

/// Two-sided surfaces have no winding.
void winding(Trial& trial) {
    Scene right = lit_room();
    for (Material& material : right.materials) material.two_sided = true;
    Scene wrong = right;
    for (Object& object : wrong.objects) {
        if (Quad* quad = std::get_if<Quad>(&object.shape)) std::swap(quad->edge_u, quad->edge_v);
    }
    const Image expected = pathtracer::render(right, 0, {.spp = 64}).image;
    const Image truth = trial.truth(wrong, 0, {.spp = 64}).image;
    trial.near(Trial::pathtracer, "mean radiance against the right winding", mean_radiance(truth),
               mean_radiance(expected), 5. * (mean_error(truth) + mean_error(expected)));
    for (const std::string& model : ddgi::model_names()) {
        ddgi::DdgiOptions options;
        options.model = model;
        const double plain = mean_radiance(ddgi::render(right, 0, options).image);
        trial.near(model, "mean radiance against the right winding",
                   mean_radiance(trial.probes(wrong, model, 0, options).image), plain,
                   1e-3 * plain);
    }
}

/// One-sided walls that all face out: a camera inside sees through them, and nothing else.
void inside_out(Trial& trial) {
    Scene scene = lit_room();
    scene.objects.pop_back();  // the block
    for (Object& object : scene.objects) {
        Quad& quad = std::get<Quad>(object.shape);
        std::swap(quad.edge_u, quad.edge_v);
    }
    const auto truth = trial.truth(scene, 0, {.spp = 16});
    trial.within(Trial::pathtracer, "mean radiance", mean_radiance(truth.image), 0., 0.);
    for (const std::string& model : ddgi::model_names()) trial.probes(scene, model);
}

Scene transformed_block(const glm::vec3& scale) {
    Scene scene = furnace_with_block(glm::vec3(-.3f), glm::vec3(.3f));
    scene.objects.back().rest.scale = scale;
    scene.objects.back().rest.rotation = glm::angleAxis(.7f, glm::normalize(glm::vec3(1, 2, 3)));
    scene.objects.back().rest.translation = {.2f, -.4f, .2f};
    return scene;
}

}  // namespace

void add_geometry_cases(std::vector<HardCase>& cases) {
    const char* series = "every sample is 2 - 2^-7 after six bounces, to rounding";
    const auto add = [&](const char* name, Scene scene) {
        cases.push_back({"geometry", name, series,
                         [scene = std::move(scene)](Trial& t) { glows_evenly(t, scene); }});
    };
    const auto law = [&](const char* name, const char* text, void (*run)(Trial&)) {
        cases.push_back({"geometry", name, text, run});
    };
    add("block whose bottom lies in the floor",
        furnace_with_block({-.4f, -1.f, -.2f}, {.3f, -.2f, .5f}));
    add("block sunk into two walls", furnace_with_block({-1.f, -1.f, .2f}, {-.2f, -.5f, 1.f}));
    add("needle triangles", needles());
    add("T-junctions", t_junctions());
    add("triangles without area", degenerate());
    add("coplanar walls and doubled vertices", doubled());
    add("a million triangles in one point", a_million_in_one_point());
    add("mirrored block, unevenly scaled", transformed_block({-1.5f, .4f, .9f}));
    add("block scaled to a thousandth along one axis", transformed_block({1.f, .001f, 1.f}));
    add("camera inside a block", furnace_with_block({-.8f, .1f, -.9f}, {-.6f, .3f, -.7f}));
    law("camera on a wall", series, [](Trial& t) {
        Scene scene = furnace();
        scene.camera.eye = {0.f, 0.f, -1.f};
        glows_for_probes(t, scene);
    });
    law("grazing view at 89.999 degrees",
        "the series, but for a sample a pixel that lies in the edge of two walls", grazing);
    for (const float width : {1e-7f, 1e-4f}) {
        cases.push_back({"geometry", width < 1e-6f ? "gap of 1e-7" : "gap of 1e-4",
                         "no more is lost than the gap's share of the walls",
                         [=](Trial& t) { gap(t, width); }});
    }
    law("wall thinner than the ray offset", "not a photon comes through: black to the bit",
        thin_wall);
    law("inconsistent winding of two-sided walls", "the picture of the right winding", winding);
    law("all walls face out", "black: backs let camera rays pass and reflect nothing", inside_out);
}

}  // namespace plumbline::reports
