// SPDX-License-Identifier: Apache-2.0
#include "compare/energy_audit.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "compare/surface_points.h"
#include "ddgi/seen_probes.h"
#include "ddgi/volume.h"
#include "scenes/panorama.h"
#include "tests/ddgi/small_scenes.h"

using namespace plumbline;
using namespace plumbline::compare;

namespace {

constexpr int points = 2000;

EnergyAudit audit_of(const Scene& scene, const std::string& model, int bounces) {
    ddgi::DdgiOptions options;
    options.model = model;
    return energy_audit(scene, 0, options, bounces, points);
}

}  // namespace

TEST_CASE("the audit of a furnace is the series of its albedo", "[compare][audit]") {
    const float rho = GENERATE(0.3f, 0.8f);
    const EnergyAudit audit =
        audit_of(ddgi::closed_room(Spectrum(rho), Spectrum(2.f)), "conserving", 4);
    const double area = 6 * 4, flux = glm::pi<double>() * 2 * area;
    CHECK(audit.area == Approx(area));
    CHECK(audit.unseen_area == Approx(0).margin(1e-9));
    CHECK(audit.direct == Approx(flux).epsilon(1e-5));
    for (const BounceEnergy& one : audit.bounces) {
        const double arriving = flux * std::pow(double(rho), one.bounce - 1);
        // Rounding of single precision, which differences of updates raise.
        CHECK(one.arriving == Approx(arriving).epsilon(1e-4));
        CHECK(one.absorbed == Approx((1 - double(rho)) * arriving).epsilon(1e-4));
        CHECK(one.shown == Approx(double(rho) * arriving).epsilon(1e-4));
        CHECK(one.invented == Approx(0).margin(1e-4 * arriving));
        CHECK(one.arriving == Approx(one.absorbed + one.reflected));
    }
}

TEST_CASE("the audit of an integrating sphere finds the light's flux in every bounce",
          "[compare][audit]") {
    // In the middle of the sphere all of the light's 4 pi I arrives, evenly; rho of it leaves, and
    // in a closed sphere all that leaves arrives [Jacquez and Kuppenheim 1955].
    const EnergyAudit audit =
        audit_of(ddgi::integrating_sphere(0.6f, glm::vec3(0.f)), "conserving", 3);
    const double flux = 4 * glm::pi<double>();
    CHECK(audit.area == Approx(4 * glm::pi<double>() * 4).epsilon(1e-3));
    CHECK(audit.direct == Approx(0.6 * flux).epsilon(2e-3));
    for (const BounceEnergy& one : audit.bounces) {
        CHECK(one.arriving == Approx(std::pow(0.6, one.bounce) * flux).epsilon(3e-3));
        CHECK(one.invented == Approx(0).margin(3e-3 * one.arriving));
    }
}

TEST_CASE("the audit of the thesis shows one bounce in proportion to its constants",
          "[compare][audit]") {
    const Scene scene = ddgi::room_with_moving_block();
    Scene brighter = scene;
    brighter.thesis->probeBrightness *= 2;
    const EnergyAudit once = audit_of(scene, "thesis", 2), twice = audit_of(brighter, "thesis", 2);
    CHECK(once.bounces[0].shown > 0);
    CHECK(twice.bounces[0].shown == Approx(2 * once.bounces[0].shown).epsilon(1e-5));
    CHECK(twice.bounces[0].reflected == Approx(once.bounces[0].reflected).epsilon(1e-5));
    CHECK(once.bounces[1].shown == 0);
    CHECK(once.bounces[1].arriving > 0);
    CHECK(once.bounces[1].invented == Approx(-once.bounces[1].reflected));
    // What arrives first is the truth's and does not depend on the model.
    const EnergyAudit other = audit_of(scene, "conserving", 1);
    CHECK(other.bounces[0].arriving == Approx(once.bounces[0].arriving).epsilon(1e-5));
    CHECK(once.direct == Approx(other.direct).epsilon(1e-5));
    // In a closed room all that leaves arrives: the noise of 64 rays at 2000 points.
    CHECK(once.bounces[0].arriving == Approx(once.direct).epsilon(0.05));
}

TEST_CASE("the audit is of the light that a picture shows: of the probes that a surface sees",
          "[compare][audit]") {
    const Scene scene = ddgi::room_with_moving_block();
    const ddgi::DdgiOptions options;
    ddgi::ProbeVolume volume(scene, options);
    volume.move_to(0);
    volume.update();
    const SurfacePoints surface = surface_points(volume.tracer(), points);
    double seen = 0, all = 0;
    for (const SurfacePoint& point : surface.points) {
        ddgi::ReceiverPoint receiver{point.position, point.n, point.albedo};
        const auto flux = [&] {
            const Spectrum Lo = volume.model().probe_light(volume.values(), receiver);
            return double(Lo.r + Lo.g + Lo.b) / 3 * glm::pi<double>() * surface.area;
        };
        all += flux();
        receiver.seen =
            ddgi::seen_probes(volume.tracer(), volume.cache().grid(), point.position, point.n);
        seen += flux();
    }
    const EnergyAudit audit = energy_audit(scene, 0, options, 1, points);
    REQUIRE(audit.unseen_area == Approx(surface.covered_area));
    CHECK(std::abs(all / seen - 1) > 1e-4);
    CHECK(audit.bounces[0].shown == Approx(seen).epsilon(1e-5));
}

TEST_CASE("the audit gathers an environment, be it even or a picture", "[compare][audit]") {
    Scene scene = ddgi::room_with_moving_block();
    scene.objects.erase(scene.objects.begin() + 3);  // open on one side
    scene.environment = Spectrum(.25f);
    const double even = audit_of(scene, "conserving", 1).bounces[0].arriving;
    auto panorama = std::make_shared<Panorama>();
    panorama->width = 4;
    panorama->height = 2;
    panorama->radiance.assign(8, Spectrum(.25f));
    scene.environment = Spectrum(1.f);
    scene.environment_image = EnvironmentImage{panorama, 0.f};
    CHECK(audit_of(scene, "conserving", 1).bounces[0].arriving == Approx(even).epsilon(1e-4));
}

TEST_CASE("directions around a normal have the moments of a cosine", "[compare][audit]") {
    const glm::vec3 n = glm::normalize(glm::vec3(0.3f, -0.8f, 0.5f));
    double cosine = 0, square = 0;
    constexpr int edge = 200;
    for (int i = 0; i < edge * edge; ++i) {
        const glm::vec2 u((float(i / edge) + 0.5f) / edge, (float(i % edge) + 0.5f) / edge);
        const double c = double(glm::dot(cosine_direction(u, n), n));
        REQUIRE(c >= 0);
        cosine += c / (edge * edge);
        square += c * c / (edge * edge);
    }
    CHECK(cosine == Approx(2.0 / 3).epsilon(1e-3));
    CHECK(square == Approx(0.5).epsilon(1e-3));
}
