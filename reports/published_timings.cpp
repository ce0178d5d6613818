// SPDX-License-Identifier: Apache-2.0
#include "reports/published_timings.h"

#include <sstream>

#include "reports/page_files.h"

namespace plumbline::reports {

namespace {

PublishedTiming timing_of(const std::string& line) {
    std::istringstream cells(line);
    const auto next = [&] {
        std::string cell;
        std::getline(cells, cell, ',');
        return cell;
    };
    // Braces evaluate from left to right.
    return {next(),
            std::stoi(next()),
            next(),
            std::stoi(next()),
            std::stoi(next()),
            std::stod(next()),
            std::stod(next()),
            std::stod(next()),
            std::stod(next())};
}

std::vector<PublishedTiming> read_timings() {
    std::istringstream lines{std::string(page_file("published_timings.csv"))};
    std::vector<PublishedTiming> timings;
    for (std::string line; std::getline(lines, line);)
        if (!line.empty() && line[0] != '#' && !line.starts_with("scene,"))
            timings.push_back(timing_of(line));
    return timings;
}

}  // namespace

const std::vector<PublishedTiming>& published_timings() {
    static const std::vector<PublishedTiming> timings = read_timings();
    return timings;
}

const PublishedTiming* published_timing(const std::string& scene, const std::string& configuration,
                                        int per_probe) {
    for (const PublishedTiming& timing : published_timings())
        if (timing.scene == scene && timing.configuration == configuration &&
            timing.per_probe == per_probe)
            return &timing;
    return nullptr;
}

std::optional<double> published_saving_percent(const std::string& scene) {
    const PublishedTiming* with = published_timing(scene, "full_gi", 64);
    const PublishedTiming* without = published_timing(scene, "no_surfels", 64);
    if (with == nullptr || without == nullptr) return std::nullopt;
    return 100 * (1 - with->probe_update_animated_ms / without->probe_update_animated_ms);
}

}  // namespace plumbline::reports
