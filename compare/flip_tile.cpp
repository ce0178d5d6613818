// SPDX-License-Identifier: Apache-2.0
#include "compare/flip_tile.h"

#include <algorithm>
#include <cmath>

#include "compare/flip_color.h"
#include "scenes/wide.h"

namespace plumbline::compare {

namespace {

// Exponents and thresholds of [Andersson et al. 2020, section 4.3 and table 1].
constexpr float color_exponent = 0.7f;
constexpr float knee_input = 0.4f;  ///< of the largest distance
constexpr float knee_output = 0.95f;

/// A small picture of one channel.
struct Plane {
    Plane(int w, int h) : width(w), height(h), values(std::size_t(w) * std::size_t(h), 0.f) {}
    std::size_t index(int x, int y) const {
        return std::size_t(y) * std::size_t(width) + std::size_t(x);
    }
    float* row(int y) { return values.data() + index(0, y); }
    const float* row(int y) const { return values.data() + index(0, y); }

    int width, height;
    std::vector<float> values;
};

/// Columns are filtered this many at a time, in vector registers; planes are padded to a multiple.
constexpr int lanes = 16;

int padded(int width) { return (width + lanes - 1) / lanes * lanes; }

/// A tile and a margin around it, in YCxCz; what lies outside the picture repeats its border.
struct OpponentTile {
    OpponentTile(const LayerPair& pair, const std::array<std::span<const float>, 3>& layer,
                 const Display& display, const Tile& tile, int margin)
        : y(padded(tile.width) + 2 * margin, tile.height + 2 * margin), cx(y), cz(y), gray(y) {
        for (int j = 0; j < y.height; ++j) {
            const int source_y = std::clamp(tile.y - margin + j, 0, pair.height - 1);
            for (int i = 0; i < y.width; ++i) {
                const int source_x = std::clamp(tile.x - margin + i, 0, pair.width - 1);
                const std::size_t at =
                    std::size_t(source_y) * std::size_t(pair.width) + std::size_t(source_x);
                glm::vec3 rgb(0.f);
                if (pair.finite[at]) rgb = display({layer[0][at], layer[1][at], layer[2][at]});
                const glm::vec3 ycxcz = ycxcz_from_linear_rgb(rgb);
                y.row(j)[i] = ycxcz.x;
                cx.row(j)[i] = ycxcz.y;
                cz.row(j)[i] = ycxcz.z;
                gray.row(j)[i] = (ycxcz.x + 16.f) / 116.f;  // Y in [0,1]
            }
        }
    }
    Plane y, cx, cz, gray;
};

/// Adds to out[0 .. width) the products of the kernel with in[k stride ...], k = 0, 1, ...
///
/// Compiled for wide registers too, and chosen at run time; without fused multiply-add, so that
/// the result has the same bits on every machine.
PLUMBLINE_WIDE void filter_row(const float* in, std::size_t stride,
                               const std::vector<float>& kernel, float* out, int width) {
    for (int x = 0; x < width; x += lanes) {
        std::array<float, lanes> sum;
        std::copy_n(out + x, lanes, sum.begin());
        for (std::size_t k = 0; k < kernel.size(); ++k) {
            const float* from = in + k * stride + x;
            const float weight = kernel[k];
            for (std::size_t i = 0; i < lanes; ++i) sum[i] += weight * from[i];
        }
        std::copy_n(sum.begin(), lanes, out + x);
    }
}

/// `in` times the kernel along x; it is wider than the result by margin on either side.
Plane filter_rows(const Plane& in, const std::vector<float>& kernel, int margin) {
    Plane out(in.width - 2 * margin, in.height);
    const int first = margin - int(kernel.size()) / 2;
    for (int y = 0; y < in.height; ++y)
        filter_row(in.row(y) + first, 1, kernel, out.row(y), out.width);
    return out;
}

/// Adds `in` times the kernel, along y, to `out`, lower by margin at top and bottom.
void filter_columns(const Plane& in, const std::vector<float>& kernel, int margin, Plane& out) {
    const int first = margin - int(kernel.size()) / 2;
    for (int y = 0; y < out.height; ++y)
        filter_row(in.row(y + first), std::size_t(in.width), kernel, out.row(y), out.width);
}

/// What the eye makes of one picture's tile.
struct SeenTile {
    SeenTile(const OpponentTile& in, const FlipFilters& f, int margin)
        : y(in.y.width - 2 * margin, in.y.height - 2 * margin),
          cx(y),
          cz(y),
          edge_x(y),
          edge_y(y),
          point_x(y),
          point_y(y) {
        filter_columns(filter_rows(in.y, f.achromatic, margin), f.achromatic, margin, y);
        filter_columns(filter_rows(in.cx, f.red_green, margin), f.red_green, margin, cx);
        for (const auto* kernel : {&f.blue_yellow_1, &f.blue_yellow_2})
            filter_columns(filter_rows(in.cz, *kernel, margin), *kernel, margin, cz);
        filter_columns(filter_rows(in.gray, f.edge, margin), f.gaussian, margin, edge_x);
        filter_columns(filter_rows(in.gray, f.point, margin), f.gaussian, margin, point_x);
        const Plane smooth = filter_rows(in.gray, f.gaussian, margin);
        filter_columns(smooth, f.edge, margin, edge_y);
        filter_columns(smooth, f.point, margin, point_y);
    }

