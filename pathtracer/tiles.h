// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <glm/glm.hpp>
#include <optional>
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

    /// A tile, or its pixels on one colour of a chessboard: (x + y) % 2 == colour.
    struct Part {
        int tile;
        std::optional<int> colour;
        Bounds bounds;  ///< of the tile

        int pixels() const {
            const int all = (bounds.right - bounds.left) * (bounds.bottom - bounds.top);
            if (!colour) return all;
            return (bounds.left + bounds.top) % 2 == *colour ? (all + 1) / 2 : all / 2;
        }
        glm::ivec2 first_pixel() const {
            const int x = left_end(bounds.top);
            return x < bounds.right ? glm::ivec2(x, bounds.top)
                                    : glm::ivec2(bounds.left, bounds.top + 1);
        }
        /// Calls visit(glm::ivec2) for its pixels in the rows [top, bottom), row by row.
        template <typename Visit>
        void for_each_pixel(int top, int bottom, const Visit& visit) const {
            const int step = colour ? 2 : 1;
            for (int y = top; y < bottom; ++y) {
                for (int x = left_end(y); x < bounds.right; x += step) visit(glm::ivec2(x, y));
            }
        }

     private:
        int left_end(int y) const {
            return colour ? bounds.left + (bounds.left + y + *colour) % 2 : bounds.left;
        }
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

    /// These tiles as parts.
    std::vector<Part> parts_of(const Shard& shard) const;
    /// The halves of all tiles in their order, colour 0 before 1; one pixel has but one half.
    std::vector<Part> halves() const;

 private:
    static int along(int pixels) { return (pixels + side - 1) / side; }

    int width_;
    int height_;
};

}  // namespace plumbline::pathtracer
