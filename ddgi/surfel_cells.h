// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "ddgi/surfels.h"

namespace plumbline::ddgi {

/// Groups surfels of all probes that lie close together and face much the same way, so that light
/// is measured at one of them and read by every ray that ended in its cell, each with the albedo
/// that it met.
///
/// A cell is a cube of space and all normals whose components round to the same quarters. Its light
/// is that of the surfel nearest to the middle of the cube, and of equally near ones that of lowest
/// index: a rule over its surfels that knows no order of theirs, so that neither threads nor which
/// surfels were placed last can tell. The sides of a thin wall never share, since they do not face
/// the same way; the floor on both sides of it does, within a cell.
class SurfelCells {
 public:
    /// `width` of the cubes, world units, positive; for at most `surfels`.
    SurfelCells(double width, std::size_t surfels);

    /// Sets Surfels::source of every hit. Returns how many surfels are their own source.
    std::uint64_t group(Surfels& surfels);

 private:
    struct Cell;

    Cell cell_of(const Surfels& surfels, std::size_t surfel) const;
    std::uint32_t slot_of(const Surfels& surfels, std::uint32_t surfel);

    double width_;
    std::vector<std::uint32_t> members_;  ///< a hash table: of each cell, some surfel in it
    std::vector<std::uint64_t> nearest_;  ///< its squared distance to the middle, and its index
};

}  // namespace plumbline::ddgi
