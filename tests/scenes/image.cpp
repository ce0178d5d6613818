// SPDX-License-Identifier: Apache-2.0
#include "scenes/image.h"

#include <catch2/catch.hpp>
#include <cstring>
#include <fstream>

#include "scenes/errors.h"

namespace plumbline {
namespace {

namespace fs = std::filesystem;

fs::path scratch(const std::string& name) {
    const fs::path folder = fs::temp_directory_path() / "plumbline-test-images";
    fs::create_directories(folder);
    return folder / name;
}

/// Every pixel of every channel has a value of its own, so that a swap of any two shows.
Image unique_valued_image() {
    Image image(7, 5);
    float value = 0.1f;
    for (const char* layer : {"", "direct", "indirect"}) {
        for (const std::span<float> channel : image.layer(layer)) {
            for (float& pixel : channel) pixel = value += 0.37f;
        }
    }
    for (float& pixel : image.channel("depth.Z")) pixel = value += 0.37f;
    image.metadata["plumbline:scene"] = "test";
    return image;
}

}  // namespace

TEST_CASE("an EXR gives back every value of every channel, and its metadata", "[scenes][images]") {
    const Image written = unique_valued_image();
    const fs::path path = scratch("unique.exr");
    write_exr(path, written);
    const Image read = read_image(path);
    CHECK(read.width() == 7);
    CHECK(read.height() == 5);
    CHECK(read.channel_names() == written.channel_names());
    CHECK(read.layer_names() == std::vector<std::string>{"", "direct", "indirect"});
    CHECK(read.metadata.at("plumbline:scene") == "test");
    for (const std::string& name : written.channel_names()) {
        const auto a = written.channel(name);
        const auto b = read.channel(name);
        CHECK(std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
    }
}

TEST_CASE("a PNG is decoded from sRGB, and says so", "[scenes][images]") {
    const std::vector<unsigned char> rgb = {0, 128, 255, 10, 20, 30};
    write_png(scratch("two.png"), 2, 1, rgb);
    const Image read = read_image(scratch("two.png"));
    CHECK(read.channel("G")[0] == Approx(0.215861f).epsilon(1e-4));  // IEC 61966-2-1 of 128/255
    CHECK(read.channel("B")[0] == Approx(1.f));
    CHECK(read.channel("R")[1] == Approx(10.f / 255.f / 12.92f).epsilon(1e-4));
    CHECK(read.metadata.at("plumbline:decoded") == "from sRGB to linear");
}

TEST_CASE("a missing layer names those there are", "[scenes][images]") {
    const Image image = unique_valued_image();
    CHECK_THROWS_WITH(image.layer("bounce1"),
                      "image: no layer 'bounce1'; it has radiance (R, G, B), direct, indirect");
}

TEST_CASE("a file that is missing, cut or no picture is one line", "[scenes][images]") {
    CHECK_THROWS_AS(read_image(scratch("missing.exr")), ImageError);
    write_exr(scratch("whole.exr"), unique_valued_image());
    fs::copy_file(scratch("whole.exr"), scratch("cut.exr"), fs::copy_options::overwrite_existing);
    fs::resize_file(scratch("cut.exr"), fs::file_size(scratch("whole.exr")) / 2);
    std::ofstream(scratch("text.exr")) << "not a picture";
    for (const char* name : {"cut.exr", "text.exr"}) {
        try {
            read_image(scratch(name));
            FAIL("read " << name);
        } catch (const ImageError& error) {
            CHECK(std::string(error.what()).find(name) != std::string::npos);
            CHECK(std::string(error.what()).find('\n') == std::string::npos);
        }
    }
}

TEST_CASE("a picture that cannot be written leaves no file behind", "[scenes][images]") {
    const fs::path folder = scratch("folder.exr");
    fs::create_directories(folder / "inside");  // a folder cannot be replaced by a file
    CHECK_THROWS_AS(write_exr(folder, unique_valued_image()), ImageError);
    for (const auto& entry : fs::directory_iterator(folder.parent_path())) {
        CHECK(entry.path().filename().string().find(".folder") == std::string::npos);
    }
}

TEST_CASE("the sRGB transfer functions undo each other", "[scenes][images]") {
    for (float linear = 0.f; linear <= 1.f; linear += 1.f / 256.f) {
        CHECK(linear_from_srgb(srgb_from_linear(linear)) == Approx(linear).margin(1e-6));
    }
}

}  // namespace plumbline
