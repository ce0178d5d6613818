// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <exception>
#include <new>

#include "compare/commands.h"
#include "ddgi/commands.h"
#include "pathtracer/commands.h"
#include "reports/commands.h"
#include "scenes/command_line.h"
#include "scenes/commands.h"
#include "scenes/errors.h"

namespace {

constexpr int bad_input = 2;

int fail(const char* line) {
    // Not by fmt, which allocates: memory may be out. What cannot be said cannot be told of.
    static_cast<void>(std::fprintf(stderr, "plumbline: %s\n", line));
    return bad_input;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("How far a probe-based picture is from the truth, why, and what the rest costs.",
                 "plumbline");
    app.require_subcommand(1);
    app.set_version_flag("--version", PLUMBLINE_VERSION);
    plumbline::add_scenes_commands(app);
    plumbline::add_pathtracer_commands(app);
    plumbline::add_ddgi_commands(app);
    plumbline::add_compare_commands(app);
    plumbline::add_reports_commands(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
        return fail(plumbline::usage_line(app, error).c_str());
    } catch (const plumbline::InputError& error) {
        return fail(error.what());
    } catch (const std::bad_alloc&) {
        return fail("out of memory; a smaller --size or grid needs less");
    } catch (const std::exception& error) {
        return fail(error.what());
    }
    return plumbline::exit_code;
}
