// SPDX-License-Identifier: Apache-2.0
#include "pathtracer/picture.h"

#include <tbb/parallel_for.h>

namespace plumbline::pathtracer {
namespace {

/// Fills the three channels `names` with value(pixel).
template <typename Value>
void fill(Image& image, const std::array<std::string, 3>& names,
          const std::vector<PixelEstimate>& pixels, const Value& value) {
    const std::array channels{image.channel(names[0]), image.channel(names[1]),
                              image.channel(names[2])};
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const glm::dvec3 v = value(pixels[i]);
        channels[0][i] = static_cast<float>(v.x);
        channels[1][i] = static_cast<float>(v.y);
        channels[2][i] = static_cast<float>(v.z);
    }
}

template <typename Value>
void fill_layer(Image& image, const std::string& layer, const std::vector<PixelEstimate>& pixels,
                const Value& value) {
    fill(image, {channel_name(layer, "R"), channel_name(layer, "G"), channel_name(layer, "B")},
         pixels, value);
}

template <typename Value>
void fill_channel(Image& image, const std::string& name, const std::vector<PixelEstimate>& pixels,
                  const Value& value) {
    const std::span<float> channel = image.channel(name);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        channel[i] = static_cast<float>(value(pixels[i].sums));
    }
}

void fill_objects(Image& image, const RayTracer& tracer) {
    const CameraRays camera_rays(tracer.world().camera);
    const std::span<float> objects = image.channel("object.Y");
    const std::span<const float> samples = image.channel("samples.Y");
    const int width = image.width();
    tbb::parallel_for(0, image.height(), [&](int y) {
        for (int x = 0; x < width; ++x) {
            const auto i = std::size_t(y) * std::size_t(width) + std::size_t(x);
            objects[i] = -1.f;
            if (samples[i] == 0.f) continue;
            constexpr float centre = .5f;
            const Ray ray =
                camera_rays.through(static_cast<float>(x) + centre, static_cast<float>(y) + centre);
            const auto hit = tracer.intersect(ray, BackFaces::Cull);
            if (hit) objects[i] = static_cast<float>(hit->object);
        }
    });
}

}  // namespace

Image picture(const RayTracer& tracer, const Passes& passes) {
    const Camera& camera = tracer.world().camera;
    const std::vector<PixelEstimate>& pixels = passes.pixels();
    const auto over_samples = [](const glm::dvec3& sum, const SampleSums& sums) {
        return sums.samples > 0 ? sum / double(sums.samples) : sum;
    };
    const auto over_hits = [](const auto& sum, const SampleSums& sums) {
        return sums.hits > 0 ? sum / double(sums.hits) : sum;
    };
    using Pixel = const PixelEstimate&;

    Image image(camera.width, camera.height);
    fill_layer(image, "", pixels, [&](Pixel p) { return over_samples(p.sums.radiance(), p.sums); });
    fill_layer(image, "direct", pixels,
               [&](Pixel p) { return over_samples(p.sums.direct, p.sums); });
    fill_layer(image, "indirect", pixels,
               [&](Pixel p) { return over_samples(p.sums.indirect, p.sums); });
    fill_layer(image, "bounce1", pixels,
               [&](Pixel p) { return over_samples(p.sums.bounce1, p.sums); });
    fill_layer(image, "albedo", pixels, [&](Pixel p) { return over_hits(p.sums.albedo, p.sums); });
    fill(image, {"normal.X", "normal.Y", "normal.Z"}, pixels,
         [&](Pixel p) { return over_hits(p.sums.normal, p.sums); });
    fill_channel(image, "depth.Z", pixels,
                 [&](const SampleSums& sums) { return over_hits(sums.depth, sums); });
    fill_channel(image, "samples.Y", pixels, [](const SampleSums& sums) { return sums.samples; });
    fill_objects(image, tracer);
    if (passes.first_pixel().groups > 1) {
        const auto where_sampled = [](const glm::dvec3& variance, const SampleSums& sums) {
            return sums.samples > 0 ? variance : glm::dvec3(0.);
        };
        fill_layer(image, "variance", pixels,
                   [&](Pixel p) { return where_sampled(p.radiance_variance(), p.sums); });
        fill_layer(image, "variance_indirect", pixels,
                   [&](Pixel p) { return where_sampled(p.indirect_variance(), p.sums); });
    }
    return image;
}

}  // namespace plumbline::pathtracer