    glm::vec3 color(std::size_t i) const {
        const glm::vec3 rgb = linear_rgb_from_ycxcz({y.values[i], cx.values[i], cz.values[i]});
        return hunt_lab_from_linear_rgb(glm::clamp(rgb, 0.f, 1.f));
    }
    float edge(std::size_t i) const {
        return std::sqrt(edge_x.values[i] * edge_x.values[i] + edge_y.values[i] * edge_y.values[i]);
    }
    float point(std::size_t i) const {
        return std::sqrt(point_x.values[i] * point_x.values[i] +
                         point_y.values[i] * point_y.values[i]);
    }

    Plane y, cx, cz, edge_x, edge_y, point_x, point_y;
};

/// The colour error in [0,1] of a HyAB distance.
float color_error(float distance) {
    static const float largest =
        std::pow(hyab(hunt_lab_from_linear_rgb({0, 1, 0}), hunt_lab_from_linear_rgb({0, 0, 1})),
                 color_exponent);
    const float knee = knee_input * largest;
    const float error = std::pow(distance, color_exponent);
    if (error < knee) return error * knee_output / knee;
    return knee_output + (error - knee) / (largest - knee) * (1.f - knee_output);
}

}  // namespace

glm::vec3 Display::operator()(const glm::vec3& linear) const {
    if (!curve) return glm::clamp(linear, 0.f, 1.f);
    const glm::vec3 rgb = exposure_scale * linear;
    if (curve->of_luminance) {
        const float gain = 1.f / (1.f + glm::dot(rgb, luminance_weights));
        return glm::clamp(rgb * gain, 0.f, 1.f);
    }
    return glm::clamp(glm::vec3((*curve)(rgb.r), (*curve)(rgb.g), (*curve)(rgb.b)), 0.f, 1.f);
}

void raise_to_flip(const LayerPair& pair, const Display& display, const FlipFilters& filters,
                   const Tile& tile, std::span<float> error) {
    const int margin = std::max(filters.spatial_radius, filters.feature_radius);
    const SeenTile r({pair, pair.reference, display, tile, margin}, filters, margin);
    const SeenTile t({pair, pair.test, display, tile, margin}, filters, margin);
    for (int y = 0; y < tile.height; ++y)
        for (int x = 0; x < tile.width; ++x) {
            const std::size_t i = r.y.index(x, y);
            const float c = color_error(hyab(r.color(i), t.color(i)));
            const float feature =
                std::max(std::abs(r.edge(i) - t.edge(i)), std::abs(r.point(i) - t.point(i)));
            const float f = std::sqrt(feature / std::sqrt(2.f));
            float& largest = error[std::size_t(y) * std::size_t(tile.width) + std::size_t(x)];
            largest = std::max(largest, std::pow(c, 1.f - f));
        }
}

}  // namespace plumbline::compare
