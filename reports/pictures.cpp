// SPDX-License-Identifier: Apache-2.0
#include "reports/pictures.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>

#include "reports/embedded_layers.h"
#include "reports/layer_statistics.h"

namespace plumbline::reports {

namespace {

/// Of the truth's values; the rest may be brighter than white.
constexpr double share_below_white = 0.99;

unsigned char display_byte(float linear) {
    if (!std::isfinite(linear)) return 0;
    return static_cast<unsigned char>(
        std::lround(255.f * srgb_from_linear(std::clamp(linear, 0.f, 1.f))));
}

}  // namespace

std::vector<unsigned char> png_bytes(int width, int height, const std::vector<unsigned char>& rgb) {
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const std::unique_ptr<OIIO::ImageOutput> png = OIIO::ImageOutput::create("png", &memory);
    OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::UINT8);
    if (!png || !png->open("memory.png", spec) ||
        !png->write_image(OIIO::TypeDesc::UINT8, rgb.data()) || !png->close())
        throw std::runtime_error("a PNG could not be encoded");
    return bytes;
}

std::string png_uri(int width, int height, const std::vector<unsigned char>& rgb) {
    return "data:image/png;base64," + base64(png_bytes(width, height, rgb));
}

std::vector<unsigned char> display_bytes(const Image& image, const std::string& layer,
                                         double stops) {
    const auto planes = image.layer(layer);
    const auto gain = static_cast<float>(std::exp2(stops));
    std::vector<unsigned char> rgb;
    rgb.reserve(3 * image.pixels());
    for (std::size_t i = 0; i < image.pixels(); ++i)
        for (const std::span<const float> plane : planes)
            rgb.push_back(display_byte(gain * plane[i]));
    return rgb;
}

double exposure_of(const SceneReport& report) {
    const double white = layer_percentile(report.truth.image, "", share_below_white);
    if (!(white > 0)) return 0;
    return std::round(-2 * std::log2(white)) / 2;
}

}  // namespace plumbline::reports
