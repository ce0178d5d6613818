// SPDX-License-Identifier: Apache-2.0
#include "scenes/option_values.h"

#include <fmt/format.h>

#include <cmath>

#include "scenes/errors.h"
#include "scenes/nearest_name.h"

namespace plumbline {

void fail_choice(const std::string& option, const std::string& word,
                 const std::vector<std::string>& known) {
    throw UsageError(option, "there is no " + in_quotes(word), did_you_mean(word, known));
}

CLI::Validator above_zero() {
    return CLI::Validator(
        [](const std::string& text) {
            double value = 0.;
            const bool is_number = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
            return is_number && value > 0. ? std::string()
                                           : in_quotes(text) + " is not a finite number above 0";
        },
        "NUMBER > 0");
}

CLI::Validator from_to(double least, double most) {
    return CLI::Validator(
        [least, most](const std::string& text) {
            double value = 0.;
            // The negation also catches NaN.
            if (CLI::detail::lexical_cast(text, value) && !(value >= least && value <= most)) {
                return fmt::format("{} is not from {:g} to {:g}", in_quotes(text), least, most);
            }
            return std::string();
        },
        fmt::format("NUMBER {:g} to {:g}", least, most));
}

}  // namespace plumbline
