// SPDX-License-Identifier: Apache-2.0
#include <ceres/jet.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "ddgi/thesis_model.h"
#include "scenes/errors.h"

using namespace plumbline;
using namespace plumbline::ddgi;

namespace {

/// A grid of 4 x 3 x 5 probes whose surfels are made up at random, hits and misses.
struct TinyField {
    ProbeGrid grid{{-1.f, 2.f, 3.f}, 1.5f, {4, 3, 5}};
    RayPattern pattern = thesis_pattern(64);
    Surfels surfels;
    std::vector<float> values;  ///< what the probes held last

    TinyField() {
        std::mt19937 random(7);
        std::uniform_real_distribution<float> unit(0.f, 1.f);
        const auto spectrum = [&] { return Spectrum(unit(random), unit(random), unit(random)); };
        surfels.resize(probe_count(grid), pattern.size());
        for (std::size_t i = 0; i < surfels.size(); ++i) {
            if (unit(random) < .4f) continue;
            surfels.place[i].distance = 2.f * unit(random);
            surfels.place[i].position = grid.origin + 8.f * spectrum() - 1.f;
            surfels.place[i].n = glm::normalize(spectrum() - .5f);
            surfels.light[i].albedo = spectrum();
            surfels.light[i].direct = 20.f * spectrum();
        }
        values.resize(probe_count(grid) * 3 * octant_count);
        for (float& value : values) value = unit(random);
    }

    ThesisField field() const { return {grid, pattern, surfels}; }
};

/// The published formulas once more, a probe and a direction at a time, in double, from the text.
class ByTheBook {
 public:
    ByTheBook(const TinyField& tiny, const ThesisParameters<float>& p) : tiny_(tiny), p_(p) {}

    double value(int x, int y, int z, int d, int channel) const {
        const double h = tiny_.grid.spacing;
        const auto probe = static_cast<std::size_t>(y * 4 * 5 + x * 5 + z);
        double sum = 0.;
        for (int ray = 0; ray < 64; ++ray) {
            const glm::dvec3 dir(tiny_.pattern.directions[std::size_t(ray)]);
            if (owner(dir) != d) continue;
            const std::size_t surfel = probe * 64 + std::size_t(ray);
            sum += std::isfinite(tiny_.surfels.place[surfel].distance)
                       ? hit(surfel, dir, d, channel)
                       : at(neighbour(x, y, z, d), d, channel) * double(p_.falloffRegulator) /
                             (2. * h * h);
        }
        return sum / 8.;
    }

    double Q(const glm::dvec3& x, const glm::dvec3& n, int channel) const {
        glm::dvec3 g = (x - glm::dvec3(tiny_.grid.origin)) / double(tiny_.grid.spacing);
        g = glm::clamp(g, glm::dvec3(0.), glm::dvec3(3., 2., 4.));
        double sum = 0.;
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j < 3; ++j) {
                for (int k = 0; k < 5; ++k) {
                    const double tent = hat(g.x - i) * hat(g.y - j) * hat(g.z - k);
                    if (tent == 0.) continue;
                    for (int d = 0; d < 8; ++d) {
                        sum += tent * at({i, j, k}, d, channel) * std::max(0., glm::dot(n, D(d)));
                    }
                }
            }
        }
        return sum;
    }

 private:
    static double hat(double x) { return std::max(0., 1. - std::abs(x)); }
    static glm::dvec3 D(int d) {
        static const glm::dvec3 all[] = {{1, 1, 0},  {0, 1, 1},  {-1, 1, 0},  {0, 1, -1},
                                         {1, -1, 0}, {0, -1, 1}, {-1, -1, 0}, {0, -1, -1}};
        return all[d];
    }
    /// The principal direction that a ray is nearest to.
    static int owner(const glm::dvec3& dir) {
        int nearest = 0;
        for (int d = 1; d < 8; ++d) {
            if (glm::dot(dir, D(d)) > glm::dot(dir, D(nearest))) nearest = d;
        }
        return nearest;
    }
    static glm::ivec3 neighbour(int x, int y, int z, int d) {
        const glm::ivec3 inner(x < 1 ? 1 : x > 2 ? 2 : x, 1, z < 1 ? 1 : z > 3 ? 3 : z);
        (void)y;
        return inner + glm::ivec3(D(d));
    }
    double at(const glm::ivec3& c, int d, int channel) const {
        const auto probe = static_cast<std::size_t>(c.y * 4 * 5 + c.x * 5 + c.z);
        return double(tiny_.values[probe * 24 + std::size_t(channel) * 8 + std::size_t(d)]);
    }
    double hit(std::size_t s, const glm::dvec3& dir, int d, int channel) const {
        const Surfels& surfels = tiny_.surfels;
        const double white = double(surfels.light[s].direct[channel]) / 3.14159265358979;
        const double lit = double(surfels.light[s].albedo[channel]) *
                           (white + double(p_.multiBounceIntensity) *
                                        Q(surfels.place[s].position, surfels.place[s].n, channel)) *
                           double(p_.bounceAttenuation);
        const double d2 = double(surfels.place[s].distance) * double(surfels.place[s].distance);
        return std::min(1., lit) * std::max(0., glm::dot(dir, D(d) / std::sqrt(2.))) /
               std::max(1., d2);
    }

    const TinyField& tiny_;
    ThesisParameters<float> p_;
};

template <typename T>
std::vector<T> updated(const TinyField& tiny, const ThesisParameters<T>& parameters) {
    const std::vector<T> previous(tiny.values.begin(), tiny.values.end());
    std::vector<T> lit(previous.size());
    std::vector<T> next(previous.size());
    thesis_lit<T>(tiny.field(), parameters, previous, lit);
    thesis_propagate<T>(tiny.grid, thesis_miss_shares(tiny.field()),
                        thesis_propagation(parameters.falloffRegulator, tiny.grid.spacing), lit,
                        previous, next);
    return next;
}

}  // namespace

