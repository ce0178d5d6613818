// SPDX-License-Identifier: Apache-2.0
#include "reports/page_files.h"

#include <span>
#include <stdexcept>

#include "scenes/embedded_files.h"

namespace plumbline {

std::span<const EmbeddedFile> embedded_reports_files();

}  // namespace plumbline

namespace plumbline::reports {

std::string_view page_file(std::string_view name) {
    for (const EmbeddedFile& file : embedded_reports_files())
        if (file.name == name) return file.text;
    throw std::logic_error("not embedded: " + std::string(name));
}

std::string page_style() {
    return std::string(page_file("style.css")) + std::string(page_file("viewer.css"));
}

}  // namespace plumbline::reports
