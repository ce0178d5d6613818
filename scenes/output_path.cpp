// SPDX-License-Identifier: Apache-2.0
#include "scenes/output_path.h"

#include <fmt/format.h>
#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "scenes/errors.h"

namespace plumbline {
namespace fs = std::filesystem;

namespace {

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// What stands against a new file in the folder, or in the nearest above it that exists.
std::error_code fault_of(fs::path folder) {
    std::error_code ignored;
    while (!fs::exists(folder, ignored) && folder != folder_of(folder)) folder = folder_of(folder);
    std::string name = (folder / ".plumbline-XXXXXX").string();
    const int file = ::mkstemp(name.data());
    if (file < 0) return {errno, std::generic_category()};
    ::close(file);
    ::unlink(name.c_str());
    return {};
}

}  // namespace

void check_output_file(const fs::path& file) {
    std::error_code fault = fault_of(folder_of(file));
    std::error_code ignored;
    if (fs::is_directory(file, ignored)) fault = std::make_error_code(std::errc::is_a_directory);
    if (!fault) return;
    throw ImageError(file.string(), "the file cannot be written: " + fault.message(),
                     "name a file that you may write to");
}

void check_output_picture(const std::string& file) {
    if (fs::path(file).extension() != ".exr")
        throw UsageError("--output", fmt::format("'{}' is not an EXR file", file),
                         "give a name that ends in .exr");
    check_output_file(file);
}

void check_output_folder(const fs::path& folder) {
    std::error_code ignored;
    if (fs::exists(folder, ignored) && !fs::is_directory(folder, ignored))
        throw UsageError("-o", fmt::format("'{}' is a file", folder.string()),
                         "give a folder, which need not exist yet");
    if (const std::error_code fault = fault_of(folder))
        throw ImageError(folder.string(), "its files cannot be written: " + fault.message(),
                         "name a folder that you may write to");
}

}  // namespace plumbline
