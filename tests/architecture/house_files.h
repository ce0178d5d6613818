// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace plumbline::house {

/// The folders, and those that each may include headers from: the layer order.
inline const std::map<std::string, std::set<std::string>> may_include = {
    {"scenes", {"scenes"}},
    {"pathtracer", {"scenes", "pathtracer"}},
    {"ddgi", {"scenes", "ddgi"}},
    {"compare", {"scenes", "ddgi", "compare"}},
    {"reports", {"scenes", "pathtracer", "ddgi", "compare", "reports"}},
    {"tests", {"scenes", "pathtracer", "ddgi", "compare", "reports", "tests"}},
};

/// A file of the project, by its path from the root with forward slashes, and its text.
struct File {
    std::string path;
    std::string text;

    /// The first part of the path; empty for a file at the root.
    std::string folder() const;
    /// With its dot: ".cpp".
    std::string extension() const;
    /// True for what is compiled as C++.
    bool is_code() const;
    std::vector<std::string> lines() const;
};

/// What a shell command prints on stdout; empty if it fails.
std::string output_of(const std::string& command);

/// The file `root`/`path`.
File read_file(const std::filesystem::path& root, const std::string& path);

/// Every file of the house's folders and of its root, read from `root`; not build/ and out/.
std::vector<File> house_files(const std::filesystem::path& root);

/// The folders at the root that git keeps; where git does not answer, those that are there but
/// build/ and out/. Names that begin with a dot are left out.
std::set<std::string> top_level_folders(const std::filesystem::path& root);

/// Lines "path: what breaks the layer order", one for each include that does.
std::vector<std::string> layer_violations(const std::vector<File>& files);

/// Lines "path: what is wrong with its first line, ending or line ends", one for each.
std::vector<std::string> form_violations(const std::vector<File>& files);

/// Sources cited in code as [Author Year] for which `readme` has no entry **[Author Year]**.
std::set<std::string> sources_without_entry(const std::vector<File>& files,
                                            const std::string& readme);

/// Names of test cases with a bracket or a semicolon, which CMake's lists join with the names after
/// them to one test that runs nothing.
std::vector<std::string> unrunnable_test_names(const std::vector<File>& files);

/// Compiler options in `text` that let the compiler forget NaN, infinities or the order of sums.
std::vector<std::string> unsafe_math_options(const std::string& text);

}  // namespace plumbline::house
