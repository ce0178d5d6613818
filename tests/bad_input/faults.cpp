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
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>
#include <thread>

#include "scenes/image.h"
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

/// The files below a folder by path, but for the hidden ones that a killed writer leaves.
std::map<std::string, std::string> finished_files(const std::filesystem::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (entry.is_regular_file() && name[0] != '.')
            files[entry.path().string()] = text_of(entry.path());
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

/// Lines of a CSV file, rows of the tables of a Markdown file.
std::size_t table_rows(const std::string& kind, const std::string& bytes) {
    std::istringstream lines(bytes);
    std::size_t rows = 0;
    for (std::string line; std::getline(lines, line);) rows += kind == ".csv" || line[0] == '|';
    return rows;
}

/// Whether a file of these bytes is all that its writer had to say, by what ends its format.
bool is_whole(const std::filesystem::path& path, const std::string& bytes,
              const std::string& complete) {
    const std::string kind = path.extension().string();
    if (kind == ".exr") return read_image(path).pixels() > 0;
    if (kind == ".json" || kind == ".gltf") return nlohmann::json::accept(bytes);
    if (kind == ".html") return bytes.ends_with("</html>\n");
    if (kind == ".png") return bytes.find("IEND") != std::string::npos;
    if (kind == ".bin") return bytes.size() == complete.size();
    // Figures differ between runs, and what sentences are worth saying of times; rows do not.
    return bytes.ends_with('\n') && table_rows(kind, bytes) == table_rows(kind, complete);
}

/// Waits until the child writes: until one of the hidden names appears that its files have while
/// they are not whole, or a result is no longer what stood there. The empty file that tells whether
/// the folder can be written to is neither. False if the child ended before.
bool wait_until_it_writes(const TemporaryFolder& folder, const std::vector<std::string>& results,
                          pid_t child) {
    const auto writes = [&] {
        std::error_code vanished;
        for (auto entry = std::filesystem::recursive_directory_iterator(folder.path(), vanished);
             entry != std::filesystem::recursive_directory_iterator(); entry.increment(vanished)) {
            const std::string name = entry->path().filename().string();
            if (name[0] == '.' && !name.starts_with(".plumbline-")) return true;
        }
        return std::any_of(results.begin(), results.end(), [](const std::string& path) {
            std::error_code missing;
            return std::filesystem::file_size(path, missing) != std::string(old_text).size();
        });
    };
    while (!writes()) {
        if (waitpid(child, nullptr, WNOHANG) != 0) return false;
    }
    return true;
}

/// Kills the command at random moments of its run, and while it writes, and looks at what it left.
void check_killed(const std::string& inputs, const std::string& arguments, int times = 6) {
    const TemporaryFolder folder;
    if (!inputs.empty()) REQUIRE(shell(folder, inputs).status == 0);
    const auto before = finished_files(folder.path());
    const auto begin = steady_clock::now();
    REQUIRE(shell(folder, "\"$P\" " + arguments).status == 0);
    const std::chrono::duration<double> whole = steady_clock::now() - begin;
    const auto complete = finished_files(folder.path());
    std::vector<std::string> results;
    for (const auto& [path, bytes] : complete) {
        if (!before.contains(path)) results.push_back(path);
    }
    REQUIRE(!results.empty());
    constexpr unsigned seed = 7;
    std::mt19937 engine(seed);
    for (int i = 0; i < times; ++i) {
        for (const std::string& path : results) {
            std::ofstream(path, std::ios::binary) << old_text;
        }
        const pid_t child = start(folder, arguments);
        bool runs = true;
        if (i % 2 == 0) {
            std::this_thread::sleep_for(whole *
                                        std::uniform_real_distribution<double>(0., 1.1)(engine));
        } else {
            runs = wait_until_it_writes(folder, results, child);
        }
        if (runs) {
            kill(child, SIGKILL);
            waitpid(child, nullptr, 0);
        }
        for (const auto& [path, bytes] : finished_files(folder.path())) {
            INFO(arguments << " killed, seed " << seed << ", time " << i << ": " << path);
            REQUIRE(complete.contains(path));
            CHECK((bytes == old_text || is_whole(path, bytes, complete.at(path))));
        }
    }
}

/// With more probes, as the thesis's model needs.
const std::string small_scene =
    "sed 's/2, 3, 4/4, 4, 4/' '" PLUMBLINE_SOURCE_DIR "/tests/bad_input/small.json' > s.json";

}  // namespace

TEST_CASE("a killed export leaves the old file or the new one", "[bad-input][faults]") {
    check_killed("", "export cornell-box -o out.json");
    check_killed("", "export cornell-box -o out.gltf");
}

TEST_CASE("a killed render leaves the old picture or the new one", "[bad-input][faults]") {
    check_killed("", "ddgi furnace --size 64x36 --updates 1 -o out.exr");
    check_killed("", "render furnace --size 64x36 --spp 16 -o out.exr");
    check_killed(
        "\"$P\" render furnace --size 64x36 --spp 16 --shard 1/2 -o a.exr; "
        "\"$P\" render furnace --size 64x36 --spp 16 --shard 2/2 -o b.exr",
        "merge a.exr b.exr --threads 1 --quiet -o out.exr");
}

