// SPDX-License-Identifier: Apache-2.0
#include "scenes/read_json.h"
#include "tests/fuzz/held.h"
#include "tests/fuzz/targets.h"
#include "tests/fuzz/use_scene.h"
#include "tests/scenes/temporary_folder.h"

namespace plumbline::fuzz {

void scene_json(Bytes text) {
    static const TemporaryFolder empty;
    accepted([&] {
        use_scene(read_json_scene({text.begin(), text.end()}, "scene.json", empty.path()));
    });
}

}  // namespace plumbline::fuzz
