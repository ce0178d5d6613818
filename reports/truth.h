// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scenes/command_line.h"
#include "scenes/image.h"

namespace plumbline::reports {

/// Where the truth of a scene comes from.
struct TruthSource {
    std::string file;  ///< given as --reference; if empty the truth is path-traced
    double pixels;     ///< of a path-traced one without --size
    int spp;           ///< of a path-traced one
};

/// The truth of the scene at `frame`; the scene's camera gets its size.
///
/// Throws UsageError if a file's header says that it shows another scene or frame, or if --size
/// asks for another size than a file has; ImageError as read_image().
Image truth_of(Scene& scene, int frame, const TruthSource& source, const CommonOptions& options);

}  // namespace plumbline::reports
