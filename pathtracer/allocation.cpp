// SPDX-License-Identifier: Apache-2.0
#include "pathtracer/allocation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pathtracer/sampler.h"

namespace plumbline::pathtracer {
namespace {

constexpr int batch = Sampler::batch_size;

constexpr double least_share = 1. / 8.;
constexpr double most_share = 16.;

/// Calls visit(i) for the halves of one colour.
template <typename Visit>
void for_each_of(int colour, std::span<const Tiles::Part> halves, const Visit& visit) {
    for (std::size_t i = 0; i < halves.size(); ++i) {
        if (halves[i].colour == colour) visit(i);
    }
}

/// Where a half's batches are rounded up: spread evenly over [0,1), so that halves of equal shares
/// do not all take a batch more at once, but one after the other.
double rounding(const Tiles::Part& half) {
    const double turns = (half.tile + 1) / std::numbers::phi;
    return turns - std::floor(turns);
}

/// Samples of a half with `share`, when a share of 1 gets `unit` samples.
std::int64_t samples_of(const Tiles::Part& half, double share, double unit, int pilot) {
    const double batches = std::floor(unit * share / batch + rounding(half));
    return std::max<std::int64_t>(pilot, batch * static_cast<std::int64_t>(batches));
}

/// What the other half of its tile, its neighbour in `halves`, says of half `i`; NaN if it says
/// nothing.
double wish_of_other(std::size_t i, std::span<const Tiles::Part> halves,
                     std::span<const HalfCost> costs) {
    const std::size_t other = halves[i].colour == 0 ? i + 1 : i - 1;
    if (other >= halves.size() || halves[other].tile != halves[i].tile) return std::nan("");
    return std::sqrt(costs[other].relmse / costs[other].rays);
}

/// Makes the wishes of one colour into shares.
void normalise(int colour, std::span<const Tiles::Part> halves, std::span<double> shares) {
    double sum = 0.;
    double pixels = 0.;
    for_each_of(colour, halves, [&](std::size_t i) {
        if (!std::isfinite(shares[i])) return;
        sum += shares[i] * halves[i].pixels();
        pixels += halves[i].pixels();
    });
    for_each_of(colour, halves, [&](std::size_t i) {
        const bool known = std::isfinite(shares[i]) && sum > 0.;
        shares[i] = known ? std::clamp(shares[i] * pixels / sum, least_share, most_share) : 1.;
    });
}

}  // namespace

int pilot_samples(int spp) { return std::clamp(spp / 4 / batch, 2, 4) * batch; }

HalfCost cost_of(const Tiles::Part& half, std::span<const PixelEstimate> pixels, int width,
                 std::uint64_t rays) {
    double relmse = 0.;
    double samples = 0.;
    int finite = 0;
    half.for_each_pixel(half.bounds.top, half.bounds.bottom, [&](const glm::ivec2& at) {
        const PixelEstimate& pixel =
            pixels[std::size_t(at.y) * std::size_t(width) + std::size_t(at.x)];
        samples += pixel.sums.samples;
        const double of_one = relmse_estimate(pixel) * pixel.sums.samples;
        if (!std::isfinite(of_one)) return;
        relmse += of_one;
        ++finite;
    });
    return {relmse / finite, double(rays) / samples};
}

Allocation allocate(int pilot, std::span<const Tiles::Part> halves,
                    std::span<const HalfCost> costs) {
    Allocation allocation{pilot, {}};
    for (std::size_t i = 0; i < halves.size(); ++i) {
        allocation.shares.push_back(wish_of_other(i, halves, costs));
    }
    for (const int colour : {0, 1}) normalise(colour, halves, allocation.shares);
    return allocation;
}

std::vector<int> Allocation::samples(int level, std::span<const Tiles::Part> parts) const {
    std::vector<int> samples(parts.size(), level);
    if (shares.empty()) return samples;
    for (const int colour : {0, 1}) {
        const auto fits = [&](double unit) {
            std::int64_t excess = 0;  // over `level` samples of all
            for_each_of(colour, parts, [&](std::size_t i) {
                const std::int64_t n = samples_of(parts[i], shares[i], unit, pilot);
                excess += (n - level) * parts[i].pixels();
            });
            return excess <= 0;
        };
        // The largest double that fits, so that more samples never give a half fewer.
        double unit = 0.;
        double beyond = 2. / least_share * (level + batch);
        while (std::nextafter(unit, beyond) < beyond) {
            const double middle = (unit + beyond) / 2.;
            (fits(middle) ? unit : beyond) = middle;
        }
        for_each_of(colour, parts, [&](std::size_t i) {
            samples[i] = static_cast<int>(samples_of(parts[i], shares[i], unit, pilot));
        });
    }
    return samples;
}

}  // namespace plumbline::pathtracer
