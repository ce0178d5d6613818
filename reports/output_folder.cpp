// SPDX-License-Identifier: Apache-2.0
#include "reports/output_folder.h"

#include <fmt/core.h>

#include "scenes/errors.h"
#include "scenes/whole_file.h"

namespace plumbline::reports {

namespace fs = std::filesystem;

void check_folder(const fs::path& folder) {
    if (fs::exists(folder) && !fs::is_directory(folder))
        throw UsageError("-o", fmt::format("'{}' is a file", folder.string()),
                         "give a folder, which need not exist yet");
}

void write_folder(const fs::path& folder, const FolderFiles& files) {
    const auto temporary = [&](const std::string& name) { return folder / (".new." + name); };
    try {
        for (const auto& [name, bytes] : files) write_text(temporary(name), bytes);
    } catch (...) {
        std::error_code ignored;
        for (const auto& [name, bytes] : files) fs::remove(temporary(name), ignored);
        throw;
    }
    for (const auto& [name, bytes] : files) fs::rename(temporary(name), folder / name);
}

}  // namespace plumbline::reports
