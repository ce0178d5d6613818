// SPDX-License-Identifier: Apache-2.0
#include "reports/verdict.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "reports/equal_error.h"
#include "reports/layer_statistics.h"
#include "reports/words.h"

namespace plumbline::reports {

namespace {

double rmse_of(const ModelRun& run) { return run.errors.indirect.comparison.metrics.rmse; }

std::string times_of(const ModelRun& run) {
    return fmt::format("{} a frame in motion, {} from empty probes",
                       duration_text(run.frame_ms / 1e3), duration_text(run.result.seconds));
}

/// "94 % bias and 6 % noise", with the interval; or that it cannot be told.
std::string split_words(const LayerError& error) {
    const std::optional<compare::NoiseSplit>& noise = error.comparison.noise;
    if (!noise || error.mse() == 0) return "how much of it is noise is not known";
    if (noise->bias_mse_ci95[0] <= 0) return "which noise alone would explain";
    return fmt::format("of its square {} is bias (95 % interval {} to {}) and {} noise",
                       percent_text(noise->bias_mse / error.mse()),
                       percent_text(noise->bias_mse_ci95[0] / error.mse()),
                       percent_text(noise->bias_mse_ci95[1] / error.mse()),
                       percent_text(noise->mse_expected_from_noise / error.mse()));
}

std::string model_sentence(const ModelRun& run) {
    const LayerError& error = run.errors.indirect;
    return fmt::format("{}: the indirect light is {} on average (mean ratio {}), RMSE {}, {}; {}.",
                       run.title, ratio_words(error.mean_ratio()), number_text(error.mean_ratio()),
                       number_text(rmse_of(run)), split_words(error), times_of(run));
}

std::string fit_sentence(const FitRun& fit) {
    const compare::FitResult& result = fit.result;
    return fmt::format(
        "Fitting the thesis's constants takes its RMSE from {} to {} in {}; scaling the published "
        "picture by its best gain of {} \u00b1 {} alone leaves {}.",
        number_text(result.rmse_before), number_text(result.rmse_after), duration_text(fit.seconds),
        number_text(result.gain), number_text(result.gain_standard_error),
        number_text(result.rmse_gain));
}

std::string path_tracer_sentence(const SceneReport& report, const ModelRun& best) {
    const std::optional<PathTracerLine> line = path_tracer_line(report);
    const std::optional<double> error = error_without_truth_noise(report, best.errors.indirect);
    if (!line || !error) return "";
    const double seconds = line->seconds_to(*error);
    return fmt::format(
        "The path tracer comes to the error of {} (RMSE {}) in {}{}: {} times as long as that "
        "model's frame in motion, {} times as long as it takes from empty probes.",
        best.title, number_text(*error), duration_text(seconds),
        line->extrapolates(seconds) ? ", extrapolated" : "",
        number_text(seconds / (best.frame_ms / 1e3)), number_text(seconds / best.result.seconds));
}

std::string truth_sentence(const SceneReport& report) {
    return fmt::format("The truth, {} samples a pixel in {}, has an RMSE of {} from its own noise.",
                       report.truth.spp, duration_text(report.truth.seconds),
                       number_text(layer_noise(report.truth.image, "indirect")));
}

std::string headline_of(const ModelRun& best) {
    const LayerError& error = best.errors.indirect;
    return fmt::format(
        "The model {} comes closest: its indirect light is {} on average, RMSE {} ({} of the "
        "mean), at {}.",
        best.title, ratio_words(error.mean_ratio()), number_text(rmse_of(best)),
        percent_text(rmse_of(best) / error.reference_mean), times_of(best));
}

}  // namespace

std::vector<std::string> Verdict::all() const {
    std::vector<std::string> texts{headline};
    texts.insert(texts.end(), sentences.begin(), sentences.end());
    return texts;
}

Verdict verdict_of(const SceneReport& report) {
    const auto best = std::min_element(
        report.models.begin(), report.models.end(),
        [](const ModelRun& a, const ModelRun& b) { return rmse_of(a) < rmse_of(b); });
    if (best == report.models.end()) return {nullptr, "No model was run.", {}};
    Verdict verdict{&*best, headline_of(*best), {}};
    for (const ModelRun& run : report.models) verdict.sentences.push_back(model_sentence(run));
    if (report.fit) verdict.sentences.push_back(fit_sentence(*report.fit));
    const std::string equal_error = path_tracer_sentence(report, *best);
    if (!equal_error.empty()) verdict.sentences.push_back(equal_error);
    verdict.sentences.push_back(truth_sentence(report));
    return verdict;
}

}  // namespace plumbline::reports
