// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

namespace plumbline::pathtracer {

/// Part `index` of `count` of a picture, counted from 1.
struct Shard {
    int index = 1;
    int count = 1;
    bool operator==(const Shard&) const = default;
};

/// A picture cut into squares, the unit of work of threads and shards; those at the right and
/// bottom edge may be smaller. Numbered row by row from the top left.
class Tiles {
 public:
    /// Small enough to share out evenly, large enough that neighbouring rays share the cache.
    static constexpr int side = 16;

    struct Bounds {
        int left, top, right, bottom;  ///< right and bottom are the first pixels outside
    };

    Tiles(int width, int height) : width_(width), height_(height) {}

    int count() const { return along(width_) * along(height_); }

    Bounds bounds(int tile) const {
        const int left = tile % along(width_) * side;
        const int top = tile / along(width_) * side;
        return {left, top, std::min(left + side, width_), std::min(top + side, height_)};
    }

    /// The tiles of a shard, in rising order. The shards of a count cover each tile once, differ in
    /// size by one tile at most, and are each spread over the whole picture, so that they take
    /// about the same time. Empty for the last ones if there are more shards than tiles.
    std::vector<int> of(const Shard& shard) const;

 private:
    static int along(int pixels) { return (pixels + side - 1) / side; }

    int width_;
    int height_;
};

}  // namespace plumbline::pathtracer
