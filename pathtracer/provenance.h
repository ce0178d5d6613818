// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>

#include "pathtracer/render.h"

namespace plumbline::pathtracer {

/// Header entries of a picture, from plumbline:renderer to plumbline:shard.
using Provenance = std::map<std::string, std::string>;

/// All that decides the pixels of a picture: program, scene (its name, and a digest of all that is
/// in it), frame, size, seed, options, effects, and the shard if there is more than one.
Provenance provenance_of(const Scene& scene, int frame, const RenderOptions& options);

/// In which of these entries `its` differs first, in words: "its seed is 2, not 1". None if they
/// agree. The shard is not compared.
std::optional<std::string> difference(const Provenance& its, const Provenance& expected);

/// "2/8".
std::string shard_text(const Shard& shard);
/// Reads "2/8". Throws UsageError about `where`.
Shard parsed_shard(const std::string& where, const std::string& text);

}  // namespace plumbline::pathtracer
