// SPDX-License-Identifier: Apache-2.0
#include "scenes/input_files.h"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "scenes/errors.h"
#include "scenes/nearest_name.h"

namespace plumbline {

std::string read_bytes(const std::filesystem::path& path) {
    // Readers downstream count bytes in 32 bits.
    constexpr std::uintmax_t largest = std::uintmax_t{1} << 31;
    if (std::filesystem::is_directory(path)) {
        throw SceneError(path.string(), "is a folder", "name a file");
    }
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw SceneError(path.string(), std::generic_category().message(errno),
                         "check its name, and that you may read it");
    }
    std::string bytes;
    char block[1 << 16];
    while (file.read(block, sizeof block) || file.gcount() > 0) {
        bytes.append(block, static_cast<std::size_t>(file.gcount()));
        if (bytes.size() > largest) {
            throw SceneError(path.string(), "is larger than 2 GiB", "split it into smaller files");
        }
    }
    if (file.bad()) throw SceneError(path.string(), "cannot be read to its end", "check the disk");
    return bytes;
}

std::filesystem::path file_inside(const std::filesystem::path& folder, const std::string& name,
                                  const JsonView& place) {
    const std::filesystem::path path = std::filesystem::path(name).lexically_normal();
    if (name.empty() || path.is_absolute() || path.begin()->string() == "..") {
        place.fail(in_quotes(name) + " is not in the scene's folder",
                   "put the file into that folder or below, and name it relative to it");
    }
    return folder / path;
}

}  // namespace plumbline
