// SPDX-License-Identifier: Apache-2.0
#include "tests/architecture/house_files.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <sstream>

namespace plumbline::house {

namespace fs = std::filesystem;

namespace {

const std::set<std::string> written_by_programs = {"build", "out"};

}  // namespace

std::string File::folder() const {
    const std::size_t slash = path.find('/');
    return slash == std::string::npos ? std::string() : path.substr(0, slash);
}

std::string File::extension() const { return fs::path(path).extension().string(); }

bool File::is_code() const { return extension() == ".cpp" || extension() == ".h"; }

std::vector<std::string> File::lines() const {
    std::vector<std::string> result;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) result.push_back(line);
    return result;
}

std::string output_of(const std::string& command) {
    int status = -1;
    std::string text;
    {
        const auto close = [&status](FILE* pipe) { status = pclose(pipe); };
        const std::unique_ptr<FILE, decltype(close)> pipe(popen(command.c_str(), "r"), close);
        if (!pipe) return {};
        std::array<char, 4096> block;
        for (std::size_t n = 0; (n = fread(block.data(), 1, block.size(), pipe.get())) > 0;) {
            text.append(block.data(), n);
        }
    }
    return status == 0 ? text : std::string();
}

File read_file(const fs::path& root, const std::string& path) {
    std::ifstream stream(root / path, std::ios::binary);
    return {path, {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()}};
}

std::vector<File> house_files(const fs::path& root) {
    std::vector<File> files;
    const auto read = [&](const fs::directory_entry& entry) {
        if (!entry.is_regular_file()) return;
        files.push_back(read_file(root, fs::relative(entry.path(), root).generic_string()));
    };
    for (const fs::directory_entry& entry : fs::directory_iterator(root)) {
        read(entry);
    }
    for (const auto& [folder, allowed] : may_include) {
        if (!fs::exists(root / folder)) continue;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
            read(entry);
        }
    }
    return files;
}

std::set<std::string> top_level_folders(const fs::path& root) {
    std::set<std::string> folders;
    std::istringstream kept(output_of("git -C '" + root.string() + "' ls-files 2>/dev/null"));
    for (std::string path; std::getline(kept, path);) folders.insert(File{path, {}}.folder());
    if (folders.empty()) {
        for (const fs::directory_entry& entry : fs::directory_iterator(root)) {
            const std::string name = entry.path().filename().string();
            if (entry.is_directory() && !written_by_programs.contains(name)) folders.insert(name);
        }
    }
    std::erase_if(folders, [](const std::string& name) { return name.empty() || name[0] == '.'; });
    return folders;
}

}  // namespace plumbline::house
