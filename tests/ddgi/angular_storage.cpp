// SPDX-License-Identifier: Apache-2.0
#include "ddgi/angular_storage.h"

#include <catch2/catch.hpp>
#include <glm/gtc/constants.hpp>

#include "ddgi/angular_bins.h"
#include "ddgi/harmonics.h"
#include "ddgi/spectral_radius.h"
#include "tests/ddgi/small_scenes.h"

using namespace plumbline;
using namespace plumbline::ddgi;

namespace {

constexpr double pi = glm::pi<double>();

const std::vector<Storage> stored{Storage::Octants, Storage::Equal32, Storage::Equal128,
                                  Storage::Sh2,     Storage::Sh3,     Storage::Octahedral};

/// Two probes that hold what their rays bring, and a look-up half-way between them.
struct TwoProbes {
    ProbeGrid grid{glm::vec3(0.f), 1.f, {2, 1, 1}};
    std::unique_ptr<AngularStorage> storage;
    SurfelCache cache;
    std::vector<float> values;

    TwoProbes(Storage kind, int rays)
        : storage(make_storage(kind, grid)),
          cache(grid, storage->pattern(rays, true), Reach::FirstSurface),
          values(2 * 3 * storage->bins()) {
        storage->take_surfels(cache);
    }

    template <typename Radiance>
    void light(const Radiance& radiance_from) {
        const std::size_t per_probe = values.size() / 2;
        for (std::uint32_t probe = 0; probe < 2; ++probe) {
            std::vector<RayLight> rays;
            for (const glm::vec3& w : probe_directions(cache.pattern(), probe_cell(grid, probe)))
                rays.push_back({w, radiance_from(w)});
            storage->store(rays, std::span(values).subspan(probe * per_probe, per_probe));
        }
    }

    Spectrum irradiance(const glm::vec3& n) const {
        return storage->irradiance(probe_neighbours(grid, {.5f, 0.f, 0.f}), values, n);
    }
};

}  // namespace

TEST_CASE("every storage gives even radiance back as pi times as much irradiance",
          "[ddgi][storage][analytic]") {
    const Storage kind = GENERATE(from_range(stored));
    const int rays = GENERATE(16, 64);
    TwoProbes probes(kind, rays);
    const Spectrum L(1.f, .3f, 7.f);
    probes.light([&](const glm::vec3&) { return L; });
    for (const glm::vec3& n : sphere_pattern(256, false).directions) {
        const Spectrum E = probes.irradiance(n);
        for (int c = 0; c < 3; ++c) REQUIRE(E[c] == Approx(pi * double(L[c])).epsilon(1e-5));
    }
}

TEST_CASE("radiance that goes with a direction comes back as the integral of the cosine",
          "[ddgi][storage][analytic]") {
    // Of L(w) = a + b w_x: E(n) = pi a + 2 pi / 3 b n_x, the first two of the A_l.
    const auto [kind, tolerance] = GENERATE(table<Storage, double>({{Storage::Sh2, .005},
                                                                    {Storage::Sh3, .005},
                                                                    {Storage::Octahedral, .08},
                                                                    {Storage::Equal128, .05},
                                                                    {Storage::Equal32, .12},
                                                                    {Storage::Octants, .45}}));
    TwoProbes probes(kind, 1024);
    probes.light([](const glm::vec3& w) { return Spectrum(1.f + .8f * w.x); });
    double largest = 0.;
    for (const glm::vec3& n : sphere_pattern(256, false).directions) {
        const double expected = pi + 2. * pi / 3. * .8 * double(n.x);
        largest = std::max(largest, std::abs(double(probes.irradiance(n).g) - expected));
    }
    CHECK(largest < tolerance * pi);
}

TEST_CASE("harmonics of order 3 carry the cosine's square and those of order 2 only its mean",
          "[ddgi][storage][analytic]") {
    // w_z^2 = 1/3 + 2/3 P_2(w_z), so E(n) = pi / 3 + 2/3 pi / 4 P_2(n_z).
    TwoProbes third(Storage::Sh3, 1024);
    TwoProbes second(Storage::Sh2, 1024);
    const auto square = [](const glm::vec3& w) { return Spectrum(w.z * w.z); };
    third.light(square);
    second.light(square);
    for (const glm::vec3& n : sphere_pattern(64, false).directions) {
        const double P2 = (3. * double(n.z) * double(n.z) - 1.) / 2.;
        CHECK(third.irradiance(n).r == Approx(pi / 3. + pi / 6. * P2).margin(.01));
        CHECK(second.irradiance(n).r == Approx(pi / 3.).margin(.01));
    }
}

TEST_CASE("harmonics are orthonormal over the sphere", "[ddgi][storage][analytic]") {
    std::array<std::array<double, 9>, 9> product{};
    const std::vector<glm::vec3> directions = sphere_pattern(4096, false).directions;
    for (const glm::vec3& w : directions) {
        const auto Y = harmonics(w);
        for (std::size_t i = 0; i < 9; ++i)
            for (std::size_t j = 0; j < 9; ++j)
                product[i][j] += double(Y[i]) * double(Y[j]) * 4. * pi / 4096.;
    }
    for (std::size_t i = 0; i < 9; ++i)
        for (std::size_t j = 0; j < 9; ++j)
            CHECK(product[i][j] == Approx(i == j ? 1. : 0.).margin(2e-3));
}

TEST_CASE("cells of equal solid angle take equally many even rays", "[ddgi][storage]") {
    const auto [layers, sectors] = GENERATE(table<int, int>({{4, 8}, {8, 16}}));
    const EqualStorage storage(layers, sectors);
    std::vector<int> count(storage.bins());
    const std::vector<glm::vec3> rays = sphere_pattern(4096, false).directions;
    for (const glm::vec3& w : rays) ++count[storage.cell_of(w)];
    for (const int rays_in_cell : count)
        CHECK(double(rays_in_cell) * double(count.size()) == Approx(4096.).epsilon(.2));
}

TEST_CASE("no storage feeds itself more than the largest albedo", "[ddgi][storage]") {
    const Scene scene = room_with_moving_block();
    DdgiOptions options;
    options.probes.storage = GENERATE(from_range(stored));
    ProbeVolume volume(scene, options);
    volume.move_to(0);
    std::vector<float> mode;
    const SpectralRadius radius = spectral_radius(
        volume.model(), probe_count(volume.cache().grid()), volume.values().size(), mode);
    CHECK(radius.settled);
    CHECK(radius.value < .9);
    CHECK(radius.value > .2);
}
