// SPDX-License-Identifier: Apache-2.0
// What a picture says of its own error, against errors measured.
#include "pathtracer/estimate.h"

#include <array>
#include <catch2/catch.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "pathtracer/render.h"
#include "scenes/scene_files.h"
#include "tests/pathtracer/scenes.h"

namespace plumbline::pathtracer {
namespace {

/// Mean over pixels of the variance across seeds, and of the variance reported.
struct Variances {
    double measured = 0.;
    double reported = 0.;
};

constexpr int seeds = 64;

/// A room of the tests, or a library scene, at the frame that it is about.
struct View {
    Scene scene;
    int frame;
};

View view_of(const std::string& name, int width, int height) {
    if (name == "mixed room") return {test::mixed_room(width, height), 0};
    View view{load_scene(name), 0};
    view.frame = view.scene.report_frame;
    view.scene.camera.width = width;
    view.scene.camera.height = height;
    return view;
}

const std::vector<std::string> views = {"mixed room", "cornell-box", "room-with-door"};

/// Of radiance, and of indirect.
std::array<Variances, 2> variances(const View& view, int spp) {
    const std::array<std::string, 2> layers{"", "indirect"};
    const std::array<std::string, 2> variance_layers{"variance", "variance_indirect"};
    const auto pixels = view.scene.camera.width * view.scene.camera.height;
    std::array<std::vector<double>, 2> sum, sum2;
    std::array<Variances, 2> result;
    for (int seed = 0; seed < seeds; ++seed) {
        const Image image =
            render(view.scene, view.frame, {.spp = spp, .seed = static_cast<std::uint64_t>(seed)})
                .image;
        for (const std::size_t l : {0, 1}) {
            const auto values = image.layer(layers[l])[1];
            const auto reported = image.layer(variance_layers[l])[1];
            sum[l].resize(values.size());
            sum2[l].resize(values.size());
            for (std::size_t i = 0; i < values.size(); ++i) {
                const double value = values[i];
                sum[l][i] += value;
                sum2[l][i] += value * value;
                result[l].reported += double(reported[i]) / (pixels * seeds);
            }
        }
    }
    for (const std::size_t l : {0, 1}) {
        for (std::size_t i = 0; i < sum[l].size(); ++i) {
            result[l].measured +=
                (sum2[l][i] - sum[l][i] * sum[l][i] / seeds) / (seeds - 1) / pixels;
        }
    }
    return result;
}

/// Root mean square of the difference of two pictures' means over blocks, per picture.
double block_error(const Image& a, const Image& b, int block) {
    double sum = 0.;
    int blocks = 0;
    const auto va = a.layer("indirect")[1];
    const auto vb = b.layer("indirect")[1];
    for (int y = 0; y + block <= a.height(); y += block) {
        for (int x = 0; x + block <= a.width(); x += block) {
            double difference = 0.;
            for (int i = 0; i < block * block; ++i) {
                const auto pixel = std::size_t(y + i / block) * std::size_t(a.width()) +
                                   std::size_t(x + i % block);
                difference += double(va[pixel]) - double(vb[pixel]);
            }
            difference /= block * block;
            sum += difference * difference;
            ++blocks;
        }
    }
    return std::sqrt(sum / blocks / 2.);
}

}  // namespace

TEST_CASE("the variance layers agree with the variance over 64 seeds", "[pathtracer][statistics]") {
    for (const std::string& name : views) {
        for (const Variances& v : variances(view_of(name, 16, 9), 64)) {
            INFO(name << ": " << v.reported << " for " << v.measured);
            CHECK(v.reported / v.measured == Approx(1.).margin(.1));
        }
    }
}

TEST_CASE("with fewer than two batches the variance reported is not too small",
          "[pathtracer][statistics]") {
    for (const std::string& name : views) {
        for (const int spp : {4, 16}) {
            const Variances v = variances(view_of(name, 16, 9), spp)[0];
            INFO(name << " " << spp << ": " << v.reported << " for " << v.measured);
            CHECK(v.reported / v.measured > .95);
            CHECK(v.reported / v.measured < 4.);
        }
    }
}

TEST_CASE("the error of block means halves with each doubling of block and of sqrt(spp)",
          "[pathtracer][statistics]") {
    for (const std::string& name : views) {
        const View view = view_of(name, 72, 72);
        const auto picture = [&](int spp, std::uint64_t seed) {
            return render(view.scene, view.frame, {.spp = spp, .seed = seed}).image;
        };
        const Image a = picture(16, 1), b = picture(16, 2);
        const Image a4 = picture(64, 3), b4 = picture(64, 4);
        const double pixel = block_error(a, b, 1);
        for (const int block : {2, 4, 8}) {
            INFO(name << ", blocks of " << block);
            // 81 blocks of 8 x 8 tell their spread to 8 %.
            CHECK(block_error(a, b, block) * block / pixel == Approx(1.).margin(.25));
            CHECK(block_error(a4, b4, block) * 2 * block / pixel == Approx(1.).margin(.25));
        }
    }
}

TEST_CASE("a picture stopped at a relMSE has it", "[pathtracer][statistics]") {
    // relMSE as the mean of d^2 / (ref^2 + .01) against 16 times as many samples, whose own
    // expected error is taken off.
    const std::string name = GENERATE("cornell-box", "room-with-door");
    const double target = name == "cornell-box" ? .001 : .005;
    const View view = view_of(name, 32, 18);
    const RenderOptions options{.spp = 1 << 20, .target_relmse = target};
    std::optional<RenderResult> reference;
    double sum = 0.;
    constexpr int pictures = 4;
    for (std::uint64_t seed = 1; seed <= pictures; ++seed) {
        RenderOptions seeded = options;
        seeded.seed = seed;
        const RenderResult stopped = render(view.scene, view.frame, seeded);
        if (!reference) {
            REQUIRE(stopped.spp >= 64);
            reference = render(view.scene, view.frame, {.spp = 16 * stopped.spp});
        }
        double error = 0.;
        for (std::size_t c = 0; c < 3; ++c) {
            const auto test = stopped.image.layer("")[c];
            const auto truth = std::as_const(reference->image).layer("")[c];
            for (std::size_t i = 0; i < test.size(); ++i) {
                const double difference = double(test[i]) - double(truth[i]);
                error += difference * difference / (double(truth[i]) * double(truth[i]) + .01);
            }
        }
        error = error / (3. * double(reference->image.pixels())) - reference->relmse_estimate;
        INFO(name << ", seed " << seed << ": " << stopped.spp << " samples, relMSE " << error);
        CHECK(error == Approx(target).epsilon(.25));
        sum += error;
    }
    CAPTURE(sum / pictures / target);
    CHECK(sum / pictures == Approx(target).epsilon(.15));
}

TEST_CASE("groups of unequal size are weighted by their samples", "[pathtracer][statistics]") {
    const auto group = [](double value, unsigned samples) {
        SampleSums sums;
        sums.direct = glm::dvec3(value * samples);
        sums.samples = samples;
        return sums;
    };
    PixelEstimate estimate;
    CHECK(std::isnan(estimate.radiance_variance().x));
    estimate.add_group(group(1., 16));
    CHECK(std::isnan(estimate.radiance_variance().x));
    estimate.add_group(group(4., 16));
    estimate.add_group(group(2., 8));
    // Mean (16 + 64 + 16) / 40 = 2.4; sum of n (x - mean)^2 = 16 1.96 + 16 2.56 + 8 .16 = 73.6.
    CHECK(estimate.sums.radiance().x / 40. == Approx(2.4));
    CHECK(estimate.radiance_variance().x == Approx(73.6 / 2. / 40.));
    CHECK(estimate.indirect_variance().x == 0.);
}

}  // namespace plumbline::pathtracer
