// SPDX-License-Identifier: Apache-2.0
#include "reports/results_markdown.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "reports/frontier_sentences.h"
#include "reports/pictures.h"
#include "reports/scene_sections.h"
#include "reports/shrink.h"
#include "reports/verdict.h"
#include "reports/words.h"

namespace plumbline::reports {

namespace {

/// Wider pictures are shown as means of blocks.
constexpr int widest_picture = 320;

/// A name as it can stand in a file's name.
std::string file_word(const std::string& name) {
    std::string word;
    for (const char c : name) word += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '-';
    return word;
}

std::string strip_name(const SceneReport& scene) {
    return fmt::format("results-{}.png", file_word(scene.name));
}

/// Text that stands in a table's cell, or a line.
std::string plain(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '|' || c == '<' || c == '`') escaped += '\\';
        escaped += c == '\n' ? ' ' : c;
    }
    return escaped;
}

std::string row(const std::vector<std::string>& cells) {
    std::string line = "|";
    for (const std::string& cell : cells) line += " " + cell + " |";
    return line + "\n";
}

std::string head(const std::vector<std::string>& cells) {
    return row(cells) + row(std::vector<std::string>(cells.size(), "---"));
}

std::string bullets(const std::vector<std::string>& texts) {
    std::string list;
    for (const std::string& text : texts) list += "- " + plain(text) + "\n";
    return list + "\n";
}

/// Mean ratio, RMSE, noise and bias of the indirect layer.
std::vector<std::string> error_cells(const LayerError& error) {
    std::vector<std::string> cells{number_text(error.mean_ratio()),
                                   number_text(error.comparison.metrics.rmse)};
    const std::optional<compare::NoiseSplit>& noise = error.comparison.noise;
    cells.push_back(noise ? number_text(noise->mse_expected_from_noise) : "unknown");
    cells.push_back(noise ? fmt::format("{} ({} to {})", number_text(noise->bias_mse),
                                        number_text(noise->bias_mse_ci95[0]),
                                        number_text(noise->bias_mse_ci95[1]))
                          : "unknown");
    return cells;
}

std::string pictures_table(const SceneReport& scene) {
    std::string text = head({"Picture", "mean ratio", "RMSE", "noise (MSE)", "bias\u00b2 (95 %)",
                             "a frame in motion", "from nothing", "command"});
    const auto add = [&](const std::string& title, const LayerError& error,
                         const std::string& frame, double seconds, const std::string& command) {
        std::vector<std::string> cells = error_cells(error);
        cells.insert(cells.begin(), plain(title));
        for (const std::string& cell : {frame, duration_text(seconds), "`" + command + "`"})
            cells.push_back(cell);
        text += row(cells);
    };
    for (const ModelRun& run : scene.models)
        add(run.title, run.errors.indirect, duration_text(run.frame_ms / 1e3), run.result.seconds,
            run.command);
    for (const PathTracerRun& run : scene.path_tracer)
        add(fmt::format("path tracer, {} spp", run.spp), run.errors.indirect,
            duration_text(run.seconds), run.seconds,
            fmt::format("plumbline render {} --frame {} --size {}x{} --spp {} --seed 1 -o out.exr",
                        shell_word(scene.argument), scene.frame, scene.truth.image.width(),
                        scene.truth.image.height(), run.spp));
    return text + "\n";
}

std::string constants_text(const compare::FitResult& fit) {
    std::string text = head({"Constant", "fitted", "standard error", "can it be known?"});
    for (const compare::FittedConstant& constant : fit.constants)
        text += row({"`" + constant.name + "`", number_text(constant.value),
                     std::isfinite(constant.standard_error) ? number_text(constant.standard_error)
                                                            : "unbounded",
                     constant.identifiable ? "yes" : "no, only together with others"});
    for (const compare::KnownCombination& known : fit.combinations)
        text += row({plain(known.expression), number_text(known.value),
                     number_text(known.standard_error), "yes"});
    return text + "\n" + bullets(fit.notes);
}

std::string table_text(const StudyTable& table) {
    std::string text = head(table.head);
    for (const std::vector<std::string>& cells : table.rows) text += row(cells);
    return text + "\n";
}

