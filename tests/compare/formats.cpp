// SPDX-License-Identifier: Apache-2.0
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenImageIO/imageio.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "compare/comparison.h"
#include "compare/find_layer.h"
#include "compare/resample.h"
#include "scenes/errors.h"
#include "tests/compare/test_images.h"

using namespace plumbline;
using namespace plumbline::compare;

namespace {

namespace fs = std::filesystem;

fs::path scratch(const std::string& name) {
    const fs::path folder = fs::temp_directory_path() / "plumbline-test-formats";
    fs::create_directories(folder);
    return folder / name;
}

/// Half floats hold eighths exactly.
float value_at(int x, int y, int c) { return 0.125f * float(1 + x + 10 * y + 100 * c); }

std::vector<float> values_of(const OIIO::ImageSpec& spec, float shift = 0.f) {
    std::vector<float> values;
    for (int y = 0; y < spec.height; ++y)
        for (int x = 0; x < spec.width; ++x)
            for (int c = 0; c < spec.nchannels; ++c)
                values.push_back(value_at(x + spec.x, y + spec.y, c) + shift);
    return values;
}

fs::path write_with_oiio(const std::string& name, const OIIO::ImageSpec& spec) {
    const fs::path path = scratch(name);
    const auto file = OIIO::ImageOutput::create(path.string());
    REQUIRE(file);
    REQUIRE(file->open(path.string(), spec));
    REQUIRE(file->write_image(OIIO::TypeDesc::FLOAT, values_of(spec).data()));
    REQUIRE(file->close());
    return path;
}

constexpr int width = 9, height = 6;

OIIO::ImageSpec rgb_spec(OIIO::TypeDesc type) { return {width, height, 3, type}; }

void check_values(const Image& image, const std::string& layer) {
    const FoundLayer found = find_layer(image, layer);
    REQUIRE(image.width() == width);
    REQUIRE(image.height() == height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c)
                CHECK(found.channels[std::size_t(c)][std::size_t(y * width + x)] ==
                      value_at(x, y, c));
}

}  // namespace

TEST_CASE("half and float and tiled EXR and PFM and HDR give back what was written",
          "[compare][formats]") {
    check_values(read_image(write_with_oiio("half.exr", rgb_spec(OIIO::TypeDesc::HALF))), "");
    check_values(read_image(write_with_oiio("float.exr", rgb_spec(OIIO::TypeDesc::FLOAT))), "");
    {
        std::ofstream pfm(scratch("values.pfm"), std::ios::binary);
        pfm << "PF\n" << width << " " << height << "\n-1.0\n";  // little-endian, bottom row first
        for (int y = height - 1; y >= 0; --y)
            for (int x = 0; x < width; ++x)
                for (int c = 0; c < 3; ++c) {
                    const float value = value_at(x, y, c);
                    pfm.write(reinterpret_cast<const char*>(&value), sizeof value);
                }
    }
    check_values(read_image(scratch("values.pfm")), "");
    OIIO::ImageSpec tiled = rgb_spec(OIIO::TypeDesc::HALF);
    tiled.tile_width = tiled.tile_height = 4;
    check_values(read_image(write_with_oiio("tiled.exr", tiled)), "");
    // RGBE keeps eight bits of mantissa below the largest channel.
    const Image hdr = read_image(write_with_oiio("values.hdr", rgb_spec(OIIO::TypeDesc::FLOAT)));
    for (int c = 0; c < 3; ++c)
        CHECK(find_layer(hdr, "").channels[std::size_t(c)][20] ==
              Approx(value_at(2, 2, c)).margin(value_at(2, 2, 2) / 128));
}

TEST_CASE("each part of a multi-part EXR is a layer", "[compare][formats]") {
    const fs::path path = scratch("parts.exr");
    std::vector<OIIO::ImageSpec> parts(3, rgb_spec(OIIO::TypeDesc::HALF));
    const char* names[] = {"beauty", "diffuse", "more"};
    for (std::size_t k = 0; k < 3; ++k) parts[k].attribute("oiio:subimagename", names[k]);
    parts[2].channelnames = {"specular.R", "specular.G", "specular.B"};
    const auto file = OIIO::ImageOutput::create(path.string());
    REQUIRE(file->open(path.string(), 3, parts.data()));
    for (std::size_t k = 0; k < 3; ++k) {
        if (k > 0) REQUIRE(file->open(path.string(), parts[k], OIIO::ImageOutput::AppendSubimage));
        REQUIRE(file->write_image(OIIO::TypeDesc::FLOAT,
                                  values_of(parts[k], k == 1 ? 4.f : 0.f).data()));
    }
    file->close();
    const Image image = read_image(path);
    check_values(image, "");
    check_values(image, "specular");
    CHECK(find_layer(image, "diffuse").channels[1][0] == value_at(0, 0, 1) + 4.f);
}

