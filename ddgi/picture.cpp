// SPDX-License-Identifier: Apache-2.0
#include "ddgi/picture.h"

#include <tbb/parallel_for.h>

#include <array>
#include <atomic>
#include <glm/gtc/constants.hpp>

#include "ddgi/direct_light.h"
#include "scenes/camera_rays.h"

namespace plumbline::ddgi {
namespace {

/// What all samples of a picture need.
struct View {
    const RayTracer& tracer;
    const ProbeModel& model;
    const ProbeVolume* volume;
    PictureOptions options;
    CameraRays rays;
    glm::vec3 forward;  ///< unit view axis
};

/// Sums over the samples of a pixel.
struct PixelSums {
    Spectrum direct{0.f}, indirect{0.f}, ambient{0.f};
    Spectrum albedo{0.f};
    glm::vec3 normal{0.f};
    float depth = 0.f;
    int hits = 0;
    int samples = 0;
    int object = -1;  ///< what the first sample met
    glm::vec3 first_n{0.f};
    bool edge = false;  ///< another sample met another object or side
    std::uint64_t shadow_rays = 0;

    void note_surface(const std::optional<Hit>& hit) {
        const int object_met = hit ? hit->object : -1;
        const glm::vec3 n = hit ? hit->n() : glm::vec3(0.f);
        if (samples == 0) {
            object = object_met;
            first_n = n;
        }
        // Normals of a curved surface differ a little from sample to sample.
        constexpr float like = .9f;
        edge = edge || object_met != object || (hit && glm::dot(n, first_n) < like);
        ++samples;
    }
};

void add_sample(const View& view, const Ray& ray, PixelSums& sums) {
    const World& world = view.tracer.world();
    const std::optional<Hit> hit = view.tracer.intersect(ray, BackFaces::Cull);
    sums.note_surface(hit);
    if (!hit) {
        sums.direct += environment_radiance(world, ray.direction);
        return;
    }
    const glm::vec3 position = offset_origin(*hit, hit->n());
    const DirectLight light =
        direct_light(view.tracer, position, hit->n(), view.options.shadow_rays);
    sums.direct += world.materials[static_cast<std::size_t>(hit->material)].emission +
                   hit->albedo / glm::pi<float>() * light.irradiance;
    sums.shadow_rays += light.shadow_rays;
    sums.ambient += view.model.ambient(hit->albedo);
    if (view.volume != nullptr) {
        ReceiverPoint point = view.volume->receiver(position, hit->n(), hit->albedo);
        point.to_viewer = -ray.direction;
        const Spectrum emitted = view.model.emitted_light(point);
        sums.direct += emitted;
        sums.indirect += view.model.probe_light(view.volume->values(), point) - emitted;
    }
    sums.albedo += hit->albedo;
    sums.normal += hit->n();
    sums.depth += glm::dot(hit->position - world.camera.eye, view.forward);
    ++sums.hits;
}

PixelSums sum_samples(const View& view, std::span<const glm::vec2> points) {
    PixelSums sums;
    for (const glm::vec2& at : points) add_sample(view, view.rays.through(at.x, at.y), sums);
    return sums;
}

/// Adds the shadow rays that it took to `shadow_rays`.
PixelSums sample_pixel(const View& view, int x, int y, std::uint64_t& shadow_rays) {
    PixelSums sums = sum_samples(view, pixel_samples(x, y));
    shadow_rays += sums.shadow_rays;
    if (!view.options.sample_edges || !sums.edge) return sums;
    sums = sum_samples(view, edge_samples(x, y));
    shadow_rays += sums.shadow_rays;
    return sums;
}

/// The channels of a picture, each row by row.
class Layers {
 public:
    Layers(Image& image, bool probes, bool ambient)
        : radiance_(image.layer("")),
          direct_(image.layer("direct")),
          albedo_(image.layer("albedo")),
          normal_{image.channel("normal.X"), image.channel("normal.Y"), image.channel("normal.Z")},
          depth_(image.channel("depth.Z")),
          object_(image.channel("object.Y")) {
        if (probes) indirect_ = image.layer("indirect");
        if (ambient) ambient_ = image.layer("ambient");
    }

