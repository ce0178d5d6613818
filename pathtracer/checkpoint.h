// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "pathtracer/passes.h"
#include "pathtracer/provenance.h"

namespace plumbline::pathtracer {

/// A render in the making, as kept in a file: 200 bytes for each pixel of its shard.
///
/// The file is a line that names the format, a line of JSON (provenance, seconds, counts, the
/// allocation, a digest of the rest) and the PixelEstimates of the shard's tiles as this program
/// holds them in memory.
struct Checkpoint {
    Gathered gathered;
    double seconds = 0.;  ///< spent so far
};

/// Replaces `file`, whole or not at all, even if the process is killed meanwhile; what such a kill
/// leaves, `file`.new, the next write replaces. Throws ImageError.
void write_checkpoint(const std::filesystem::path& file, const Checkpoint& checkpoint,
                      const Provenance& provenance);

/// Throws ImageError if the file is missing or damaged, or was written by a render of other
/// `provenance`.
Checkpoint read_checkpoint(const std::filesystem::path& file, const Provenance& provenance);

/// Deletes the file, if there is one, and what a kill left beside it.
void remove_checkpoint(const std::filesystem::path& file);

}  // namespace plumbline::pathtracer
