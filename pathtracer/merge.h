// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "scenes/image.h"

namespace plumbline::pathtracer {

/// Joins the shards of one render to the picture that a single render gives, to the bit and in any
/// order; its header tells the seconds of all together. Holds one shard at a time in memory.
///
/// Throws ImageError if a file is not a shard, belongs to another render (program version, scene,
/// frame, size, seed, options) or is there twice, and UsageError if one is missing.
Image merge(const std::vector<std::filesystem::path>& files);

}  // namespace plumbline::pathtracer
