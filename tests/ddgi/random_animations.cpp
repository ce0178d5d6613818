// SPDX-License-Identifier: Apache-2.0
// Whatever moves, and however: the cache shows, to the byte, what placing every surfel afresh each
// frame shows. The seed is Catch's own (--rng-seed; "time" for another each run).
#include <catch2/catch.hpp>
#include <cstring>
#include <random>

#include "ddgi/picture.h"
#include "ddgi/volume.h"
#include "tests/ddgi/small_scenes.h"

using namespace plumbline;
using namespace plumbline::ddgi;

namespace {

constexpr int frames = 1000;

class RandomMotion {
 public:
    explicit RandomMotion(unsigned seed) : engine_(seed) {}

    float number(float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(engine_);
    }
    bool one_in(int n) { return std::uniform_int_distribution<int>(1, n)(engine_) == 1; }
    glm::vec3 vec(float reach) {
        return {number(-reach, reach), number(-reach, reach), number(-reach, reach)};
    }

    /// Where an object is at each frame: it rests most of the time, else drifts, teleports, leaves
    /// the grid or stays on an axis where coordinates are equal.
    Track<glm::vec3> places() {
        glm::vec3 place = vec(.6f);
        glm::vec3 drift(0.f);
        return track<glm::vec3>([&] {
            if (one_in(20)) drift = one_in(2) ? glm::vec3(0.f) : vec(.05f);
            if (one_in(30)) place = vec(.7f);
            if (one_in(50)) place = vec(4.f);
            if (one_in(50)) place = glm::vec3(std::round(place.x), 0.f, 0.f);
            place += drift;
            return place;
        });
    }

    /// Its size: now and then nothing, at times mirrored, and uneven if `uneven`.
    Track<glm::vec3> sizes(bool uneven) {
        glm::vec3 size(1.f);
        return track<glm::vec3>([&] {
            if (one_in(30)) size = glm::vec3(number(.2f, 1.5f));
            if (one_in(40)) size = glm::vec3(0.f);
            if (one_in(60)) size.x = -size.x;
            if (uneven && one_in(40)) size *= glm::vec3(1.f, number(.1f, 2.f), 1.f);
            return size;
        });
    }

    Track<glm::quat> turns() {
        glm::quat turn(1.f, 0.f, 0.f, 0.f);
        return track<glm::quat>([&] {
            if (one_in(15)) turn = glm::normalize(glm::quat(number(-1.f, 1.f), vec(1.f)));
            return turn;
        });
    }

 private:
    template <typename T, typename Next>
    Track<T> track(const Next& next) {
        Track<T> result;
        result.interpolation = Interpolation::Step;
        for (int frame = 0; frame < frames; ++frame) {
            result.frames.push_back(float(frame));
            result.values.push_back(next());
        }
        return result;
    }

