// SPDX-License-Identifier: Apache-2.0
#include "pathtracer/tiles.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>

namespace plumbline::pathtracer {
namespace {

/// Coprime to n, and near n / phi: its multiples modulo n visit every residue once, and each few of
/// them in a row lie far apart.
std::int64_t golden_step(std::int64_t n) {
    auto step = static_cast<std::int64_t>(std::lround(double(n) / std::numbers::phi));
    while (std::gcd(step, n) != 1) ++step;
    return step;
}

}  // namespace

std::vector<int> Tiles::of(const Shard& shard) const {
    const std::int64_t n = count();
    const std::int64_t step = golden_step(n);
    std::vector<int> tiles;
    for (std::int64_t tile = 0; tile < n; ++tile) {
        if (tile * step % n * shard.count / n == shard.index - 1) {
            tiles.push_back(static_cast<int>(tile));
        }
    }
    return tiles;
}

std::vector<Tiles::Part> Tiles::parts_of(const Shard& shard) const {
    std::vector<Part> parts;
    for (const int tile : of(shard)) parts.push_back({tile, {}, bounds(tile)});
    return parts;
}

std::vector<Tiles::Part> Tiles::halves() const {
    std::vector<Part> halves;
    for (int tile = 0; tile < count(); ++tile) {
        for (const int colour : {0, 1}) {
            const Part half{tile, colour, bounds(tile)};
            if (half.pixels() > 0) halves.push_back(half);
        }
    }
    return halves;
}

}  // namespace plumbline::pathtracer
