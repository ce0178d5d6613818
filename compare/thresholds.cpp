// SPDX-License-Identifier: Apache-2.0
#include "compare/thresholds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "scenes/errors.h"

namespace plumbline::compare {

namespace {

const std::set<std::string> may_be_negative = {"bias", "psnr_db", "ssim"};

std::string metric_names() {
    std::string names;
    for (const MetricDescription& metric : metric_descriptions())
        names += (names.empty() ? "" : ", ") + metric.name;
    return names;
}

}  // namespace

Threshold parse_threshold(const std::string& text) {
    const std::size_t equals = text.find('=');
    const std::string name = text.substr(0, equals);
    const auto& metrics = metric_descriptions();
    const auto found = std::find_if(metrics.begin(), metrics.end(),
                                    [&](const MetricDescription& m) { return m.name == name; });
    if (found == metrics.end())
        throw UsageError("--fail-above", fmt::format("no metric '{}'", name),
                         "the metrics are " + metric_names());
    const std::string value = equals == std::string::npos ? "" : text.substr(equals + 1);
    char* end = nullptr;
    const double limit = std::strtod(value.c_str(), &end);
    if (value.empty() || *end != '\0' || std::isnan(limit))
        throw UsageError("--fail-above", fmt::format("'{}' has no number", text),
                         fmt::format("write {}=0.01", name));
    if (std::isinf(limit) || (limit < 0. && !may_be_negative.contains(name)))
        throw UsageError("--fail-above", fmt::format("'{}' says the same of all images", text),
                         fmt::format("give a value that {} can take", name));
    return {*found, limit};
}

std::vector<std::string> exceeded(const std::vector<Threshold>& thresholds,
                                  const Metrics& metrics) {
    std::vector<std::string> lines;
    for (const auto& [metric, limit] : thresholds) {
        const std::optional<double> value = metric.value(metrics);
        if (!value)
            lines.push_back(
                fmt::format("{} is undefined, so not known to be below {:g}", metric.name, limit));
        else if (!(*value <= limit))
            lines.push_back(fmt::format("{} is {:.6g}, above {:g} by {:.6g}", metric.name, *value,
                                        limit, *value - limit));
    }
    return lines;
}

}  // namespace plumbline::compare