    void set(std::size_t pixel, const PixelSums& sums, float object) {
        const auto samples = static_cast<float>(sums.samples);
        const auto hits = static_cast<float>(glm::max(sums.hits, 1));
        put(direct_, pixel, sums.direct / samples);
        put(indirect_, pixel, sums.indirect / samples);
        put(ambient_, pixel, sums.ambient / samples);
        put(radiance_, pixel, (sums.direct + sums.indirect + sums.ambient) / samples);
        put(albedo_, pixel, sums.albedo / hits);
        put(normal_, pixel, sums.normal / hits);
        depth_[pixel] = sums.depth / hits;
        object_[pixel] = object;
    }

 private:
    using Channels = std::array<std::span<float>, 3>;

    static void put(Channels& channels, std::size_t pixel, const glm::vec3& value) {
        if (channels[0].empty()) return;  // a layer that this picture does not have
        for (std::size_t c = 0; c < 3; ++c) channels[c][pixel] = value[static_cast<int>(c)];
    }

    Channels radiance_, direct_, albedo_, normal_, indirect_, ambient_;
    std::span<float> depth_, object_;
};

}  // namespace

PictureOptions picture_options(const DdgiOptions& options, const ProbeModel& model) {
    const int on_edges = model.samples_edges() ? samples_on_edges : samples_per_pixel;
    return {options.shadow_rays, options.edge_samples.value_or(on_edges) == samples_on_edges};
}

std::array<glm::vec2, samples_per_pixel> pixel_samples(int x, int y) {
    const glm::vec2 centre(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
    const glm::vec2 right(0.5f, 0.f);
    const glm::vec2 down(0.f, 0.5f);
    return {centre + right, centre - right, centre + down, centre - down};
}

std::array<glm::vec2, samples_on_edges> edge_samples(int x, int y) {
    constexpr auto count = static_cast<float>(samples_on_edges);
    const auto bits_reversed = [](unsigned i) {
        return (i & 1u) << 3u | (i & 2u) << 1u | (i & 4u) >> 1u | (i & 8u) >> 3u;
    };
    std::array<glm::vec2, samples_on_edges> points;
    for (unsigned i = 0; i < points.size(); ++i) {
        const glm::vec2 in_pixel(static_cast<float>(i), static_cast<float>(bits_reversed(i)));
        points[i] = glm::vec2(x, y) + (in_pixel + .5f) / count;
    }
    return points;
}

Picture take_picture(const RayTracer& tracer, const ProbeModel& model, const ProbeVolume* volume,
                     const PictureOptions& options) {
    const Camera& camera = tracer.world().camera;
    const View view{tracer,
                    model,
                    volume,
                    options,
                    CameraRays(camera),
                    unit_length(camera.target - camera.eye)};
    Picture picture{Image(camera.width, camera.height), 0};
    const bool ambient = model.ambient(Spectrum(1.f)) != Spectrum(0.f);
    Layers layers(picture.image, volume != nullptr, ambient);
    std::atomic<std::uint64_t> rays{0};
    tbb::parallel_for(0, camera.height, [&](int y) {
        std::uint64_t row_rays = 0;
        for (int x = 0; x < camera.width; ++x) {
            const PixelSums sums = sample_pixel(view, x, y, row_rays);
            const Ray centre =
                view.rays.through(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            const auto hit = tracer.intersect(centre, BackFaces::Cull);
            const auto pixel =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(camera.width) +
                static_cast<std::size_t>(x);
            layers.set(pixel, sums, hit ? static_cast<float>(hit->object) : -1.f);
        }
        rays += row_rays;
    });
    picture.shadow_rays = rays;
    return picture;
}

}  // namespace plumbline::ddgi
