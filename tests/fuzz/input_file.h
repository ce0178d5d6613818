// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tests/fuzz/targets.h"
#include "tests/scenes/temporary_folder.h"

namespace plumbline::fuzz {

/// Writes the input where a reader finds it, over the last one; its path.
inline std::string input_file(const TemporaryFolder& folder, const std::string& name, Bytes bytes) {
    return folder.write(name, std::string(bytes.begin(), bytes.end()));
}

}  // namespace plumbline::fuzz
