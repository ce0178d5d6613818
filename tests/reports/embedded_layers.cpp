// SPDX-License-Identifier: Apache-2.0
#include "reports/embedded_layers.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "reports/page_data.h"
#include "reports/shrink.h"
#include "tests/reports/page_parts.h"
#include "tests/reports/synthetic_report.h"

using namespace plumbline;
using namespace plumbline::reports;

namespace {

/// Half of a half float's last place, relative.
constexpr double half_rounding = 1. / 2048;

std::vector<float> round_trip(const std::vector<float>& values, int width) {
    const std::array<std::span<const float>, 1> planes{values};
    const PackedPlanes packed = pack_planes(planes, width);
    return unpacked(packed.base64, width, packed.exponent);
}

std::span<const unsigned char> bytes_of(std::string_view text) {
    return {reinterpret_cast<const unsigned char*>(text.data()), text.size()};
}

}  // namespace

TEST_CASE("base64 agrees with the examples of RFC 4648", "[reports]") {
    CHECK(base64(bytes_of("")) == "");
    CHECK(base64(bytes_of("f")) == "Zg==");
    CHECK(base64(bytes_of("fo")) == "Zm8=");
    CHECK(base64(bytes_of("foo")) == "Zm9v");
    CHECK(base64(bytes_of("foob")) == "Zm9vYg==");
    CHECK(base64(bytes_of("fooba")) == "Zm9vYmE=");
    CHECK(base64(bytes_of("foobar")) == "Zm9vYmFy");
}

TEST_CASE("packed values come back within a half float's rounding at any scale", "[reports]") {
    const double scale = GENERATE(1e-6, 1., 1e7);
    std::mt19937 random(3);
    std::lognormal_distribution<double> distribution(0., 2.);
    std::vector<float> values;
    for (int i = 0; i < 40 * 7; ++i)
        values.push_back(static_cast<float>(scale * distribution(random)));
    const std::vector<float> back = round_trip(values, 40);
    REQUIRE(back.size() == values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        CHECK(std::abs(back[i] - values[i]) <= half_rounding * std::abs(values[i]));
}

TEST_CASE("values that are not finite come back as what they were", "[reports]") {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const std::vector<float> back =
        round_trip({1.f, std::nanf(""), 3.f, infinity, -infinity, 1e9f}, 3);
    CHECK(back[0] == Approx(1.f).epsilon(half_rounding));
    CHECK(std::isnan(back[1]));
    CHECK(back[2] == Approx(3.f).epsilon(half_rounding));
    CHECK(back[3] == infinity);
    CHECK(back[4] == -infinity);
    CHECK(back[5] == Approx(1e9f).epsilon(half_rounding));
}

TEST_CASE("the page holds every picture's values and the truth's standard errors", "[reports]") {
    const Report report = synthetic_report(32, 18);
    const PageData data = page_data(report, 1);
    const auto values_of = [&](const nlohmann::json& layer) {
        return unpacked(script_text(data.layer_elements, layer["id"]), layer["width"],
                        layer["exponent"]);
    };
    const nlohmann::json scene = data.json["scenes"][0];
    const Image& conserving = report.scenes[0].models[2].result.image;
    const nlohmann::json& picture = scene["pictures"][3];
    REQUIRE(picture["id"] == "conserving");
    for (const std::string layer : {"", "indirect"}) {
        const std::vector<float> values =
            values_of(picture["layers"][layer.empty() ? "radiance" : layer]);
        REQUIRE(values.size() == 3 * conserving.pixels());
        for (std::size_t i = 0; i < values.size(); ++i) {
            const float rendered =
                conserving.layer(layer)[i / conserving.pixels()][i % conserving.pixels()];
            CHECK(std::abs(values[i] - rendered) <= half_rounding * rendered);
        }
    }
    for (const float error : values_of(scene["noise"]["indirect"]))
        CHECK(error == Approx(0.01f).epsilon(half_rounding));
}

TEST_CASE("a shrunk picture has the means of blocks, and their variances", "[reports]") {
    Image image(3, 2);
    const std::array<float, 6> values{1, 2, 3, 4, 5, 9};
    for (std::size_t c = 0; c < 3; ++c) {
        std::copy(values.begin(), values.end(), image.layer("indirect")[c].begin());
        std::copy(values.begin(), values.end(), image.layer("variance_indirect")[c].begin());
    }
    const Image small = shrunk(image, 2);
    REQUIRE(small.width() == 2);
    REQUIRE(small.height() == 1);
    CHECK(std::as_const(small).layer("indirect")[1][0] == 3.f);
    CHECK(std::as_const(small).layer("indirect")[1][1] == 6.f);
    CHECK(std::as_const(small).layer("variance_indirect")[2][0] == 3.f / 4.f);
}
