// SPDX-License-Identifier: Apache-2.0
#include "scenes/whole_file.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "scenes/errors.h"

namespace plumbline {
namespace fs = std::filesystem;

namespace {

/// A name beside `path` that no other process uses; keeps the extension, which writers go by.
fs::path temporary_beside(const fs::path& path) {
    return path.parent_path() /
           fmt::format(".{}.{}{}", path.stem().string(), ::getpid(), path.extension().string());
}

}  // namespace

void write_whole(const fs::path& path,
                 const std::function<void(const fs::path& temporary)>& write) {
    std::error_code error;
    if (path.has_parent_path()) fs::create_directories(path.parent_path(), error);
    if (error) {
        throw ImageError(path.parent_path().string(),
                         "the folder cannot be made: " + error.message(),
                         "name a folder that you may write to");
    }
    const fs::path temporary = temporary_beside(path);
    try {
        write(temporary);
    } catch (...) {
        fs::remove(temporary, error);
        throw;
    }
    fs::rename(temporary, path, error);
    if (error) {
        const std::string reason = error.message();
        fs::remove(temporary, error);
        throw ImageError(path.string(), "the file cannot be written: " + reason,
                         "name a file that you may write to");
    }
}

void write_text(const fs::path& path, std::string_view text) {
    write_whole(path, [&](const fs::path& temporary) {
        std::ofstream file(temporary, std::ios::binary);
        file.write(text.data(), static_cast<std::streamsize>(text.size()));
        file.close();
        if (!file) {
            throw ImageError(
                path.string(),
                "the file cannot be written: " + std::generic_category().message(errno),
                "check that the folder exists, may be written to, and has room");
        }
    });
}

}  // namespace plumbline