std::string section_text(const StudySection& section, const std::string& level) {
    std::string text = level + " " + plain(section.heading) + "\n\n";
    for (const std::string& paragraph : section.paragraphs) text += plain(paragraph) + "\n\n";
    for (const StudyTable& table : section.tables)
        text += plain(table.caption) + ":\n\n" + table_text(table);
    return text;
}

std::string scene_text(const SceneReport& scene) {
    const Verdict verdict = verdict_of(scene);
    std::string text =
        fmt::format("## {}, frame {}\n\n{}\n\n![{}: indirect light of the truth", plain(scene.name),
                    scene.frame, plain(verdict.headline), plain(scene.name));
    for (const ModelRun& run : scene.models) text += ", " + plain(run.title);
    text += fmt::format("]({})\n\n", strip_name(scene));
    text += bullets(verdict.sentences);
    text += fmt::format("Against `{}`, the indirect layer at {} x {}:\n\n", scene.truth_command,
                        scene.truth.image.width(), scene.truth.image.height());
    text += pictures_table(scene);
    if (scene.fit)
        text += fmt::format("### The thesis's constants (`plumbline fit {}`)\n\n",
                            shell_word(scene.argument)) +
                constants_text(scene.fit->result);
    if (scene.frontier)
        text += fmt::format(
                    "### What accuracy costs in time (`plumbline frontier {} --quick -o "
                    "out/frontier`)\n\n",
                    shell_word(scene.argument)) +
                bullets(frontier_sentences(*scene.frontier));
    if (scene.animation) text += section_text(animation_section(*scene.animation), "###");
    if (!scene.audits.empty()) text += section_text(audit_section(scene.audits), "###");
    return text;
}

/// The indirect light of the truth and of each model, side by side at one exposure.
std::string strip_png(const SceneReport& scene) {
    const int width = scene.truth.image.width();
    const int block = (width + widest_picture - 1) / widest_picture;
    std::vector<Image> pictures{shrunk(scene.truth.image, block)};
    for (const ModelRun& run : scene.models) pictures.push_back(shrunk(run.result.image, block));
    const auto row_bytes = std::size_t{3} * static_cast<std::size_t>(pictures[0].width());
    const auto height = static_cast<std::size_t>(pictures[0].height());
    std::vector<unsigned char> strip(row_bytes * pictures.size() * height);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const std::vector<unsigned char> rgb =
            display_bytes(pictures[i], "indirect", exposure_of(scene));
        for (std::size_t y = 0; y < height; ++y)
            std::copy_n(
                rgb.begin() + static_cast<std::ptrdiff_t>(y * row_bytes), row_bytes,
                strip.begin() + static_cast<std::ptrdiff_t>((y * pictures.size() + i) * row_bytes));
    }
    const std::vector<unsigned char> png = png_bytes(
        pictures[0].width() * static_cast<int>(pictures.size()), pictures[0].height(), strip);
    return {png.begin(), png.end()};
}

}  // namespace

std::string results_markdown(const Report& report) {
    std::string text = fmt::format(
        "# Results\n\nWritten by Plumbline {} on {}: {}, {} threads, {} quality.\n\n    {}\n\n"
        "All figures are of the indirect layer, the light that the probes carry. Noise is what the "
        "variances explain of the squared error; bias\u00b2 is the rest. Times are of one machine, "
        "with whatever else it was doing.\n\n",
        report.version, report.date, report.machine.cpu, report.machine.threads, report.quality,
        report.command);
    for (const SceneReport& scene : report.scenes) text += scene_text(scene);
    if (report.transfer) text += section_text(transfer_section(*report.transfer), "##");
    if (report.shared)
        text += "### One set of constants for all these scenes at once\n\n" +
                constants_text(*report.shared);
    if (!report.hard_cases.empty()) text += section_text(stress_section(report.hard_cases), "##");
    while (text.ends_with("\n\n")) text.pop_back();
    return text;
}

FolderFiles published_files(const Report& report, const std::string& file) {
    FolderFiles files{{file, results_markdown(report)}};
    for (const SceneReport& scene : report.scenes)
        files.emplace_back(strip_name(scene), strip_png(scene));
    return files;
}

}  // namespace plumbline::reports
