// SPDX-License-Identifier: Apache-2.0
// Renders that are interrupted, killed and resumed.
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "pathtracer/checkpoint.h"
#include "scenes/errors.h"
#include "tests/pathtracer/pictures.h"
#include "tests/pathtracer/scenes.h"
#include "tests/scenes/temporary_folder.h"

namespace plumbline::pathtracer {
namespace {

/// Renders with an interruption after every few tiles until it is done.
RenderResult render_in_pieces(const Scene& scene, const RenderOptions& options,
                              CheckpointOptions checkpoints, int tiles_a_piece, int& pieces) {
    for (pieces = 1;; ++pieces) {
        std::atomic<int> asked = 0;
        checkpoints.interrupted = [&] { return asked++ >= tiles_a_piece; };
        if (auto result = render(scene, 0, options, checkpoints)) return *std::move(result);
        REQUIRE(exists(checkpoints.file));
        checkpoints.resume = true;
        REQUIRE(pieces < 1000);
    }
}

/// Starts `plumbline render ARGS` in the background, silent.
pid_t start_render(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"plumbline", "render"});
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    const pid_t pid = ::fork();
    if (pid == 0) {
        const int nowhere = ::open("/dev/null", O_WRONLY);
        ::dup2(nowhere, STDERR_FILENO);
        ::execv(PLUMBLINE_BINARY, argv.data());
        ::_exit(127);
    }
    return pid;
}

/// Its exit code, or minus the signal that ended it.
int ended(pid_t pid) {
    int status = 0;
    REQUIRE(::waitpid(pid, &status, 0) == pid);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

void sleep_ms(int ms) { std::this_thread::sleep_for(std::chrono::milliseconds(ms)); }

}  // namespace

TEST_CASE("a render resumed in the midst of its passes gives the same bits", "[pathtracer]") {
    const Scene scene = test::mixed_room(45, 37);
    RenderOptions options{.seed = 2};
    SECTION("few samples") { options.spp = 20; }
    SECTION("batches and a rest") { options.spp = 72; }
    SECTION("until an error is reached") {
        options.spp = 1 << 20;
        options.target_relmse = .01;
    }
    SECTION("adaptive") {
        options.spp = 80;
        options.adaptive = true;
    }
    SECTION("adaptive until an error is reached") {
        options.spp = 1 << 20;
        options.target_relmse = .0008;
        options.adaptive = true;
    }
    SECTION("a shard") {
        options.spp = 48;
        options.shard = {2, 2};
    }
    const RenderResult whole = render(scene, 0, options);
    const TemporaryFolder folder;
    int pieces = 0;
    const RenderResult resumed =
        render_in_pieces(scene, options, {.file = folder / "o.checkpoint"}, 4, pieces);
    CHECK(pieces > 2);
    CHECK(test::same_pixels(resumed.image, whole.image));
    CHECK(resumed.rays == whole.rays);
    CHECK(resumed.spp == whole.spp);
    CHECK(resumed.relmse_estimate == whole.relmse_estimate);
    CHECK((whole.counts.fewest < whole.counts.most) == options.adaptive);
}

TEST_CASE("samples that are not finite are counted across interruptions", "[pathtracer]") {
    Scene scene = test::mixed_room(40, 20);
    scene.lights.front().intensity = Spectrum(std::numeric_limits<float>::infinity());
    const RenderOptions options{.spp = 32};
    const TemporaryFolder folder;
    int pieces = 0;
    const RenderResult resumed =
        render_in_pieces(scene, options, {.file = folder / "o.checkpoint"}, 3, pieces);
    const RenderResult whole = render(scene, 0, options);
    CHECK(pieces > 1);
    CHECK(whole.non_finite.samples > 0);
    CHECK(resumed.non_finite.samples == whole.non_finite.samples);
    CHECK(resumed.non_finite.first == whole.non_finite.first);
}

TEST_CASE("the time spent before an interruption counts", "[pathtracer]") {
    const Scene scene = test::mixed_room(32, 32);  // four tiles
    const RenderOptions options{.spp = 1 << 20, .seconds = 2.};
    const TemporaryFolder folder;
    std::atomic<int> asked = 0;
    CheckpointOptions checkpoints{.file = folder / "o.checkpoint",
                                  .interrupted = [&] { return asked++ >= 3; }};
    REQUIRE_FALSE(render(scene, 0, options, checkpoints));
    const Provenance provenance = provenance_of(scene, 0, options);
    Checkpoint checkpoint = read_checkpoint(checkpoints.file, provenance);
    CHECK(checkpoint.seconds > 0.);
    // As if it had been three seconds: the pass that was begun is finished, and no more.
    checkpoint.seconds = 3.;
    write_checkpoint(checkpoints.file, checkpoint, provenance);
    checkpoints.resume = true;
    checkpoints.interrupted = [] { return false; };
    const auto resumed = render(scene, 0, options, checkpoints);
    REQUIRE(resumed);
    CHECK(resumed->spp == Sampler::batch_size);
    CHECK(resumed->seconds > 3.);
}

