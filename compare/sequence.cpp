// SPDX-License-Identifier: Apache-2.0
#include "compare/sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "compare/comparison_json.h"
#include "scenes/errors.h"

namespace plumbline::compare {

namespace {

/// More digits than this are no frame number.
constexpr std::size_t most_digits = 9;

using Files = std::map<int, std::filesystem::path>;

/// What stands before and after the number.
struct Pattern {
    std::filesystem::path folder;
    std::string before, after;
    std::size_t digits;
};

Pattern parse(const std::string& text) {
    const std::filesystem::path path(text);
    const std::string name = path.filename().string();
    const std::size_t first = name.find('#'), past = name.find_first_not_of('#', first);
    Pattern pattern{path.parent_path(), name.substr(0, first),
                    past == std::string::npos ? "" : name.substr(past),
                    std::min(past, name.size()) - first};
    if (is_sequence(pattern.after) || is_sequence(pattern.folder.string()))
        throw UsageError(text, "more than one run of '#'", "mark the frame number only");
    return pattern;
}

/// The frame of a file name; none if it is not of the sequence.
std::optional<int> frame_of(const std::string& name, const Pattern& pattern) {
    const std::size_t around = pattern.before.size() + pattern.after.size();
    if (name.size() < around + pattern.digits || name.size() > around + most_digits ||
        !name.starts_with(pattern.before) || !name.ends_with(pattern.after))
        return std::nullopt;
    const std::string digits = name.substr(pattern.before.size(), name.size() - around);
    const bool padded = digits.size() == pattern.digits || digits[0] != '0';
    if (!padded || digits.find_first_not_of("0123456789") != std::string::npos) return std::nullopt;
    return std::stoi(digits);
}

Files files_of(const std::string& text) {
    const Pattern pattern = parse(text);
    const auto folder = pattern.folder.empty() ? std::filesystem::path(".") : pattern.folder;
    Files files;
    if (std::filesystem::is_directory(folder))
        for (const auto& entry : std::filesystem::directory_iterator(folder))
            if (const auto frame = frame_of(entry.path().filename().string(), pattern))
                files[*frame] = pattern.folder / entry.path().filename();
    if (files.empty())
        throw ImageError(text, "no file of this sequence",
                         "each # stands for a digit of the frame number");
    return files;
}

void require_frames(const Files& of, const Files& in, const std::string& pattern) {
    for (const auto& [frame, path] : of)
        if (!in.contains(frame))
            throw ImageError(pattern, fmt::format("no file for frame {}", frame),
                             fmt::format("{} has one: give both the same frames", path.string()));
}

/// A metric over the frames.
struct Summary {
    double mean = 0, largest = 0;
    int frame = 0;  ///< of the largest
    int frames = 0;
};

Summary summary_of(const std::vector<FrameError>& errors, const MetricDescription& metric) {
    Summary summary;
    for (const FrameError& error : errors) {
        const auto value = metric.value(error.metrics);
        if (!value) continue;
        if (summary.frames == 0 || *value > summary.largest) {
            summary.largest = *value;
            summary.frame = error.frame;
        }
        summary.mean += *value;
        ++summary.frames;
    }
    if (summary.frames > 0) summary.mean /= summary.frames;
    return summary;
}

std::string cell(const std::optional<double>& value) {
    return value ? fmt::format("{:.5g}", *value) : "-";
}

}  // namespace

bool is_sequence(const std::string& pattern) { return pattern.find('#') != std::string::npos; }

std::vector<FrameFiles> sequence_frames(const std::string& reference, const std::string& test) {
    if (is_sequence(reference) != is_sequence(test))
        throw UsageError(is_sequence(reference) ? test : reference,
                         "a single image beside a sequence",
                         "mark the digits of its frame number with #");
    const Files references = files_of(reference), tests = files_of(test);
    require_frames(references, tests, test);
    require_frames(tests, references, reference);
    std::vector<FrameFiles> frames;
    for (const auto& [frame, path] : references) frames.push_back({frame, path, tests.at(frame)});
    return frames;
}

nlohmann::ordered_json sequence_json(const std::vector<FrameError>& errors) {
    using nlohmann::ordered_json;
    ordered_json frames = ordered_json::array(), summary;
    for (const FrameError& error : errors)
        frames.push_back({{"frame", error.frame},
                          {"metrics", metrics_json(error.metrics)},
                          {"noise", noise_json(error.noise)},
                          {"non_finite", error.non_finite}});
    for (const MetricDescription& metric : metric_descriptions()) {
        const Summary over = summary_of(errors, metric);
        if (over.frames == 0)
            summary[metric.name] = nullptr;
        else
            summary[metric.name] = {
                {"mean", over.mean}, {"largest", over.largest}, {"largest_frame", over.frame}};
    }
    return {{"frames", frames}, {"over_frames", summary}};
}

std::string sequence_text(const std::vector<FrameError>& errors) {
    std::string text = fmt::format("{:>8}", "frame"), mean = "    mean", largest = " largest",
                at = "in frame";
    for (const MetricDescription& metric : metric_descriptions()) {
        const Summary over = summary_of(errors, metric);
        text += fmt::format(" {:>11}", metric.name);
        mean += fmt::format(" {:>11}", over.frames ? cell(over.mean) : "-");
        largest += fmt::format(" {:>11}", over.frames ? cell(over.largest) : "-");
        at += fmt::format(" {:>11}", over.frame);
    }
    text += "\n";
    for (const FrameError& error : errors) {
        text += fmt::format("{:>8}", error.frame);
        for (const MetricDescription& metric : metric_descriptions())
            text += fmt::format(" {:>11}", cell(metric.value(error.metrics)));
        text += "\n";
    }
    return text + mean + "\n" + largest + "\n" + at + "\n";
}

std::string sequence_csv(const std::vector<FrameError>& errors) {
    std::string text = "frame";
    for (const MetricDescription& metric : metric_descriptions()) text += "," + metric.name;
    text += ",mse_expected_from_noise,bias_mse,bias_mse_low,bias_mse_high,non_finite\n";
    for (const FrameError& error : errors) {
        text += fmt::format("{}", error.frame);
        for (const MetricDescription& metric : metric_descriptions()) {
            const auto value = metric.value(error.metrics);
            text += value ? fmt::format(",{:.9g}", *value) : ",";
        }
        if (error.noise)
            text += fmt::format(",{:.9g},{:.9g},{:.9g},{:.9g}",
                                error.noise->mse_expected_from_noise, error.noise->bias_mse,
                                error.noise->bias_mse_ci95[0], error.noise->bias_mse_ci95[1]);
        else
            text += ",,,,";
        text += fmt::format(",{}\n", error.non_finite);
    }
    return text;
}

}  // namespace plumbline::compare
