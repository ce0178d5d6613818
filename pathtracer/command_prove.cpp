// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "pathtracer/commands.h"
#include "pathtracer/proof.h"
#include "pathtracer/statistics.h"
#include "scenes/command_line.h"
#include "scenes/progress.h"

namespace plumbline::pathtracer {
namespace {

struct ProveOptions {
    CommonOptions common;
    int spp = 16 * 1000;
    bool json = false;
};

/// The closed forms, measured; adds what fails to `failures`.
nlohmann::json prove_closed_forms(const ProveOptions& options, int& failures) {
    const std::vector<ClosedForm> forms = closed_forms();
    const double limit = sidak_limit(static_cast<int>(forms.size()));
    if (!options.json) {
        fmt::print("{:<58} {:>9} {:>9} {:>9} {:>6}  kernels\n", "closed form", "expected",
                   "measured", "error", "z");
    }
    nlohmann::json rows = nlohmann::json::array();
    for (const ClosedForm& form : forms) {
        const Measured found = measure(form, options.spp / 16);
        const bool holds = !(std::abs(found.z) > limit) && found.same_bits;
        failures += holds ? 0 : 1;
        rows.push_back({{"name", form.name},
                        {"formula", form.formula},
                        {"source", form.source},
                        {"expected", form.expected},
                        {"measured", found.radiance},
                        {"standard_error", found.standard_error},
                        {"z", found.z},
                        {"limit", limit},
                        {"kernels", found.kernels},
                        {"same_bits", found.same_bits},
                        {"holds", holds}});
        if (options.json) continue;
        fmt::print("{:<58} {:9.6f} {:9.6f} {:9.1e} {:6.2f}  {}{}\n", form.name, form.expected,
                   found.radiance, found.standard_error, found.z,
                   found.same_bits ? fmt::format("{} alike", found.kernels) : "differ",
                   holds ? "" : "  FAILS");
        fmt::print("    {}; {}\n", form.formula, form.source);
    }
    return rows;
}

nlohmann::json prove(const char* what, const std::vector<Finding>& findings, bool json,
                     int& failures) {
    if (!json) fmt::print("\n{:<58} {:>6} {:>6}\n", what, "z", "limit");
    nlohmann::json rows = nlohmann::json::array();
    for (const Finding& finding : findings) {
        failures += finding.holds() ? 0 : 1;
        rows.push_back({{"name", finding.name},
                        {"of", finding.of},
                        {"z", finding.z},
                        {"limit", finding.limit},
                        {"holds", finding.holds()}});
        if (json) continue;
        fmt::print("{:<58} {:6.2f} {:6.2f}{}\n    {}\n", finding.name, finding.z, finding.limit,
                   finding.holds() ? "" : "  FAILS", finding.of);
    }
    return rows;
}

void run(const ProveOptions& options) {
    const auto threads = options.common.apply();
    Progress::silence();
    int failures = 0;
    nlohmann::json found;
    found["closed_forms"] = prove_closed_forms(options, failures);
    found["agreements"] =
        prove("estimates that must agree in every pixel", agreements(), options.json, failures);
    found["distributions"] =
        prove("samplers against their densities", distributions(), options.json, failures);
    found["failures"] = failures;
    if (options.json) fmt::print("{}\n", found.dump(2));
    exit_code = failures == 0 ? 0 : 1;
}

}  // namespace

void add_prove_command(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "prove", "Closed forms and statistics that the path tracer must meet; exit 1 if not");
    const auto options = std::make_shared<ProveOptions>();
    add_common_options(command, options->common);
    command.add_option("--spp", options->spp, "Samples of each closed form (default: 16000)")
        ->check(CLI::Range(32, 1 << 24));
    command.add_flag("--json", options->json, "Findings as JSON on stdout");
    command.callback([options] { run(*options); });
}

}  // namespace plumbline::pathtracer
