// SPDX-License-Identifier: Apache-2.0
#include "compare/resample.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <array>
#include <vector>

#include "scenes/errors.h"

namespace plumbline::compare {

namespace {

/// The library's own: two pixels of the source or of the result, whichever are larger.
constexpr float triangle_width = 0.f;

bool is_mixable(const std::string& channel) {
    for (const char* layer : {"object", "samples", "variance"})
        if (channel.starts_with(layer)) return false;
    return true;
}

}  // namespace

Image resampled(const Image& image, int width, int height) {
    Image result(width, height);
    result.metadata = image.metadata;
    result.source = image.source;
    const OIIO::ImageSpec from(image.width(), image.height(), 1, OIIO::TypeDesc::FLOAT);
    const OIIO::ROI to(0, width, 0, height, 0, 1, 0, 1);
    for (const std::string& name : image.channel_names()) {
        if (!is_mixable(name)) continue;
        const auto values = image.channel(name);
        std::vector<float> copy(values.begin(), values.end());
        const OIIO::ImageBuf source(from, copy.data());
        const OIIO::ImageBuf resized =
            OIIO::ImageBufAlgo::resize(source, "triangle", triangle_width, to);
        if (resized.has_error() ||
            !resized.get_pixels(to, OIIO::TypeDesc::FLOAT, result.channel(name).data()))
            throw ImageError(image.source, "cannot be resampled: " + resized.geterror(),
                             "give both images at the same size");
    }
    return result;
}

}  // namespace plumbline::compare
