// SPDX-License-Identifier: Apache-2.0
#include "reports/frontier_sentences.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "reports/words.h"

namespace plumbline::reports {

namespace {

std::string law_sentence(const std::optional<ErrorLaw>& law) {
    if (!law)
        return "The path tracer's error did not fall with its time: it has too few pictures, or "
               "the truth's noise hides them.";
    const auto& [low, high] = law->law.exponent_ci95;
    const auto longer = [&](double share) { return std::pow(share, 1 / law->law.exponent); };
    return fmt::format(
        "The path tracer's error falls as its time to the power {:.3f} (95 % interval {:.3f} to "
        "{:.3f}; \u22120.5 if samples are independent): a tenth less error takes {} more time, "
        "half the error {} times the time.",
        law->law.exponent, low, high, percent_text(longer(.9) - 1), number_text(longer(.5)));
}

std::string times_words(double ratio) { return number_text(ratio) + " times"; }

/// The time of one more frame at a point's setting, if its probes are settled there.
std::optional<double> frame_seconds(const std::vector<TimedError>& frames,
                                    const TimedError& point) {
    for (const TimedError& frame : frames)
        if (frame.method == point.method && frame.setting == point.setting) return frame.seconds;
    return std::nullopt;
}

std::string floor_sentence(const TimedError& floor, const std::vector<TimedError>& frames,
                           const std::optional<ErrorLaw>& law) {
    const std::optional<double> frame = frame_seconds(frames, floor);
    std::string text = fmt::format(
        "{}: no setting measured leaves less than RMSE {} ({}), {} from nothing{}.", floor.method,
        number_text(floor.error), floor.setting, duration_text(floor.seconds),
        frame ? fmt::format(" and {} for each further frame", duration_text(*frame)) : "");
    if (!law) return text;
    const double seconds = law->seconds_to(floor.error);
    text += fmt::format(" The path tracer comes to that error in {}{}: {} the time of the still",
                        duration_text(seconds), law->extrapolates(seconds) ? ", extrapolated" : "",
                        times_words(seconds / floor.seconds));
    if (frame) text += fmt::format(", {} that of the frame", times_words(seconds / *frame));
    return text + ".";
}

std::string tenth_sentence(const ErrorFloor& floor, const std::optional<ErrorLaw>& law) {
    const TimedError& near = floor.tenth_above;
    const std::string& method = floor.floor.method;
    const std::string beyond =
        law ? fmt::format(" A tenth less than its least takes the path tracer, for {}.",
                          duration_text(law->seconds_to(.9 * floor.floor.error)))
            : "";
    if (near.setting == floor.floor.setting)
        return fmt::format("{}: nothing quicker comes within a tenth of its least error.{}", method,
                           beyond);
    return fmt::format(
        "{}: within a tenth of its least error after {} ({}, RMSE {}), so that the "
        "last tenth costs {} the time.{}",
        method, duration_text(near.seconds), near.setting, number_text(near.error),
        times_words(floor.floor.seconds / near.seconds), beyond);
}

std::string reign_words(const Reign& reign) {
    const std::string from = duration_text(reign.from_seconds);
    const std::string errors =
        reign.error_from == reign.error_until
            ? number_text(reign.error_from)
            : number_text(reign.error_from) + " to " + number_text(reign.error_until);
    if (!std::isfinite(reign.until_seconds))
        return fmt::format("{} from {} on (RMSE {} and less)", reign.method, from,
                           number_text(reign.error_from));
    return fmt::format("{} from {} to {} (RMSE {})", reign.method, from,
                       duration_text(reign.until_seconds), errors);
}

std::string budget_sentence(const std::string& budget, const std::vector<TimedError>& points,
                            const std::optional<ErrorLaw>& law) {
    std::string text;
    for (const Reign& reign : best_by_budget(points, law))
        text += (text.empty() ? "" : ", then ") + reign_words(reign);
    return fmt::format("Best within a budget for {}: {}.", budget, text);
}

std::string hidden_sentence(const Frontier& frontier) {
    const auto hidden =
        std::ranges::count_if(frontier.points, [](const auto& point) { return !point.error; });
    if (hidden == 0) return "";
    return fmt::format(
        "{} of {} pictures differ from the truth by no more than its own noise (RMSE {}) explains, "
        "and are left out: a truth with more samples would tell their error.",
        hidden, frontier.points.size(), number_text(frontier.truth_noise));
}

}  // namespace

std::vector<std::string> frontier_sentences(const Frontier& frontier) {
    const std::vector<TimedError> stills = timed_errors(frontier, Budget::Still);
    const std::vector<TimedError> frames = timed_errors(frontier, Budget::Frame);
    const std::optional<ErrorLaw> law = fit_error_law(stills, path_tracer_method);
    std::vector<std::string> sentences{law_sentence(law)};
    for (const ErrorFloor& floor : error_floors(stills)) {
        if (floor.floor.method == path_tracer_method) continue;
        sentences.push_back(floor_sentence(floor.floor, frames, law));
        sentences.push_back(tenth_sentence(floor, law));
    }
    if (!stills.empty()) sentences.push_back(budget_sentence("a still from nothing", stills, law));
    if (!frames.empty())
        sentences.push_back(budget_sentence("one more frame of an animation", frames, law));
    if (!frontier.without_thesis.empty())
        sentences.push_back(
            "Without thesis at the scene's own spacing: " + frontier.without_thesis + ".");
    if (const std::string hidden = hidden_sentence(frontier); !hidden.empty())
        sentences.push_back(hidden);
    return sentences;
}

}  // namespace plumbline::reports
