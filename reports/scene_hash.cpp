// SPDX-License-Identifier: Apache-2.0
#include "reports/scene_hash.h"

#include <OpenImageIO/hash.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "scenes/scene_files.h"

namespace plumbline::reports {

namespace {

/// A folder of this process's own, gone when this is.
struct TemporaryFolder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("plumbline-hash-" + std::to_string(::getpid()));
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
};

}  // namespace

std::string scene_hash(const Scene& scene) {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.path / "scene.json";
    save_scene(scene, path);
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    return OIIO::SHA1(text.data(), text.size()).digest();
}

}  // namespace plumbline::reports