    std::mt19937 engine_;
};

/// A room in which a ball, a block and a leaf that hangs on the block move.
Scene restless_room(RandomMotion& motion) {
    Scene scene = room_with_moving_block();
    scene.objects.pop_back();
    const auto add = [&](const char* name, int parent, decltype(Object::shape) shape, bool uneven) {
        Object object;
        object.name = name;
        object.parent = parent;
        object.shape = std::move(shape);
        object.animation = {motion.places(), motion.turns(), motion.sizes(uneven)};
        scene.objects.push_back(object);
    };
    add("ball", -1, Sphere{glm::vec3(0.f), .3f, false, 1}, false);
    add("block", -1, Box{glm::vec3(-.2f), glm::vec3(.2f), {0, 1, 2, 3, 4, 5}}, true);
    const int block = int(scene.objects.size()) - 1;
    add("leaf", block, Quad{{0.f, .3f, 0.f}, {.3f, 0.f, 0.f}, {0.f, 0.f, .3f}, 2}, true);
    scene.camera.width = 6;
    scene.camera.height = 4;
    scene.probes = ProbeGrid{glm::vec3(-.9f), .9f, {3, 3, 3}};
    scene.frames = frames;
    return scene;
}

/// Lights have no tracks: whoever plays a scene moves them between frames.
void move_light(Scene& scene, RandomMotion& motion) {
    PointLight& light = scene.lights.front();
    if (motion.one_in(10)) light.position = motion.vec(.9f);
    if (motion.one_in(40)) light.position = motion.vec(3.f);
    if (motion.one_in(25)) light.white_radiance = Spectrum(motion.number(0.f, 2.f));
    if (motion.one_in(40)) light.white_radiance = Spectrum(0.f);
}

bool same_bytes(std::span<const float> a, std::span<const float> b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

Image picture(const ProbeVolume& volume, const DdgiOptions& options) {
    return take_picture(volume.tracer(), volume.model(), &volume,
                        picture_options(options, volume.model()))
        .image;
}

/// Plays all frames, some out of order, with the cache and without.
void check_random_animation(DdgiOptions options) {
    const unsigned seed = Catch::rngSeed();
    RandomMotion motion(seed);
    Scene scene = restless_room(motion);
    ProbeVolume with(scene, options);
    options.cache = false;
    ProbeVolume without(scene, options);
    std::uint64_t kept = 0;
    for (int step = 0; step < frames; ++step) {
        const int frame = motion.one_in(25) ? int(motion.number(0.f, float(frames))) : step;
        INFO(options.model << ", seed " << seed << ", step " << step << ", frame " << frame);
        move_light(scene, motion);
        for (ProbeVolume* volume : {&with, &without}) {
            volume->move_to(frame);
            volume->update();
        }
        REQUIRE(std::ranges::equal(with.cache().surfels().place, without.cache().surfels().place));
        REQUIRE(same_bytes(with.values(), without.values()));
        REQUIRE(ddgi::same_bytes(picture(with, options), picture(without, options)));
        kept += without.figures().replaced - with.figures().replaced;
    }
    // A cache that keeps nothing agrees too.
    CHECK(kept > 0);
}

/// Plays frames with a budget that is mostly spent, and at times lets all have their turn.
void check_random_budget(DdgiOptions options) {
    RandomMotion motion(Catch::rngSeed());
    Scene scene = restless_room(motion);
    options.budget = 40;
    ProbeVolume tight(scene, options);
    options.budget = std::nullopt;
    options.cache = false;
    ProbeVolume afresh(scene, options);
    std::uint64_t waited = 0;
    for (int frame = 0; frame < frames; ++frame) {
        INFO(options.model << ", seed " << Catch::rngSeed() << ", frame " << frame);
        move_light(scene, motion);
        tight.move_to(frame);
        tight.update();
        waited = std::max(waited, tight.figures().surfels_waiting);
        if (!motion.one_in(20)) continue;
        while (tight.figures().surfels_waiting > 0) tight.update();
        afresh.move_to(frame);
        REQUIRE(same_surfels(tight.cache().surfels(), afresh.cache().surfels()));
    }
    CHECK(waited > 40);
}

}  // namespace

TEST_CASE("a thousand random frames are the same bytes with the cache: conserving", "[ddgi]") {
    DdgiOptions options;
    options.surfels = 16;
    options.probes.storage = GENERATE(Storage::Rays, Storage::Octants);
    check_random_animation(options);
}

TEST_CASE("a thousand random frames are the same bytes with the cache: shared light", "[share]") {
    DdgiOptions options;
    options.surfels = 16;
    options.share = .4;
    check_random_animation(options);
}

TEST_CASE("a thousand random frames are the same bytes with the cache: thesis", "[ddgi]") {
    DdgiOptions options;
    options.model = "thesis";
    options.set["multiBounceIntensity"] = 1.;
    check_random_animation(options);
}

TEST_CASE("a thousand random frames are the same bytes with the cache: steps", "[ddgi]") {
    DdgiOptions options;
    options.model = "steps";
    options.set = {{"solidAngle", 1.}, {"firstSurface", 1.}, {"multiBounce", 1.}};
    check_random_animation(options);
}

TEST_CASE("whatever moved, once all had their turn no surfel tells of the budget", "[budget]") {
    DdgiOptions options;
    options.surfels = 16;
    SECTION("conserving") {}
    SECTION("conserving, shared light") { options.share = .4; }
    SECTION("thesis") {
        options.model = "thesis";
        options.surfels = 64;
    }
    check_random_budget(options);
}

TEST_CASE("a thousand random frames are the same bytes with the cache: irradiance", "[ddgi]") {
    DdgiOptions options;
    options.model = "irradiance";
    options.surfels = 16;
    check_random_animation(options);
}
