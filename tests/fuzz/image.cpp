// SPDX-License-Identifier: Apache-2.0
#include "scenes/image.h"

#include "scenes/panorama.h"
#include "scenes/texture.h"
#include "tests/fuzz/held.h"
#include "tests/fuzz/input_file.h"

namespace plumbline::fuzz {

void image(Bytes file) {
    static const TemporaryFolder folder;
    const std::string path = input_file(folder, "picture.exr", file);
    std::size_t values = 0;
    const bool is_picture = accepted([&] {
        const Image read = read_image(path);
        for (const std::string& layer : read.layer_names()) values += read.layer(layer)[0].size();
    });
    // The other readers decode it again: what is large has been read often enough.
    constexpr std::size_t small = 1 << 16;
    if (!is_picture || values > small) return;
    accepted([&] { read_panorama(path); });
    accepted([&] { read_picture(path); });
}

}  // namespace plumbline::fuzz
