// SPDX-License-Identifier: Apache-2.0
#include "compare/fit_report.h"

#include <fmt/format.h>

namespace plumbline::compare {

using nlohmann::ordered_json;

namespace {

ordered_json scene_json(const FittedConstant& constant) {
    return constant.scene.empty() ? ordered_json(nullptr) : ordered_json(constant.scene);
}

std::string label(const FittedConstant& constant) {
    return constant.scene.empty() ? constant.name
                                  : fmt::format("{} ({})", constant.name, constant.scene);
}

std::string steps_text(const std::vector<Step>& steps) {
    std::string text = "\nround  iteration  cost          gradient      step\n";
    for (const Step& step : steps)
        text += fmt::format("{:>5}  {:>9}  {:<12.6g}  {:<12.4g}  {:<12.4g}\n", step.round,
                            step.iteration, step.cost, step.gradient, step.step);
    return text;
}

}  // namespace

ordered_json to_json(const std::vector<TransferError>& transfer) {
    ordered_json list = ordered_json::array();
    for (const TransferError& error : transfer)
        list.push_back({{"fitted_on", error.fitted_on},
                        {"tested_on", error.tested_on},
                        {"rmse", error.rmse},
                        {"fitted_frame", error.fitted_frame},
                        {"tested_frame", error.tested_frame}});
    return list;
}

ordered_json to_json(const FitResult& result) {
    // Infinity and NaN are dumped as null.
    ordered_json constants = ordered_json::array(), combinations = ordered_json::array();
    for (const FittedConstant& constant : result.constants)
        constants.push_back({{"name", constant.name},
                             {"value", constant.value},
                             {"standard_error", constant.standard_error},
                             {"identifiable", constant.identifiable},
                             {"scene", scene_json(constant)},
                             {"standard_error_covariance", constant.standard_error_covariance},
                             {"standard_error_bootstrap", constant.standard_error_bootstrap}});
    for (const KnownCombination& known : result.combinations)
        combinations.push_back({{"expression", known.expression},
                                {"value", known.value},
                                {"standard_error", known.standard_error}});
    ordered_json steps = ordered_json::array();
    for (const Step& step : result.steps)
        steps.push_back({{"round", step.round},
                         {"iteration", step.iteration},
                         {"cost", step.cost},
                         {"gradient", step.gradient},
                         {"step", step.step}});
    return {{"model", result.model},
            {"scenes", result.scenes},
            {"constants", constants},
            {"rmse_before", result.rmse_before},
            {"rmse_after", result.rmse_after},
            {"transfer", to_json(result.transfer)},
            {"combinations", combinations},
            {"gain", result.gain},
            {"gain_standard_error", result.gain_standard_error},
            {"rmse_gain", result.rmse_gain},
            {"reduced_chi_square", result.reduced_chi_square},
            {"misfit", result.misfit},
            {"notes", result.notes},
            {"converged", result.converged},
            {"steps", steps}};
}

std::string to_text(const FitResult& result) {
    std::string text =
        fmt::format("model {}, scenes {}\n\n", result.model, fmt::join(result.scenes, ", "));
    for (const FittedConstant& constant : result.constants)
        text +=
            fmt::format("{:<20} {:>10.6g} {}\n", label(constant), constant.value,
                        constant.identifiable ? fmt::format("+- {:.2g}", constant.standard_error)
                                              : "cannot be known alone");
    for (const std::string& note : result.notes) text += note + "\n";
    text += fmt::format(
        "\nRMSE of the {} layer\n"
        "{:>10.4g}  with {}\n"
        "{:>10.4g}  with the best gain on them, {:.4g} +- {:.2g}\n"
        "{:>10.4g}  as fitted, {}\n"
        "reduced chi-square {:.4g} (1: noise explains what is left); misfit {:.3g}\n",
        result.model == "thesis" ? "indirect" : "reference's", result.rmse_before,
        result.model == "thesis" ? "the published constants" : "gains of 1", result.rmse_gain,
        result.gain, result.gain_standard_error, result.rmse_after,
        result.converged ? "converged" : "NOT converged", result.reduced_chi_square, result.misfit);
    if (!result.transfer.empty()) text += "\nfitted on scene and frame -> tested on: RMSE\n";
    for (const TransferError& error : result.transfer)
        text += fmt::format("{} {} -> {} {}: {:.4g}\n", error.fitted_on, error.fitted_frame,
                            error.tested_on, error.tested_frame, error.rmse);
    return text + steps_text(result.steps);
}

}  // namespace plumbline::compare
