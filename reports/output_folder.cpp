// SPDX-License-Identifier: Apache-2.0
#include "reports/output_folder.h"

#include "scenes/errors.h"
#include "scenes/whole_file.h"

namespace plumbline::reports {

namespace fs = std::filesystem;

void write_folder(const fs::path& folder, const FolderFiles& files) {
    const auto temporary = [&](const std::string& name) { return folder / (".new." + name); };
    const auto remove_temporaries = [&] {
        std::error_code ignored;
        for (const auto& [name, bytes] : files) fs::remove(temporary(name), ignored);
    };
    try {
        for (const auto& [name, bytes] : files) write_text(temporary(name), bytes);
    } catch (...) {
        remove_temporaries();
        throw;
    }
    try {
        for (const auto& [name, bytes] : files) fs::rename(temporary(name), folder / name);
    } catch (const fs::filesystem_error& error) {
        remove_temporaries();
        throw ImageError(error.path2().string(),
                         "the file cannot be written: " + error.code().message(),
                         "name a folder that you may write to");
    }
}

}  // namespace plumbline::reports