TEST_CASE("a data window that differs from the display window is put in its place",
          "[compare][formats]") {
    OIIO::ImageSpec cropped = rgb_spec(OIIO::TypeDesc::FLOAT);
    cropped.x = 3;
    cropped.y = 2;
    cropped.width = 4;
    cropped.height = 2;
    cropped.full_width = width;
    cropped.full_height = height;
    const Image image = read_image(write_with_oiio("cropped.exr", cropped));
    REQUIRE(image.width() == width);
    const auto [r, g, b] = find_layer(image, "").channels;
    CHECK(g[2 * width + 3] == value_at(3, 2, 1));
    CHECK(b[3 * width + 6] == value_at(6, 3, 2));
    CHECK(r[2 * width + 2] == 0.f);
    CHECK(r[4 * width + 4] == 0.f);

    OIIO::ImageSpec overscan = rgb_spec(OIIO::TypeDesc::FLOAT);
    overscan.x = overscan.y = -2;
    overscan.width = width + 4;
    overscan.height = height + 4;
    overscan.full_x = overscan.full_y = 0;
    overscan.full_width = width;
    overscan.full_height = height;
    check_values(read_image(write_with_oiio("overscan.exr", overscan)), "");
}

TEST_CASE("integer channels of an EXR keep their numbers", "[compare][formats]") {
    const fs::path path = scratch("numbers.exr");
    Imf::Header header(3, 1);
    header.channels().insert("object.Y", Imf::Channel(Imf::UINT));
    std::vector<unsigned> numbers{0, 7, 65537};
    Imf::FrameBuffer frame;
    frame.insert("object.Y", Imf::Slice(Imf::UINT, reinterpret_cast<char*>(numbers.data()),
                                        sizeof(unsigned), 3 * sizeof(unsigned)));
    {
        Imf::OutputFile file(path.c_str(), header);
        file.setFrameBuffer(frame);
        file.writePixels(1);
    }
    const Image image = read_image(path);
    for (std::size_t i = 0; i < 3; ++i) CHECK(image.channel("object.Y")[i] == float(numbers[i]));
    CHECK_FALSE(image.metadata.contains("plumbline:decoded"));
}

TEST_CASE("a PNG's colours do not depend on its alpha", "[compare][formats]") {
    OIIO::ImageSpec spec(1, 1, 4, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    const fs::path path = scratch("alpha.png");
    const auto file = OIIO::ImageOutput::create(path.string());
    REQUIRE(file->open(path.string(), spec));
    const unsigned char pixel[] = {128, 128, 128, 64};
    REQUIRE(file->write_image(OIIO::TypeDesc::UINT8, pixel));
    file->close();
    const Image image = read_image(path);
    CHECK(find_layer(image, "").channels[0][0] == Approx(0.215861f).epsilon(1e-4));
    CHECK(image.channel("A")[0] == Approx(64.f / 255.f));
}

TEST_CASE("layers are found under the names that renderers give them", "[compare][formats]") {
    Image image(1, 1);
    for (const char* name : {"r", "g", "b", "N.X", "N.Y", "N.Z", "depth.Z", "lum.Y", "AO"})
        image.channel(name)[0] = float(name[0]);
    CHECK(find_layer(image, "").names == std::array<std::string, 3>{"r", "g", "b"});
    CHECK(find_layer(image, "N").names[2] == "N.Z");
    CHECK(find_layer(image, "depth").names ==
          std::array<std::string, 3>{"depth.Z", "depth.Z", "depth.Z"});
    CHECK(find_layer(image, "lum").channels[1][0] == float('l'));
    CHECK(find_layer(image, "AO").names[0] == "AO");
    CHECK(find_layer(image, "N.Y").names[0] == "N.Y");
    CHECK_THROWS_WITH(find_layer(image, "diffuse"),
                      "image: no layer 'diffuse'; name one of its layers with --layer: radiance "
                      "(AO b g r), N (X Y Z), depth (Z), lum (Y)");
    Image blender(1, 1);
    blender.layer("ViewLayer.Combined")[1][0] = 3.f;
    CHECK(find_layer(blender, "").channels[1][0] == 3.f);
}

TEST_CASE("resampling keeps constants and straight lines, and drops what cannot be mixed",
          "[compare][formats]") {
    Image fine = image_of(32, 16, [](int x, int, int c) { return float(c + 1) * float(x + 1); });
    fine.layer("variance");
    fine.channel("object.Y");
    const Image coarse = resampled(fine, 16, 8);
    CHECK(coarse.width() == 16);
    CHECK_FALSE(coarse.has_layer("variance"));
    CHECK_FALSE(coarse.has_channel("object.Y"));
    // Away from the border, where the filter is cut off: the mean of columns 2x and 2x + 1.
    for (int x = 2; x < 14; ++x)
        CHECK(coarse.channel("G")[std::size_t(4 * 16 + x)] ==
              Approx(2 * (2 * double(x) + 1.5)).epsilon(1e-5));
    const Image flat = resampled(image_of(10, 7, [](int, int, int) { return 0.3f; }), 23, 5);
    for (float value : flat.channel("B")) CHECK(value == Approx(0.3f).epsilon(1e-6));
}
