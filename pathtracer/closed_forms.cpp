// SPDX-License-Identifier: Apache-2.0
#include "pathtracer/closed_forms.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "pathtracer/simple_scenes.h"

namespace plumbline::pathtracer {
namespace {

using std::numbers::pi;

constexpr float floor_albedo = .6f;

/// A wide floor at y = 0 of `floor_albedo`.
Scene floor_scene() {
    Scene scene;
    scene.name = "floor";
    const int grey = add_material(scene, Spectrum(floor_albedo));
    add_object(scene, Quad{{-50.f, 0.f, -50.f}, {0.f, 0.f, 100.f}, {100.f, 0.f, 0.f}, grey});
    return scene;
}

/// Looks at the floor's point (x, 0, 0), low enough to pass below what shines on it.
Ray at_floor(float x) {
    const glm::vec3 eye(x - 3.f, .5f, 0.f);
    return {eye, glm::normalize(glm::vec3(x, 0.f, 0.f) - eye)};
}

/// (rho / pi) E of the floor under `scene`'s lights.
ClosedForm lit_floor(const std::string& name, const std::string& formula, const std::string& source,
                     const Scene& scene, float x, double E) {
    return {name, formula, source, scene, at_floor(x), 0, double(floor_albedo) / pi * E};
}

/// A sphere that faces inward.
Scene hollow_sphere(float radius, float rho) {
    Scene scene;
    scene.name = "hollow sphere";
    const int wall = add_material(scene, Spectrum(rho));
    add_object(scene, Sphere{glm::vec3(0.f), radius, true, wall});
    return scene;
}

ClosedForm furnace(float rho, std::optional<int> max_bounces) {
    constexpr double Le = .25;
    Scene scene;
    scene.name = "furnace";
    const int wall = add_material(scene, Spectrum(rho), Spectrum(float(Le)));
    for (const Quad& quad : room_walls({wall, wall, wall, wall, wall, wall})) {
        add_object(scene, quad);
    }
    const std::string end = max_bounces ? fmt::format(" + rho^{}", *max_bounces + 1) : "";
    double sum = 1. / (1. - double(rho));
    if (max_bounces) sum *= 1. - std::pow(double(rho), *max_bounces + 2);
    return {fmt::format("furnace of albedo {:g}, {}", rho,
                        max_bounces ? fmt::format("{} bounces", *max_bounces) : "all bounces"),
            "Le (1 + rho + ..." + end + ")",
            "geometric series",
            scene,
            {{.1f, .2f, .3f}, glm::normalize(glm::vec3(1.f, -.3f, .2f))},
            max_bounces,
            Le * sum};
}

ClosedForm unit_sphere(float rho, std::optional<int> max_bounces, const std::string& name) {
    Scene scene = hollow_sphere(1.f, rho);
    scene.lights = {inverse_square(glm::vec3(0.f), Spectrum(std::numbers::pi_v<float>))};
    return {name,
            "1",
            "[Pharr et al. 2023], its analytic test scenes",
            scene,
            {glm::vec3(0.f), {0.f, .6f, .8f}},
            max_bounces,
            1.};
}

ClosedForm lamp_in_sphere() {
    // Between points of a sphere the form factor is the same for all, so that what is scattered
    // arrives evenly wherever the lamp is.
    constexpr float rho = .8f, radius = 40.f, intensity = 3000.f;
    const glm::vec3 light = radius * glm::vec3(.2f, .3f, -.1f);
    Scene scene = hollow_sphere(radius, rho);
    scene.lights = {inverse_square(light, Spectrum(intensity))};
    const glm::vec3 direction = glm::normalize(glm::vec3(1.f, -.4f, .7f));
    const glm::dvec3 to_light = glm::dvec3(light) - double(radius) * glm::dvec3(direction);
    const double d2 = glm::dot(to_light, to_light);
    const double cosine = glm::dot(to_light, -glm::dvec3(direction)) / std::sqrt(d2);
    const double E = double(intensity) / double(radius * radius) * double(rho / (1.f - rho));
    return {"integrating sphere, lamp off its centre",
            "(rho/pi) (I cos / d^2 + (I / R^2) rho / (1 - rho))",
            "[Jacquez and Kuppenheim 1955]",
            scene,
            {glm::vec3(0.f), direction},
            {},
            double(rho) / pi * (double(intensity) * cosine / d2 + E)};
}

ClosedForm ball_in_sphere() {
    constexpr float Le = 50.f, rho = .8f, share = .01f;  // the wall's form factor to the ball
    Scene scene = hollow_sphere(1.f, rho);
    const int glowing = add_material(scene, Spectrum(0.f), Spectrum(Le));
    add_object(scene, Sphere{glm::vec3(0.f), std::sqrt(share), false, glowing});
    return {"integrating sphere, black glowing ball at its centre",
            "rho Le k / (1 - rho (1 - k)), k = (r/R)^2",
            "[Howell et al. 2010], concentric spheres",
            scene,
            {{.5f, 0.f, 0.f}, {0.f, .6f, .8f}},
            {},
            double(rho * Le * share) / (1. - double(rho) * (1. - double(share)))};
}

/// `shape` glows in `scene` with radiance Le.
Scene with_glowing(Scene scene, float Le, const auto& shape_of) {
    const int glowing = add_material(scene, Spectrum(0.f), Spectrum(Le));
    add_object(scene, shape_of(glowing));
    return scene;
}

ClosedForm parallel_rectangle() {
    constexpr double a = 2., b = 3., c = 1.5, Le = 4.;
    const Scene scene = with_glowing(floor_scene(), Le, [&](int glowing) {
        return Quad{{0.f, c, 0.f}, {float(a), 0.f, 0.f}, {0.f, 0.f, float(b)}, glowing};
    });
    const double A = a / c, B = b / c;
    const double sA = std::sqrt(1. + A * A), sB = std::sqrt(1. + B * B);
    const double factor = (A / sA * std::atan(B / sA) + B / sB * std::atan(A / sB)) / (2. * pi);
    return lit_floor("glowing rectangle over a floor",
                     "rho Le F, F = (A/sA atan(B/sA) + B/sB atan(A/sB)) / 2 pi",
                     "[Howell et al. 2010], factor B-3", scene, 0.f, pi * Le * factor);
}

ClosedForm upright_rectangle() {
    constexpr double a = 3., b = 2., c = .8, Le = 4.;
    const Scene scene = with_glowing(floor_scene(), Le, [&](int glowing) {
        return Quad{{float(c), 0.f, 0.f}, {0.f, 0.f, float(b)}, {0.f, float(a), 0.f}, glowing};
    });
    const double X = a / b, Y = c / b, root = std::sqrt(X * X + Y * Y);
    const double factor = (std::atan(1. / Y) - Y / root * std::atan(1. / root)) / (2. * pi);
    return lit_floor("glowing rectangle upright on a floor",
                     "rho Le F, F = (atan(1/Y) - Y/s atan(1/s)) / 2 pi",
                     "[Howell et al. 2010], factor B-4", scene, 0.f, pi * Le * factor);
}

ClosedForm glowing_sphere() {
    constexpr float Le = 3.f, r = 1.f, d = 2.5f;
    const Scene scene = with_glowing(floor_scene(), Le, [&](int glowing) {
        return Sphere{{0.f, d, 0.f}, r, false, glowing};
    });
    return lit_floor("glowing sphere over a floor", "rho Le (r/d)^2", "[Howell et al. 2010]", scene,
                     0.f, pi * double(Le * r * r / (d * d)));
}

/// One light of intensity 7 at height 2 over the floor's origin, seen at x.
ClosedForm under_light(const std::string& name, const std::string& formula, float x,
                       const PointLight& light, double share = 1.) {
    Scene scene = floor_scene();
    scene.lights = {light};
    const double d2 = 4. + double(x) * double(x);
    const double E = light.falloff == Falloff::None ? pi * double(light.white_radiance.x)
                                                    : double(light.intensity.x) / d2;
    return lit_floor(name, formula, "inverse-square and cosine law", scene, x,
                     share * E * 2. / std::sqrt(d2));
}

/// So many lights, from the floor's origin outward, that one is chosen at each surface.
ClosedForm under_a_row_of_lights() {
    Scene scene = floor_scene();
    double E = 0.;
    for (int i = 0; i < 20; ++i) {
        const glm::vec3 position(float(i) * .25f, 1.f, 0.f);
        scene.lights.push_back(inverse_square(position, Spectrum(.2f * float(i % 3 + 1))));
        const double d2 = glm::dot(glm::dvec3(position), glm::dvec3(position));
        E += double(scene.lights.back().intensity.x) / (d2 * std::sqrt(d2));
    }
    return lit_floor("twenty lights over a floor, one at a time", "(rho/pi) sum of I cos / d^2",
                     "inverse-square and cosine law", scene, 0.f, E);
}

void add_lights(std::vector<ClosedForm>& forms) {
    forms.push_back(under_a_row_of_lights());
    const PointLight point = inverse_square({0.f, 2.f, 0.f}, Spectrum(7.f));
    forms.push_back(under_light("point light over a floor", "(rho/pi) I cos / d^2", 1.5f, point));
    PointLight constant = point;
    constant.falloff = Falloff::None;
    constant.white_radiance = Spectrum(.5f);
    forms.push_back(under_light("point light without falloff", "rho c cos", 1.5f, constant));
    PointLight ball = point;
    ball.radius = .5f;
    forms.push_back(under_light("ball of light over a floor", "(rho/pi) I cos / d^2", 1.5f, ball));
    PointLight spot = point;
    const float inner = .3f, outer = .7f, angle = .5f;
    spot.cone = SpotCone{{0.f, -1.f, 0.f}, inner, outer};
    const double ramp = (std::cos(double(angle)) - std::cos(double(outer))) /
                        (std::cos(double(inner)) - std::cos(double(outer)));
    forms.push_back(under_light("spot, half into its rim", "ramp^2 (rho/pi) I cos / d^2",
                                2.f * std::tan(angle), spot, ramp * ramp));
    Scene sun = floor_scene();
    sun.directional_lights = {{"sun", {3.f, -4.f, 0.f}, Spectrum(2.f)}};
    forms.push_back(
        lit_floor("directional light", "(rho/pi) E cos", "cosine law", sun, 0.f, 2. * .8));
    Scene sky = floor_scene();
    sky.environment = Spectrum(1.f);
    forms.push_back(lit_floor("even sky", "rho L", "integral of the cosine is pi", sky, 0.f, pi));
}

}  // namespace

std::vector<ClosedForm> closed_forms() {
    std::vector<ClosedForm> forms{
        furnace(.5f, 0),
        furnace(.9f, 8),
        furnace(.5f, {}),
        unit_sphere(1.f, 0, "unit sphere, lamp of intensity pi, direct light on white"),
        unit_sphere(.5f, {}, "unit sphere, lamp of intensity pi, all bounces on 1/2"),
        lamp_in_sphere(),
        ball_in_sphere(),
        parallel_rectangle(),
        upright_rectangle(),
        glowing_sphere()};
    add_lights(forms);
    return forms;
}

}  // namespace plumbline::pathtracer
