// SPDX-License-Identifier: Apache-2.0
// What the machine does to a writing command: killed, out of room, out of memory, not allowed. A
// reader finds the old file or the new one, never half of one.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <cstdlib>
#include <iterator>
#include <map>
#include <random>
#include <thread>

#include "tests/scenes/temporary_folder.h"

using namespace plumbline;

namespace {

using std::chrono::steady_clock;

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Runs a shell script in the folder; "$P" is the program.
struct Outcome {
    int status;
    std::string err;
};
Outcome shell(const TemporaryFolder& folder, const std::string& script) {
    const TemporaryFolder streams;
    const std::string command = "cd '" + folder.path().string() +
                                "'; P='" PLUMBLINE_BINARY "'; { " + script + "; } >/dev/null 2>'" +
                                (streams / "err").string() + "'";
    const int status = std::system(command.c_str());
    return {status, text_of(streams / "err")};
}

void check_refused(const TemporaryFolder& folder, const std::string& script,
                   const std::string& told) {
    const Outcome outcome = shell(folder, script);
    INFO(script << ": " << outcome.err);
    CHECK(WIFEXITED(outcome.status));
    CHECK(WEXITSTATUS(outcome.status) == 2);
    CHECK(outcome.err.find(told) != std::string::npos);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
}

/// The files below a folder by name, but for the hidden ones that a killed writer leaves.
std::map<std::string, std::string> finished_files(const std::filesystem::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (entry.is_regular_file() && name[0] != '.') files[name] = text_of(entry.path());
    }
    return files;
}

pid_t start(const TemporaryFolder& folder, const std::string& arguments) {
    const pid_t child = fork();
    if (child == 0) {
        const std::string command = "cd '" + folder.path().string() +
                                    "'; exec '" PLUMBLINE_BINARY "' " + arguments +
                                    " >/dev/null 2>&1";
        execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
        _exit(127);
    }
    return child;
}

constexpr const char* old_text = "what stood here before";

/// Kills the command at random moments of its run and looks at what it left.
void check_killed(const std::string& inputs, const std::string& arguments) {
    const TemporaryFolder folder;
    if (!inputs.empty()) REQUIRE(shell(folder, inputs).status == 0);
    const auto before = finished_files(folder.path());
    const auto begin = steady_clock::now();
    REQUIRE(shell(folder, "\"$P\" " + arguments).status == 0);
    const std::chrono::duration<double> whole = steady_clock::now() - begin;
    const auto complete = finished_files(folder.path());
    REQUIRE(complete.size() > before.size());
    constexpr unsigned seed = 7;
    std::mt19937 engine(seed);
    for (int i = 0; i < 12; ++i) {
        for (const auto& [name, text] : complete) {
            for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path())) {
                if (entry.path().filename() == name && !before.contains(name)) {
                    std::ofstream(entry.path(), std::ios::binary) << old_text;
                }
            }
        }
        const pid_t child = start(folder, arguments);
        std::this_thread::sleep_for(whole *
                                    std::uniform_real_distribution<double>(0., 1.1)(engine));
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        for (const auto& [name, text] : finished_files(folder.path())) {
            INFO(arguments << " killed, seed " << seed << ", time " << i << ": " << name);
            REQUIRE(complete.contains(name));
            // Headers tell how long a render took, so two whole pictures differ, but not in length
            // by more than those digits.
            const bool is_old = text == old_text;
            const auto length = double(complete.at(name).size());
            CHECK((is_old || std::abs(double(text.size()) - length) <= 64.));
        }
    }
}

}  // namespace

TEST_CASE("a killed export leaves the old file or the new one", "[bad-input][faults]") {
    check_killed("", "export cornell-box -o out.json");
    check_killed("", "export cornell-box -o out.gltf");
}

TEST_CASE("a killed render leaves the old picture or the new one", "[bad-input][faults]") {
    check_killed("", "ddgi furnace --size 64x36 --updates 1 -o out.exr");
    check_killed("", "render furnace --size 64x36 --spp 16 -o out.exr");
}

TEST_CASE("a killed comparison leaves old files or new ones", "[bad-input][faults]") {
    check_killed(
        "\"$P\" render furnace --size 64x36 --spp 16 -o a.exr; "
        "\"$P\" render furnace --size 64x36 --spp 16 --seed 1 -o b.exr",
        "compare a.exr b.exr -o maps");
}

TEST_CASE("a disk without room costs one line and keeps the old file", "[bad-input][faults]") {
    // A limit on the size of files fails a write as a full disk does.
    const std::string command =
        GENERATE("render furnace --size 64x36 --spp 1 --quiet -o out.exr",
                 "ddgi furnace --size 64x36 --updates 1 --quiet -o out.exr",
                 "export cornell-box -o out.json", "export cornell-box -o out.gltf");
    const TemporaryFolder folder;
    const std::string name = command.substr(command.rfind(' ') + 1);
    folder.write(name, old_text);
    check_refused(folder, "trap '' XFSZ; ulimit -f 1; \"$P\" " + command, "cannot be written");
    const std::map<std::string, std::string> expected{{name, old_text}};
    CHECK(finished_files(folder.path()) == expected);
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("a folder where nothing may be written costs one line", "[bad-input][faults]") {
    const std::string command =
        GENERATE("render furnace --size 8x8 --spp 1 --quiet -o ", "export furnace -o ",
                 "ddgi furnace --size 8x8 --updates 1 --quiet -o ");
    const std::string name = command.substr(0, 6) == "export" ? "out.json" : "out.exr";
    const TemporaryFolder folder;
    // Not even root may write there.
    check_refused(folder, "\"$P\" " + command + "/proc/" + name, "cannot be");
    // A file where the folder should be.
    folder.write("file", old_text);
    check_refused(folder, "\"$P\" " + command + "file/" + name, "cannot be");
    CHECK(text_of(folder / "file") == old_text);
}

TEST_CASE("too little memory costs one line", "[bad-input][faults]") {
#ifdef PLUMBLINE_SANITIZED
    WARN("left out: AddressSanitizer itself reserves terabytes of addresses");
    return;
#endif
    const TemporaryFolder folder;
    check_refused(folder,
                  "ulimit -v 2000000; \"$P\" render furnace --size 8000x8000 --spp 1 --threads 1 "
                  "--quiet -o out.exr",
                  "out of memory");
    CHECK(std::filesystem::is_empty(folder.path()));
}