TEST_CASE("a killed comparison leaves old files or new ones", "[bad-input][faults]") {
    const std::string pictures =
        "\"$P\" render furnace --size 64x36 --spp 16 -o a.0001.exr; "
        "\"$P\" render furnace --size 64x36 --spp 16 --seed 1 -o b.0001.exr";
    check_killed(pictures, "compare a.0001.exr b.0001.exr -o maps");
    check_killed(pictures, "compare 'a.####.exr' 'b.####.exr' -o maps");
}

TEST_CASE("a killed study leaves old files or new ones", "[bad-input][faults]") {
    const std::string study =
        GENERATE("ablation s.json --size 16x9 --only octants --quick -o out",
                 "budget s.json --size 16x9 --spp 32 --truths 2 -o out",
                 "cost s.json --spacings 1 --repeats 1 --size 16x9 -o out",
                 "pictures s.json --size 16x9 --shadow-rays 1 -o out",
                 "sequence s.json --size 16x9 --frames 10 -o out",
                 "frontier s.json --size 16x9 --quick --repeats 2 -o out",
                 "fit s.json --size 32x18 --spp 4 -o out", "stress --only needle -o out",
                 "report s.json --size 16x9 --quick --publish --results out/RESULTS.md -o out");
    check_killed(small_scene, study);
}

TEST_CASE("a killed measurement of leaks leaves old files or new ones", "[bad-input][faults]") {
    check_killed("", "leak --cells 0.1 --size 16x9 -o out", 2);
}

TEST_CASE("a disk without room costs one line and keeps the old file", "[bad-input][faults]") {
    // A limit on the size of files fails a write as a full disk does.
    const auto [command, name] = GENERATE(table<std::string, std::string>(
        {{"render furnace --size 64x36 --spp 1 --quiet -o out.exr", "out.exr"},
         {"ddgi furnace --size 64x36 --updates 1 --quiet -o out.exr", "out.exr"},
         {"export cornell-box -o out.json", "out.json"},
         {"export cornell-box -o out.gltf", "out.gltf"},
         {"stress --only needle -o .", "index.html"},
         {"pictures furnace --size 16x9 --shadow-rays 1 --model conserving -o .", "index.html"}}));
    const TemporaryFolder folder;
    folder.write(name, old_text);
    check_refused(folder, "trap '' XFSZ; ulimit -f 1; \"$P\" " + command, "cannot be written");
    const std::map<std::string, std::string> expected{{(folder / name).string(), old_text}};
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

TEST_CASE("a study that cannot be kept is refused before it is made", "[bad-input][faults]") {
    const auto [command, name] =
        GENERATE(table<std::string, std::string>({{"ablation furnace", ""},
                                                  {"budget furnace", ""},
                                                  {"cost furnace", ""},
                                                  {"leak", ""},
                                                  {"pictures", ""},
                                                  {"sequence furnace", ""},
                                                  {"frontier furnace", ""},
                                                  {"fit furnace", ""},
                                                  {"stress", ""},
                                                  {"report furnace", ""},
                                                  {"render furnace", ".exr"},
                                                  {"ddgi furnace", ".exr"},
                                                  {"merge none.exr", ".exr"},
                                                  {"export none.json", ".json"},
                                                  {"compare none.exr none.exr", ""}}));
    const TemporaryFolder folder;
    check_refused(folder, "\"$P\" " + command + " -o /proc/none/out" + name, "cannot be written");
    // A file where a folder should be, and a folder where a file should.
    if (name.empty()) folder.write("out", old_text);
    check_refused(folder, "mkdir -p out.exr out.json; \"$P\" " + command + " -o out" + name,
                  name.empty() ? "'out' is a file" : "cannot be written");
    CHECK(finished_files(folder.path()).size() == (name.empty() ? 1 : 0));
}

TEST_CASE("a folder that vanishes while a command works is made again", "[bad-input][faults]") {
    const auto [command, name] = GENERATE(table<std::string, std::string>(
        {{"render furnace --size 64x36 --time 1 --checkpoint-every .1 -o out/a/a.exr",
          "out/a/a.exr"},
         {"leak --cells 0.1 --size 16x9 -o out/a", "out/a/index.html"}}));
    const TemporaryFolder folder;
    REQUIRE(shell(folder, "mkdir -p out/a").status == 0);
    const pid_t child = start(folder, command);
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    std::filesystem::remove_all(folder / "out");
    int status = 0;
    waitpid(child, &status, 0);
    CHECK(status == 0);
    CHECK(std::filesystem::exists(folder / name));
}

TEST_CASE("a checkpoint that cannot be written is told, and the render goes on",
          "[bad-input][faults]") {
    const TemporaryFolder folder;
    const Outcome outcome =
        shell(folder,
              "mkdir out.exr.checkpoint.new; \"$P\" render furnace --size 64x36 --time .5 "
              "--checkpoint-every .1 -o out.exr");
    CHECK(outcome.status == 0);
    CHECK(outcome.err.find("the checkpoint cannot be written") != std::string::npos);
    CHECK(std::filesystem::exists(folder / "out.exr"));
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
