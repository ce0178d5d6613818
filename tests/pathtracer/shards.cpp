// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>

#include "pathtracer/merge.h"
#include "pathtracer/render.h"
#include "scenes/errors.h"
#include "tests/pathtracer/pictures.h"
#include "tests/pathtracer/scenes.h"
#include "tests/scenes/temporary_folder.h"

namespace plumbline::pathtracer {
namespace {

using Files = std::vector<std::filesystem::path>;

/// Renders one shard and writes it.
std::filesystem::path write_shard(const TemporaryFolder& folder, const Scene& scene,
                                  const RenderOptions& options) {
    static int count = 0;
    const auto file = folder / ("shard-" + std::to_string(count++) + ".exr");
    write_exr(file, render(scene, 0, options).image);
    return file;
}

RenderOptions shard_options(int index, int count, int spp = 16) {
    return {.spp = spp, .seed = 5, .shard = {index, count}};
}

}  // namespace

TEST_CASE("the shards of a picture cover every tile once and are equally large", "[pathtracer]") {
    for (const auto& [width, height] : {std::pair(480, 270), {45, 37}, {16, 400}, {1, 1}}) {
        const Tiles tiles(width, height);
        for (const int count : {1, 2, 3, 7, 30}) {
            std::vector<int> all;
            std::size_t fewest = all.max_size(), most = 0;
            for (int index = 1; index <= count; ++index) {
                const std::vector<int> own = tiles.of({index, count});
                all.insert(all.end(), own.begin(), own.end());
                fewest = std::min(fewest, own.size());
                most = std::max(most, own.size());
            }
            std::sort(all.begin(), all.end());
            REQUIRE(all.size() == std::size_t(tiles.count()));
            for (int i = 0; i < tiles.count(); ++i) REQUIRE(all[std::size_t(i)] == i);
            CHECK(most - fewest <= 1);
        }
    }
}

TEST_CASE("merged shards have the bits of one render in any order", "[pathtracer]") {
    const int spp = GENERATE(1, 20, 40);
    const Scene scene = test::mixed_room(45, 37);
    const RenderResult one = render(scene, 0, {.spp = spp, .seed = 5});
    const TemporaryFolder folder;
    Files files;
    std::uint64_t rays = 0;
    for (int index = 1; index <= 3; ++index) {
        files.push_back(write_shard(folder, scene, shard_options(index, 3, spp)));
        rays += render(scene, 0, shard_options(index, 3, spp)).rays;
    }
    CHECK(rays == one.rays);
    do {
        const Image merged = merge(files);
        CHECK(test::same_pixels(merged, one.image));
        auto metadata = one.image.metadata;
        CHECK(std::stod(merged.metadata.at("plumbline:seconds")) > 0.);
        metadata["plumbline:seconds"] = merged.metadata.at("plumbline:seconds");
        CHECK(merged.metadata == metadata);
    } while (std::next_permutation(files.begin(), files.end()));
}

TEST_CASE("merge says why files do not make one picture", "[pathtracer]") {
    const Scene scene = test::mixed_room(32, 20);
    const TemporaryFolder folder;
    const auto first = write_shard(folder, scene, shard_options(1, 2));
    const auto refused = [](const Files& files, const std::string& reason) {
        CHECK_THROWS_WITH(merge(files), Catch::Contains(reason));
    };
    const auto refused_with = [&](const Scene& other_scene, const RenderOptions& options,
                                  const std::string& reason) {
        refused({first, write_shard(folder, other_scene, options)}, reason);
    };
    RenderOptions options = shard_options(2, 2);
    options.seed = 6;
    refused_with(scene, options, "its seed is '6', not '5'");
    refused_with(scene, shard_options(2, 2, 20), "its options are");
    refused_with(scene, shard_options(2, 3), "it is one of 3 shards, not of 2");
    refused_with(test::mixed_room(32, 21), shard_options(2, 2), "its size is '32x21'");
    Scene other = scene;
    other.name = "other room";
    refused_with(other, shard_options(2, 2), "its scene is 'other room'");
    other = scene;
    other.materials.front().albedo.r += .01f;
    refused_with(other, shard_options(2, 2), "the same name and another content");
    refused({first}, "of 2 shards these are missing: 2");
    refused({first, first}, "is shard 1/2, as is");
    const auto whole = write_shard(folder, scene, {.spp = 16, .seed = 5});
    refused({first, whole}, "is not a shard of a render");
}

TEST_CASE("a shard that could not be merged is not rendered", "[pathtracer]") {
    const Scene scene = test::mixed_room(32, 20);
    RenderOptions options = shard_options(2, 4);
    options.target_relmse = .1;
    CHECK_THROWS_WITH(render(scene, 0, options), Catch::Contains("equal samples a pixel"));
    CHECK_THROWS_WITH(render(scene, 0, shard_options(5, 5)),
                      Catch::Contains("5 shards of 4 tiles"));
}

}  // namespace plumbline::pathtracer
