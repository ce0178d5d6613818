// SPDX-License-Identifier: Apache-2.0
#include "scenes/read_gltf.h"
#include "tests/fuzz/held.h"
#include "tests/fuzz/input_file.h"
#include "tests/fuzz/use_scene.h"

namespace plumbline::fuzz {

void gltf(Bytes file) {
    static const TemporaryFolder folder;
    const std::string path = input_file(folder, "scene.gltf", file);
    accepted([&] { use_scene(read_gltf_scene(path)); });
}

}  // namespace plumbline::fuzz