TEST_CASE("a render goes on where its checkpoint cannot be written, unless it is interrupted",
          "[pathtracer]") {
    const Scene scene = test::mixed_room(32, 20);
    const RenderOptions options{.spp = 32};
    const TemporaryFolder folder;
    std::vector<std::string> told;
    CheckpointOptions nowhere{
        .file = std::filesystem::path(folder.write("file", "")) / "o.checkpoint",
        .every_seconds = 0.,
        .not_written = [&](const std::string& line) { told.push_back(line); }};
    const auto whole = render(scene, 0, options, nowhere);
    REQUIRE(whole);
    CHECK(test::same_pixels(whole->image, render(scene, 0, options).image));
    REQUIRE_FALSE(told.empty());
    CHECK_THAT(told.front(), Catch::Contains(nowhere.file.string()));
    // Nothing would be left of the work, so that it must not end as if it could be resumed.
    nowhere.interrupted = [] { return true; };
    CHECK_THROWS_AS(render(scene, 0, options, nowhere), ImageError);
}

TEST_CASE("a checkpoint of another render is refused with the reason", "[pathtracer]") {
    const Scene scene = test::mixed_room(32, 20);
    const TemporaryFolder folder;
    const CheckpointOptions stopped{.file = folder / "o.checkpoint",
                                    .interrupted = [] { return true; }};
    RenderOptions options{.spp = 40};
    REQUIRE_FALSE(render(scene, 0, options, stopped));
    CheckpointOptions resume{.file = stopped.file, .resume = true};
    const auto refused = [&](const Scene& other, const RenderOptions& other_options,
                             const std::string& reason) {
        CHECK_THROWS_WITH(render(other, 0, other_options, resume), Catch::Contains(reason));
    };
    refused(scene, {.spp = 40, .seed = 1}, "its seed is '0', not '1'");
    refused(scene, {.spp = 48}, "its options are");
    refused(scene, {.spp = 40, .max_bounces = 1}, "its options are");
    refused(scene, {.spp = 48, .adaptive = true}, "'max_bounces=unlimited adaptive spp=48'");
    refused(scene, {.spp = 40, .shard = {1, 2}}, "its shard is '1/1', not '1/2'");
    refused(test::mixed_room(20, 32), options, "its size is '32x20'");
    Scene other = scene;
    other.lights.front().position.x += .01f;
    refused(other, options, "the same name and another content");
    CHECK_THROWS_WITH(render(scene, 0, options, CheckpointOptions{.file = stopped.file}),
                      Catch::Contains("continue it with --resume, or delete it"));

    SECTION("cut short") { resize_file(stopped.file, file_size(stopped.file) - 1); }
    SECTION("a flipped byte") {
        std::fstream file(stopped.file, std::ios::in | std::ios::out | std::ios::binary);
        file.seekp(-1000, std::ios::end);
        file.put('x');
    }
    SECTION("a number of pixels that is not its size's") {
        std::fstream file(stopped.file, std::ios::in | std::ios::out | std::ios::binary);
        const std::string start(std::istreambuf_iterator<char>(file), {});
        const std::size_t digit = start.find("\"pixels\":") + std::string("\"pixels\":").size();
        file.seekp(static_cast<std::streamoff>(digit));
        file.put(start[digit] == '1' ? '2' : '1');
    }
    SECTION("something else") { folder.write("o.checkpoint", "PNG"); }
    refused(scene, options, "is not a whole checkpoint; delete it");
}

TEST_CASE("a render killed at random moments and resumed gives the same bits",
          "[pathtracer][commands]") {
    const TemporaryFolder folder;
    const auto command = [&](const std::string& name) {
        // Its pilot is even sampling.
        return std::vector<std::string>{
            "room-with-door",     "--size", "80x45",    "--spp",   "96", "--adaptive",
            "--checkpoint-every", "0.01",   "--resume", "--quiet", "-o", (folder / name).string()};
    };
    REQUIRE(ended(start_render(command("whole.exr"))) == 0);
    std::mt19937 random(3);
    int kills = 0;
    for (int attempt = 0;; ++attempt) {
        const pid_t pid = start_render(command("killed.exr"));
        // Longer and longer, so that a slow machine gets there too.
        sleep_ms(std::uniform_int_distribution(20, 60 + 20 * attempt)(random));
        ::kill(pid, SIGKILL);
        const int end = ended(pid);
        if (end == 0) break;
        REQUIRE(end == -SIGKILL);
        ++kills;
    }
    CHECK(kills > 2);
    CHECK(test::same_pixels(read_image(folder / "killed.exr"), read_image(folder / "whole.exr")));
    CHECK_FALSE(exists(folder / "killed.exr.checkpoint"));
    CHECK_FALSE(exists(folder / "killed.exr.checkpoint.new"));
}

TEST_CASE("an interrupt keeps all that is done and ends with 130", "[pathtracer][commands]") {
    const TemporaryFolder folder;
    const auto output = folder / "o.exr";
    const std::vector<std::string> command{"cornell-box", "--size", "64x36",
                                           "--spp",       "2048",   "--checkpoint-every",
                                           "0.05",        "-o",     output.string()};
    const pid_t pid = start_render(command);
    // Until it traces; before that an interrupt just ends it.
    while (!exists(folder / "o.exr.checkpoint")) sleep_ms(5);
    ::kill(pid, SIGINT);
    CHECK(ended(pid) == 130);
    CHECK_FALSE(exists(output));
    REQUIRE(exists(folder / "o.exr.checkpoint"));
    CHECK(ended(start_render(command)) == 2);
    std::vector<std::string> resume = command;
    resume.emplace_back("--resume");
    CHECK(ended(start_render(resume)) == 0);
    CHECK(exists(output));
    CHECK_FALSE(exists(folder / "o.exr.checkpoint"));
}

}  // namespace plumbline::pathtracer
