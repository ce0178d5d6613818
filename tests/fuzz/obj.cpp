// SPDX-License-Identifier: Apache-2.0
#include "scenes/read_json.h"
#include "tests/fuzz/held.h"
#include "tests/fuzz/input_file.h"
#include "tests/fuzz/use_scene.h"

namespace plumbline::fuzz {

void obj(Bytes files) {
    // Its materials are its own in the first scene, and the scene's in the second.
    constexpr const char* scenes[] = {
        R"({"name": "own", "objects": [{"name": "o", "mesh": {"file": "m.obj"}}],
            "camera": {"eye": [0, 0, 5], "target": [0, 0, 0]}})",
        R"({"name": "given", "materials": [{"name": "grey", "albedo": 0.5}],
            "objects": [{"name": "o", "mesh": {"file": "m.obj", "material": "grey"}}],
            "camera": {"eye": [0, 0, 5], "target": [0, 0, 0]}})"};
    static const TemporaryFolder folder;
    const auto end = std::find(files.begin(), files.end(), std::uint8_t{0});
    const auto length = static_cast<std::size_t>(end - files.begin());
    input_file(folder, "m.obj", files.first(length));
    input_file(folder, "m.mtl", files.subspan(end == files.end() ? length : length + 1));
    for (const char* scene : scenes) {
        accepted([&] { use_scene(read_json_scene(scene, "scene.json", folder.path())); });
    }
}

}  // namespace plumbline::fuzz
