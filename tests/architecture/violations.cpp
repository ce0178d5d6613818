// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <regex>
#include <string_view>

#include "tests/architecture/house_files.h"

namespace plumbline::house {

namespace {

constexpr std::string_view license_line = "SPDX-License-Identifier: Apache-2.0";

/// -Ofast implies -ffast-math, which implies the others.
constexpr std::array unsafe_options = {"-Ofast",
                                       "-ffast-math",
                                       "-ffinite-math-only",
                                       "-funsafe-math-optimizations",
                                       "-fassociative-math",
                                       "-freciprocal-math",
                                       "-fno-signed-zeros"};

bool has_comments(const File& file) {
    return file.is_code() || file.extension() == ".cmake" ||
           file.path.ends_with("CMakeLists.txt") || file.text.starts_with("#!");
}

}  // namespace

std::vector<std::string> layer_violations(const std::vector<File>& files) {
    static const std::regex include(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"])re");
    std::vector<std::string> violations;
    for (const File& file : files) {
        if (!file.is_code()) continue;
        const bool at_root = file.folder().empty();
        for (const std::string& line : file.lines()) {
            std::smatch match;
            if (!std::regex_search(line, match, include)) continue;
            const std::string header = match[2];
            const std::string layer = File{header, {}}.folder();
            if (!may_include.contains(layer)) {
                // The project's own headers are named from the root, so that this test sees them.
                if (match[1] == "\"")
                    violations.push_back(file.path + ": \"" + header +
                                         "\" has no folder of the house");
            } else if (at_root ? layer == "tests"
                               : !may_include.at(file.folder()).contains(layer)) {
                violations.push_back(file.path + ": may not include " + header);
            }
        }
    }
    return violations;
}

std::vector<std::string> form_violations(const std::vector<File>& files) {
    static const std::set<std::string> binary = {".png", ".jpg", ".exr", ".glb", ".bin"};
    static const std::set<std::string> other_cpp = {".cc", ".cxx", ".hpp", ".hh", ".c", ".inl"};
    std::vector<std::string> violations;
    for (const File& file : files) {
        const bool is_corpus = file.path.starts_with("tests/fuzz/corpus/");  // any bytes
        if (is_corpus || binary.contains(file.extension())) continue;
        if (other_cpp.contains(file.extension()))
            violations.push_back(file.path + ": C++ files end in .cpp or .h");
        if (has_comments(file)) {
            const std::size_t line = file.text.starts_with("#!") ? 1 : 0;
            const std::vector<std::string> lines = file.lines();
            const bool licensed =
                lines.size() > line && lines[line].find(license_line) != std::string::npos;
            if (!licensed) violations.push_back(file.path + ": has no SPDX line on top");
        }
        if (file.text.find('\r') != std::string::npos)
            violations.push_back(file.path + ": has carriage returns");
        if (!file.text.ends_with('\n') || file.text.ends_with("\n\n")) {
            violations.push_back(file.path + ": does not end in one newline");
        }
    }
    return violations;
}

std::set<std::string> sources_without_entry(const std::vector<File>& files,
                                            const std::string& readme) {
    static const std::regex citation(
        R"re(\[([A-Z][a-z]+(?: and [A-Z][a-z]+| et al\.)? [12][0-9]{3}[a-z]?)[^0-9a-z])re");
    std::set<std::string> sources;
    for (const File& file : files) {
        if (!file.is_code()) continue;
        const auto begin = std::sregex_iterator(file.text.begin(), file.text.end(), citation);
        for (auto match = begin; match != std::sregex_iterator(); ++match) {
            const std::string source = (*match)[1];
            if (readme.find("**[" + source + "]**") == std::string::npos) sources.insert(source);
        }
    }
    return sources;
}

std::vector<std::string> unrunnable_test_names(const std::vector<File>& files) {
    static const std::regex test_case(R"re(TEST_CASE\("([^"]*[\[\];][^"]*)")re");
    std::vector<std::string> names;
    for (const File& file : files) {
        if (!file.is_code()) continue;
        const std::sregex_iterator end;
        for (std::sregex_iterator it(file.text.begin(), file.text.end(), test_case); it != end;
             ++it) {
            names.push_back((*it)[1]);
        }
    }
    return names;
}

std::vector<std::string> unsafe_math_options(const std::string& text) {
    std::vector<std::string> found;
    std::ranges::copy_if(unsafe_options, std::back_inserter(found), [&](const char* option) {
        return text.find(option) != std::string::npos;
    });
    return found;
}

}  // namespace plumbline::house
