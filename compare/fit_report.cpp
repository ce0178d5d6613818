// SPDX-License-Identifier: Apache-2.0
#include "compare/fit_report.h"

#include <fmt/format.h>

namespace plumbline::compare {

using nlohmann::ordered_json;

ordered_json to_json(const FitResult& result) {
    // Infinity and NaN are dumped as null.
    ordered_json constants = ordered_json::array(), combinations = ordered_json::array();
    for (const FittedConstant& constant : result.constants)
        constants.push_back({{"name", constant.name},
                             {"value", constant.value},
                             {"standard_error", constant.standard_error},
                             {"identifiable", constant.identifiable}});
    for (const KnownCombination& known : result.combinations)
        combinations.push_back({{"expression", known.expression},
                                {"value", known.value},
                                {"standard_error", known.standard_error}});
    ordered_json transfer = ordered_json::array();
    for (const TransferError& error : result.transfer)
        transfer.push_back(
            {{"fitted_on", error.fitted_on}, {"tested_on", error.tested_on}, {"rmse", error.rmse}});
    return {{"model", result.model},
            {"scenes", result.scenes},
            {"constants", constants},
            {"rmse_before", result.rmse_before},
            {"rmse_after", result.rmse_after},
            {"transfer", transfer},
            {"combinations", combinations},
            {"gain", result.gain},
            {"gain_standard_error", result.gain_standard_error},
            {"rmse_gain", result.rmse_gain},
            {"reduced_chi_square", result.reduced_chi_square},
            {"misfit", result.misfit},
            {"notes", result.notes}};
}

std::string to_text(const FitResult& result) {
    std::string text =
        fmt::format("model {}, scenes {}\n\n", result.model, fmt::join(result.scenes, ", "));
    for (const FittedConstant& constant : result.constants)
        text +=
            fmt::format("{:<18} {:>10.6g} {}\n", constant.name, constant.value,
                        constant.identifiable ? fmt::format("+- {:.2g}", constant.standard_error)
                                              : "cannot be known alone");
    for (const std::string& note : result.notes) text += note + "\n";
    text += fmt::format(
        "\nRMSE of the indirect layer\n"
        "{:>10.4g}  with the published constants\n"
        "{:>10.4g}  with the best gain on them, {:.4g} +- {:.2g}\n"
        "{:>10.4g}  with the fitted constants\n"
        "reduced chi-square {:.4g} (1: noise explains what is left); misfit {:.3g}\n",
        result.rmse_before, result.rmse_gain, result.gain, result.gain_standard_error,
        result.rmse_after, result.reduced_chi_square, result.misfit);
    if (!result.transfer.empty()) text += "\nfitted on -> tested on: RMSE\n";
    for (const TransferError& error : result.transfer)
        text += fmt::format("{} -> {}: {:.4g}\n", error.fitted_on, error.tested_on, error.rmse);
    return text;
}

}  // namespace plumbline::compare