TEST_CASE("the thesis's update agrees with its text, one probe and direction at a time", "[ddgi]") {
    const TinyField tiny;
    // The second pair makes some surfels reach the clamp.
    const auto b = GENERATE(.1f, .8f);
    const auto m = GENERATE(0.f, .6f);
    const ThesisParameters<float> parameters{3.7f, b, 1.f, m};
    const std::vector<float> next = updated(tiny, parameters);
    const ByTheBook book(tiny, parameters);
    std::size_t index = 0;
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 4; ++x) {
            for (int z = 0; z < 5; ++z) {
                for (int c = 0; c < 3; ++c) {
                    for (int d = 0; d < 8; ++d) {
                        INFO("probe " << x << " " << y << " " << z << ", c " << c << ", d " << d);
                        REQUIRE(next[index++] == Approx(book.value(x, y, z, d, c)).epsilon(1e-5));
                    }
                }
            }
        }
    }
}

TEST_CASE("the thesis's look-up takes the principal directions as published, length sqrt 2",
          "[ddgi]") {
    const TinyField tiny;
    const ByTheBook book(tiny, {});
    for (const glm::vec3 x : {glm::vec3(.3f, 3.1f, 5.2f), glm::vec3(-9.f, 4.f, 30.f)}) {
        const glm::vec3 n = glm::normalize(glm::vec3(.3f, -.5f, .7f));
        const auto Q = thesis_look_up<float>(tiny.grid, tiny.values, x, n);
        for (int c = 0; c < 3; ++c) CHECK(Q[std::size_t(c)] == Approx(book.Q(x, n, c)));
    }
    // Straight up, the four upper directions count 1 each, not 1 / sqrt 2.
    const std::vector<float> ones(tiny.values.size(), 1.f);
    CHECK(thesis_look_up<float>(tiny.grid, ones, tiny.grid.origin, {0, 1, 0})[0] == Approx(4.f));
}

TEST_CASE("dual numbers give the update's derivatives in the constants", "[ddgi]") {
    using Jet = ceres::Jet<double, 2>;
    const TinyField tiny;
    const std::vector<Jet> next = updated<Jet>(tiny, {Jet(3.7, 0), Jet(.1, 1), Jet(1.), Jet(.6)});
    const double step = 1e-5;
    const auto shifted = [&](double regulator, double b) {
        return updated<double>(tiny, {3.7 + regulator, .1 + b, 1., .6});
    };
    const auto more_f = shifted(step, 0.), less_f = shifted(-step, 0.);
    const auto more_b = shifted(0., step), less_b = shifted(0., -step);
    const auto as_float = updated<float>(tiny, {3.7f, .1f, 1.f, .6f});
    for (std::size_t i = 0; i < next.size(); ++i) {
        REQUIRE(next[i].a == Approx(double(as_float[i])).epsilon(1e-5));
        REQUIRE(next[i].v[0] == Approx((more_f[i] - less_f[i]) / (2. * step)).margin(1e-7));
        REQUIRE(next[i].v[1] == Approx((more_b[i] - less_b[i]) / (2. * step)).margin(1e-7));
    }
}

TEST_CASE("constants come from the scene, and are set by their published names", "[ddgi]") {
    Scene scene;
    scene.name = "tiny";
    scene.probes = ProbeGrid{{}, 20.f, {5, 5, 5}};
    scene.thesis = ThesisConstants{690.f, .05f, 50.f, 8.4f, .01f, 1.8f};
    std::vector<std::string> notes;

    SECTION("as published, with feedback off") {
        ThesisConstants expected = *scene.thesis;
        expected.multiBounceIntensity = 0.f;
        CHECK(thesis_constants(scene, *scene.probes, {}, notes) == expected);
        CHECK(notes.empty());
    }
    SECTION("set by name") {
        const auto constants = thesis_constants(
            scene, *scene.probes, {{"probeBrightness", 101.}, {"multiBounceIntensity", 2.}}, notes);
        CHECK(constants.probeBrightness == 101.f);
        CHECK(constants.multiBounceIntensity == 2.f);
        CHECK(constants.bounceAttenuation == .05f);
    }
    SECTION("another spacing keeps what a missed ray brings, and says so") {
        const ProbeGrid coarse{{}, 40.f, {3, 3, 3}};
        CHECK(thesis_constants(scene, coarse, {}, notes).falloffRegulator == Approx(4. * 690.));
        CHECK(notes.size() == 1);
    }
    SECTION("a scene without any takes the Cornell Box's, and says so") {
        scene.thesis.reset();
        const ProbeGrid small{{}, 2.f, {5, 5, 5}};
        const auto constants = thesis_constants(scene, small, {}, notes);
        CHECK(thesis_propagation(constants.falloffRegulator, 2.f) == Approx(.85f));
        CHECK(notes.size() == 2);
    }
    SECTION("a name or value that makes no sense is refused") {
        CHECK_THROWS_WITH(thesis_constants(scene, *scene.probes, {{"probeBrightnes", 1.}}, notes),
                          Catch::Contains("did you mean \"probeBrightness\"?"));
        CHECK_THROWS_AS(thesis_constants(scene, *scene.probes, {{"ambient", -1.}}, notes),
                        UsageError);
        CHECK_THROWS_AS(thesis_constants(scene, *scene.probes, {{"ambient", NAN}}, notes),
                        UsageError);
    }
}
